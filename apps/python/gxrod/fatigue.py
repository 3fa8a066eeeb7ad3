"""Fatigue of a value over time: cycles by rainflow counting, damage by Miner's rule, equivalent loads.

    cycles = gxrod.fatigue.rainflow(stress)                          range, mean and number of each
    gxrod.fatigue.damage(stress, gxrod.fatigue.SNCurve.eurocode(71e6))
    gxrod.fatigue.equivalent_range(moment, slope=4, cycles=600)      a damage-equivalent load
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from .errors import Error
from .typed import Array


class Cycles(NamedTuple):
    """Cycles of a series. `range` [n]: maximum less minimum of each. `mean` [n]: half their sum. `count` [n]: 1, or 0.5 for half a cycle."""

    range: Array
    mean: Array
    count: Array


def turning_points(values: ArrayLike) -> Array:
    """The values at which a series turns, with its first and its last one; repeated values count once."""
    series = np.asarray(values, float)
    if series.ndim != 1:
        raise Error(f"expected the values of one quantity over time, got an array of shape {series.shape}")
    if not np.isfinite(series).all():
        raise Error("the series has values that are not numbers; count the part before or after them")
    if len(series) == 0:
        return series
    series = series[np.concatenate(([True], np.diff(series) != 0))]
    rises = np.sign(np.diff(series))
    return series[np.concatenate(([True], rises[1:] != rises[:-1], [True]))] if len(series) > 1 else series


def rainflow(values: ArrayLike) -> Cycles:
    """Counts the cycles of a series by rainflow counting (ASTM E1049-85, 5.4.4), in the order in which they end.

    A range that contains the start of the series counts as half a cycle, and so does what is left at its end.
    """
    found: list[tuple[float, float, float]] = []
    stack: list[float] = []

    def count(a: float, b: float, number: float) -> None:
        found.append((abs(b - a), 0.5 * (a + b), number))

    for point in turning_points(values):
        stack.append(float(point))
        while len(stack) >= 3 and abs(stack[-1] - stack[-2]) >= abs(stack[-2] - stack[-3]):
            if len(stack) == 3:
                count(stack[0], stack[1], 0.5)
                del stack[0]
            else:
                count(stack[-3], stack[-2], 1.0)
                del stack[-3:-1]
    for a, b in zip(stack, stack[1:]):
        count(a, b, 0.5)
    return Cycles(*(np.array(found, float).reshape(-1, 3).T))


class SNCurve:
    """How many cycles of a range a detail endures: straight lines in logarithms, each N = cycles × (at/range)^slope.

    lines: (slope, cycles, at), the first for the largest ranges. A line holds down to the `at` of the next one, the last one to `limit`, below
    which nothing is damaged. factor: ranges are multiplied by it, as by a partial factor.
    """

    def __init__(self, lines: Sequence[tuple[float, float, float]], limit: float = 0.0, factor: float = 1.0) -> None:
        self.lines = [tuple(float(number) for number in line) for line in lines]
        self.limit, self.factor = float(limit), float(factor)
        if not self.lines or any(len(line) != 3 or min(line) <= 0 for line in self.lines):
            raise Error("expected lines (slope, cycles, at) of positive numbers")
        bounds = [at for _, _, at in self.lines[1:]] + [self.limit]
        if any(b < c for b, c in zip(bounds, bounds[1:])):
            raise Error(f"expected lines for smaller and smaller ranges, down to the limit, found {bounds}")
        self._bounds = bounds

    @classmethod
    def eurocode(cls, category: float, factor: float = 1.0) -> SNCurve:
        """The curve of a detail category for normal stresses (EN 1993-1-9, 7.1): the range at 2·10⁶ cycles, slope 3 to 5·10⁶, 5 to 10⁸, then no damage."""
        constant = category * (2 / 5) ** (1 / 3)
        return cls([(3, 2e6, category), (5, 5e6, constant)], limit=constant * (5 / 100) ** (1 / 5), factor=factor)

    def cycles(self, ranges: ArrayLike) -> Array:
        """The cycles that each range may be repeated; infinite at and below the limit."""
        wanted = self.factor * np.asarray(ranges, float)
        endured = np.full(wanted.shape, np.inf)
        above = np.inf
        for (slope, number, at), bound in zip(self.lines, self._bounds):
            here = (wanted <= above) & (wanted > bound)
            endured[here] = number * (at / wanted[here]) ** slope
            above = bound
        return endured


def damage(values: ArrayLike, curve: SNCurve, ultimate: float | None = None) -> float:
    """The damage of a series by Miner's rule, Σ count/N; a detail fails at about 1.

    ultimate: the ultimate stress; ranges then count as those without a mean that do the same damage (Goodman): range/(1 − |mean|/ultimate) where the
    mean is tension.
    """
    ranges, means, counts = rainflow(values)
    if ultimate is not None:
        tension = np.maximum(means, 0.0) / ultimate
        if (tension >= 1).any():
            raise Error(f"a mean of {means.max():.6g} reaches the ultimate stress {ultimate:.6g}")
        ranges = ranges / (1 - tension)
    return float(np.sum(counts / curve.cycles(ranges)))


def equivalent_range(values: ArrayLike, slope: float, cycles: float) -> float:
    """The range that, repeated `cycles` times, does the damage of a series: (Σ count range^slope/cycles)^(1/slope). slope: of the S–N curve, 3 to 5
    for steel, about 10 for composites; cycles: as many as seconds, for loads at 1 Hz."""
    found = rainflow(values)
    return float((np.sum(found.count * found.range**slope) / cycles) ** (1 / slope))
