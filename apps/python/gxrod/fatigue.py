"""Fatigue of a value over time: cycles by rainflow counting, damage by Miner's rule, equivalent loads.

    cycles = gxrod.fatigue.rainflow(stress)                          range, mean and number of each
    gxrod.fatigue.damage(stress, gxrod.fatigue.SNCurve.eurocode(71e6))
    gxrod.fatigue.equivalent_range(moment, slope=4, cycles=600)      a damage-equivalent load
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from .errors import Error
from .typed import Array

Row: TypeAlias = tuple[float, float, float]  # range, mean, count of cycles


class Cycles(NamedTuple):
    """Cycles of a series. `range` [n]: maximum less minimum of each. `mean` [n]: half their sum. `count` [n]: 1, or 0.5 for half a cycle."""

    range: Array
    mean: Array
    count: Array


def rainflow(values: ArrayLike) -> Cycles:
    """Counts the cycles of a series by rainflow counting (ASTM E1049-85, 5.4.4), in the order in which they end.

    A range that contains the start of the series counts as half a cycle, and so does what is left at its end. Repeated values count once.
    """
    return Cycles(*np.array(_count(values), float).reshape(-1, 3).T)


def _count(values: ArrayLike) -> list[Row]:
    series = np.asarray(values, float)
    if series.ndim != 1:
        raise Error(f"expected the values of one quantity over time, got an array of shape {series.shape}")
    if not np.isfinite(series).all():
        raise Error("the series has values that are not numbers; count the part before or after them")
    return _core.rainflow(series.tolist())


class SNCurve:
    """How many cycles of a range a detail endures: straight lines in logarithms, each N = cycles × (at/range)^slope.

    lines: (slope, cycles, at), the first for the largest ranges. A line holds down to the `at` of the next one, the last one to `limit`, below
    which nothing is damaged. factor: ranges are multiplied by it, as by a partial factor.
    """

    def __init__(self, lines: Sequence[tuple[float, float, float]], limit: float = 0.0, factor: float = 1.0) -> None:
        self.lines = [tuple(float(number) for number in line) for line in lines]
        self.limit, self.factor = float(limit), float(factor)
        if any(len(line) != 3 for line in self.lines):
            raise Error("expected lines (slope, cycles, at) of positive numbers")
        if fault := self._made().find_fault():
            raise Error(fault)

    def _made(self) -> _core.SNCurve:
        return _core.make_curve(self.lines, self.limit, self.factor)

    @classmethod
    def eurocode(cls, category: float, factor: float = 1.0) -> SNCurve:
        """The curve of a detail category for normal stresses (EN 1993-1-9, 7.1): the range at 2·10⁶ cycles, slope 3 to 5·10⁶, 5 to 10⁸, then no damage."""
        lines, limit = _core.list_eurocode_lines(category)
        return cls(lines, limit, factor)

    def cycles(self, ranges: ArrayLike) -> Array:
        """The cycles that each range may be repeated; infinite at and below the limit."""
        given = np.asarray(ranges, float)
        curve = self._made()
        return np.array([curve.endured_cycles(each) for each in given.ravel().tolist()]).reshape(given.shape)


def damage(values: ArrayLike, curve: SNCurve, ultimate: float | None = None) -> float:
    """The damage of a series by Miner's rule, Σ count/N; a detail fails at about 1.

    values: of one place, with a sign, such as a component of `stress` of a history with `point`; a von Mises stress has half the range of a stress that
    changes its sign. ultimate: the ultimate stress; ranges then count as those without a mean that do the same damage (Goodman): range/(1 − |mean|/ultimate) where the
    mean is tension.
    """
    cycles = _count(values)
    found = _core.compute_damage(cycles, curve._made(), 0.0 if ultimate is None else ultimate)
    if found == np.inf:
        raise Error(f"a mean of {max(mean for _, mean, _ in cycles):.6g} reaches the ultimate stress {ultimate:.6g}")
    return found


def equivalent_range(values: ArrayLike, slope: float, cycles: float) -> float:
    """The range that, repeated `cycles` times, does the damage of a series: (Σ count range^slope/cycles)^(1/slope). slope: of the S–N curve, 3 to 5
    for steel, about 10 for composites; cycles: as many as seconds, for loads at 1 Hz."""
    return _core.compute_equivalent_range(_count(values), slope, cycles)
