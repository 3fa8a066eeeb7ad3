"""Stiffness and mass of a section, 6×6, about other points and in other axes.

Strains (γ, κ) and velocities (v, ω) are six numbers, order x y z | rx ry rz. At a point p of the section, seen from the origin,
they are (γ + κ × p, κ), so that a matrix about p is A(p)ᵀ C A(p) about the origin.
"""

from __future__ import annotations

import numpy as np

from ..typed import Array

UPPER = np.triu_indices(6)

# Axes of gxrod (x along the blade, y flapwise, z edgewise) from those of the formats: v_gxrod = R v.
FROM_BEAMDYN = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])  # x flapwise, y edgewise, z along
FROM_HAWC2 = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])  # x to the leading edge, y flapwise, z along
# Root axes of the deck, x downwind, y to the trailing edge, z to the tip, from those of HAWC2.
ROOT_FROM_HAWC2 = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def cross_matrix(p: Array) -> Array:
    """[p]×, 3×3: [p]× v = p × v."""
    x, y, z = p
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def rotation_about_z(angle: float) -> Array:
    """3×3, right-handed, angle in rad."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def turn(matrix: Array, rotation: Array) -> Array:
    """A 6×6 in other axes: v_new = rotation v, for all six."""
    both = np.kron(np.eye(2), rotation)
    return both @ matrix @ both.T


def move(matrix: Array, point: Array) -> Array:
    """A 6×6 about `point`, 3 coordinates in its axes, as one about the origin."""
    shift = np.eye(6)
    shift[:3, 3:] = -cross_matrix(point)
    return shift.T @ matrix @ shift


def slice_mass(mass: float, centre: Array, inertia: Array) -> Array:
    """6×6 of a rigid slice: mass per length, centre of mass [3], inertia about it per length, 3×3."""
    about_centre = np.zeros((6, 6))
    about_centre[:3, :3] = mass * np.eye(3)
    about_centre[3:, 3:] = inertia
    return move(about_centre, centre)


def from_upper(entries: Array) -> Array:
    """A symmetric 6×6 from its 21 entries on and above the diagonal, row by row."""
    matrix = np.zeros((6, 6))
    matrix[UPPER] = entries
    return matrix + np.triu(matrix, 1).T
