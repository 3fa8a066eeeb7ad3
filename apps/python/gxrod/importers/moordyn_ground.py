"""The ground of MoorDyn by a file: heights on a grid, or depths in the form of MoorPy and MoorDyn-F."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ..typed import Array
from .text import Lines


def read_ground(path: Path) -> Array:
    """x, y, z of a full grid, [n,3]."""
    lines = Lines(path)
    return read_depths(lines) if lines.find(lambda line: line.split()[:1] == ["nGridX"]) else read_heights(lines)


def read_heights(lines: Lines) -> Array:
    """SeafloorFile of MoorDyn: how many x and y, these, and a line `x y z` for each point."""
    counts = [int(count) for count in lines.numbers(2, "how many x and how many y")]
    x, y = (lines.numbers(count, f"the places {name} of the grid", exact=True) for name, count in zip("xy", counts))
    heights = np.full((counts[0], counts[1]), np.nan)
    while not lines.is_over:
        if not lines[lines.at].strip():
            lines.at += 1
            continue
        at = lines.numbers(3, "x, y and z of a point of the ground", exact=True)
        heights[nearest(x, at[0]), nearest(y, at[1])] = at[2]
    return on_grid(lines, x, y, heights)


def read_depths(lines: Lines) -> Array:
    """MoorPy's form: nGridX, nGridY, a line of x, and lines of y with the depths there, downwards."""
    count = int(lines.numbers_after("nGridX")[0])
    rows_count = int(lines.numbers_after("nGridY")[0])
    x = lines.numbers(count, "the places x of the grid", exact=True)
    rows = np.array([lines.numbers(count + 1, "a place y of the grid and the depths there", exact=True) for _ in range(rows_count)])
    return on_grid(lines, x, rows[:, 0].tolist(), -rows[:, 1:].T)


def nearest(places: list[float], at: float) -> int:
    return int(np.argmin(np.abs(np.array(places) - at)))


def on_grid(lines: Lines, x: list[float], y: list[float], heights: Array) -> Array:
    if min(len(x), len(y)) < 2:
        raise lines.fault(f"the grid of the ground has {len(x)} x and {len(y)} y; expected two or more of each", "give a grid", 0)
    for name, places in (("x", x), ("y", y)):
        if np.any(np.diff(places) <= 0.0):
            raise lines.fault(f"the places {name} of the grid do not increase", "sort them", 0)
    if np.any(np.isnan(heights)):
        i, j = np.argwhere(np.isnan(heights))[0]
        raise lines.fault(f"there is no height at x = {x[i]:g}, y = {y[j]:g}", "give one for each point of the grid", 0)
    return np.array([(x[i], y[j], heights[i, j]) for i in range(len(x)) for j in range(len(y))])
