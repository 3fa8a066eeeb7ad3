"""The reference curve of a blade as gxrod lays it: a line, or the natural cubic spline through points over the length of the chords."""

from __future__ import annotations

import numpy as np

from ..typed import Array

SAMPLES = 64  # of each piece, for lengths and for axes that are carried along


class Curve:
    """Through points [n,3]; fractions are of the length along it, from 0 to 1."""

    def __init__(self, points: Array) -> None:
        self.points = np.asarray(points, dtype=float)
        chords = np.linalg.norm(np.diff(self.points, axis=0), axis=1)
        self._knots = np.concatenate(([0.0], np.cumsum(chords)))
        self._second = natural_second_derivatives(self.points, chords)
        middles, weights = np.polynomial.legendre.leggauss(8)
        ends = np.concatenate([np.linspace(a, b, SAMPLES, endpoint=False) for a, b in zip(self._knots, self._knots[1:])] + [self._knots[-1:]])
        inner = ends[:-1, None] + np.diff(ends)[:, None] * (middles + 1.0) / 2.0
        speeds = np.linalg.norm(self._derivative(inner.ravel()), axis=1).reshape(inner.shape)
        lengths = np.concatenate(([0.0], np.cumsum(speeds @ weights * np.diff(ends) / 2.0)))
        self.length: float = float(lengths[-1])
        self.fractions: Array = lengths[::SAMPLES] / self.length  # of the points
        self._ends, self._lengths = ends, lengths

    @property
    def is_straight(self) -> bool:
        """Whether all points lie on one line, to 1e-9 of the length."""
        along = (self.points[-1] - self.points[0]) / self.length
        offset = self.points - self.points[0]
        return bool(np.max(np.linalg.norm(offset - np.outer(offset @ along, along), axis=1)) <= 1e-9 * self.length)

    def tangents(self, fractions: Array) -> Array:
        """Unit tangents [n,3]."""
        derivative = self._derivative(np.interp(np.asarray(fractions) * self.length, self._lengths, self._ends))
        return np.asarray(derivative / np.linalg.norm(derivative, axis=1)[:, None])

    def carry(self, direction: Array, fractions: Array) -> Array:
        """A direction [3] across the curve at the start, carried along it without twisting, at fractions that grow: [n,3]."""
        every = np.union1d(self._lengths / self.length, fractions)
        tangents = self.tangents(every)
        vector = across(direction, tangents[0])
        carried = [vector]
        for before, after in zip(tangents, tangents[1:]):  # by the least rotation from one tangent to the next
            vector = across(vector - (vector @ after) / (1.0 + before @ after) * (before + after), after)
            carried.append(vector)
        return np.array(carried)[np.searchsorted(every, fractions)]

    def _derivative(self, at: Array) -> Array:
        """By the length of the chords."""
        i = np.clip(np.searchsorted(self._knots, at, side="right") - 1, 0, len(self._knots) - 2)
        h = np.diff(self._knots)[i][:, None]
        left = (at - self._knots[i])[:, None]
        slope = (self.points[i + 1] - self.points[i]) / h
        m, n = self._second[i], self._second[i + 1]
        return np.asarray(slope + m * (left - left**2 / (2.0 * h) - h / 3.0) + n * (left**2 / (2.0 * h) - h / 6.0))


def across(vector: Array, tangent: Array) -> Array:
    """The unit vector across the tangent."""
    projected = vector - (vector @ tangent) * tangent
    return np.asarray(projected / np.linalg.norm(projected))


def natural_second_derivatives(points: Array, chords: Array) -> Array:
    """At the points [n,3]; 0 at both ends: h_{i-1} m_{i-1} + 2 (h_{i-1} + h_i) m_i + h_i m_{i+1} = 6 (d_i − d_{i-1})."""
    second = np.zeros_like(points)
    if len(points) > 2:
        matrix = np.diag(2.0 * (chords[:-1] + chords[1:])) + np.diag(chords[1:-1], 1) + np.diag(chords[1:-1], -1)
        second[1:-1] = np.linalg.solve(matrix, 6.0 * np.diff(np.diff(points, axis=0) / chords[:, None], axis=0))
    return second
