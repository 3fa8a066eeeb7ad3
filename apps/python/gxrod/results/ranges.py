"""Ranges over a window of time: of a quantity along a rod, and of what acts at the ends of lines."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import UnknownNameError, unknown_name
from ..typed import Array
from .display import Shown
from .frames import Rod
from .records import History
from .source import Source
from .stages import read_stages
from .tables import Table

COMPONENTS = {"x": 0, "y": 1, "z": 2}
END_QUANTITIES = ("effective_tension", "wall_tension", "shear_force", "bending_moment")  # of the histories of an end
GROUND_QUANTITIES = ("touch_down_start", "touch_down_end")  # of the history of a rod
LEVEL = 1e-9  # of an axis of length 1: below, it is upright and has no azimuth


def choose_window(source: Source, start: float | None, end: float | None, stage: str | None) -> tuple[float, float]:
    """From when until when: a stage, or times; without any, all stages with time, else all there is."""
    times = source.times
    first, last = (float(times[0]), float(times[-1])) if len(times) else (0.0, 0.0)
    if stage is not None:
        stages = read_stages(source)
        if stage not in stages:
            raise unknown_name("stage", stage, list(stages))
        rows = stages[stage].rows
        if rows.stop <= rows.start:
            raise ValueError(f"stage {stage} takes no steps")
        first, last = float(times[max(rows.start - 1, 0)]), float(times[rows.stop - 1])
    elif source.time_name == "time" and first < 0.0 < last:
        first = 0.0
    return first if start is None else start, last if end is None else end


def rows_within(times: Array, window: tuple[float, float]) -> Array:
    """Numbers of the rows in the window; ValueError without one."""
    slack = 1e-9 * (abs(window[0]) + abs(window[1]))
    rows = np.flatnonzero((times >= window[0] - slack) & (times <= window[1] + slack))
    if not len(rows):
        raise ValueError(f"nothing was written from {window[0]:g} to {window[1]:g}")
    return rows


@dataclass(repr=False)
class Range(Shown):
    """The least, largest and mean value of a quantity at each place along a rod, over the frames of a window of time.

    `arc_length`, `least`, `largest`, `mean`, `time_of_least`, `time_of_largest` [n]: at nodes or middles of elements, as the
    quantity has it. `window`: its first and last time.
    """

    rod: str
    quantity: str
    unit: str
    window: tuple[float, float]
    frames: int
    arc_length: Array
    least: Array
    largest: Array
    mean: Array
    time_of_least: Array
    time_of_largest: Array

    def _headline(self):
        return (f"{self.quantity} of rod {self.rod}, {self.frames} frames from {self.window[0]:g} to {self.window[1]:g}: "
                f"{np.nanmin(self.least):.6g} to {np.nanmax(self.largest):.6g} {self.unit}").rstrip()


def find_range(rod: Rod, quantity: str, start: float | None, end: float | None, stage: str | None) -> Range:
    source = rod._source
    name, _, component = quantity.partition("/")
    if component and component not in COMPONENTS:
        raise UnknownNameError(f"there is no component {component!r}; there are x, y and z")
    window = choose_window(source, start, end, stage)
    times = source.frame_times
    rows = rows_within(times, window)
    values = rod.read(name, slice(int(rows[0]), int(rows[-1]) + 1))
    if values.ndim == 3:
        values = values[..., COMPONENTS[component]] if component else np.linalg.norm(values, axis=-1)
    times = times[rows]
    what = rod.describe(name)
    s = rod.arc_length if values.shape[1] == len(rod.arc_length) else rod.cell_arc_length
    known = ~np.isnan(values)  # frames before a resumed run wrote the quantity are NaN
    least, largest = np.where(known, values, np.inf).argmin(axis=0), np.where(known, values, -np.inf).argmax(axis=0)
    places = np.arange(values.shape[1])
    with np.errstate(invalid="ignore"):
        mean = np.where(known, values, 0.0).sum(axis=0) / known.sum(axis=0)
    return Range(rod.name, quantity, what.unit or what.dimension, (float(times[0]), float(times[-1])), len(rows), s,
                 values[least, places], values[largest, places], mean, times[least], times[largest])


def end_angles(axis: Array) -> dict[str, Array]:
    """Declination and azimuth of axes [S,3] in degrees: from the global z axis, and from x towards y, within half a turn of the first; NaN if upright."""
    level = np.hypot(axis[:, 0], axis[:, 1])
    azimuth = np.where(level > LEVEL, np.degrees(np.arctan2(axis[:, 1], axis[:, 0])), np.nan)
    first = next(iter(azimuth[np.isfinite(azimuth)]), 0.0)
    return {"declination": np.degrees(np.arctan2(level, axis[:, 2])), "azimuth": azimuth - 360.0 * np.round((azimuth - first) / 360.0)}


def is_line_end(history: History) -> bool:
    return history.at.rpartition(".")[2] in ("start", "end") and {"axis_x", "effective_tension"} <= set(history.names)


def is_touch_down(history: History) -> bool:
    return set(GROUND_QUANTITIES) <= set(history.names)


def line_end_rows(source: Source, histories: dict[str, History], start: float | None, end: float | None, stage: str | None) -> Table:
    times = source.times
    window = choose_window(source, start, end, stage)
    rows = rows_within(times, window)
    settled = np.flatnonzero(times <= 0.0) if source.time_name == "time" else [len(times) - 1]
    columns: dict[str, list[Any]] = {key: [] for key in ("name", "quantity", "unit", "static", "least", "time_of_least", "largest", "time_of_largest", "mean")}

    def add(at, quantity, unit, values):
        own = values[rows]
        known = np.isfinite(own).any()
        low, high = (int(np.nanargmin(own)), int(np.nanargmax(own))) if known else (0, 0)
        row = (at, quantity, unit, values[settled[-1]] if len(settled) else np.nan, own[low], times[rows[low]] if known else np.nan, own[high],
               times[rows[high]] if known else np.nan, np.nanmean(own) if known else np.nan)
        for key, value in zip(columns, row):
            columns[key].append(value)

    def place(history):
        rod, _, end = history.at.rpartition(".")
        return (history.at, 2) if is_touch_down(history) else (rod, int(end == "end"))

    for history in sorted(filter(lambda one: is_line_end(one) or is_touch_down(one), histories.values()), key=place):
        for quantity in GROUND_QUANTITIES if is_touch_down(history) else END_QUANTITIES:
            if quantity in history.names:
                what = history.describe(quantity)
                add(history.at, quantity, what.unit or what.dimension, history[quantity])
        if is_line_end(history):
            for quantity, values in end_angles(history["axis_x"]).items():
                add(history.at, quantity, "deg", values)
    return Table("line ends", {key: np.array(values) for key, values in columns.items()} if columns["name"] else {})
