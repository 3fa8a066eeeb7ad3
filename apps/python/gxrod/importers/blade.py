"""A blade as all importers give it and the writer of decks takes it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from ..typed import Array
from .curve import Curve
from .text import ImportFault

# Of rows and columns.
NAMES = ("axial", "flapwise shear", "edgewise shear", "torsion", "edgewise bending", "flapwise bending")
Fault = Callable[[int, str, str], ImportFault]  # (station from 0, what, what to do)


@dataclass
class Blade:
    """A rod whose section varies: stations along a reference curve, all in gxrod's axes.

    `title`: of the blade. `source`: the format and its files. `fractions`: of the stations, [n], 0 to 1 of the length of the curve. `stiffness`: [n,6,6], about the
    curve, in section axes, x along it, y flapwise, z edgewise. `mass`: the same; zeros for a static model. `points`: of the curve, [k,3], in m, root axes, x downwind,
    y to the trailing edge, z to the tip. `twist_fractions`: where the twist is given, [m]. `twist`: of the section about the tangent, right-handed, in rad, [m].
    `damping`: seconds by strain, [6], or None. `notes`: what was assumed, and what was left out that changes nothing. `warnings`: what was left out that changes the results.

    The untwisted section has its flapwise axis in the root's x-z plane.
    """

    title: str
    source: str
    fractions: Array
    stiffness: Array
    mass: Array
    points: Array
    twist_fractions: Array
    twist: Array
    damping: Array | None = None
    notes: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)

    @property
    def length(self) -> float:
        """Of the reference curve, in m."""
        return Curve(self.points).length

    @property
    def has_mass(self) -> bool:
        """Whether any station has mass; models of BeamDyn for statics have none."""
        return bool(np.any(self.mass))

    @property
    def total_mass(self) -> float:
        """Of the whole blade: mass per length, linear between stations."""
        per_length = self.mass[:, 0, 0]
        return float(np.sum((per_length[1:] + per_length[:-1]) / 2.0 * np.diff(self.fractions)) * self.length)

    def rod_twist(self) -> Array:
        """The twist [m] as a rod of a deck has it: from axes that are carried along the curve without twisting."""
        curve = Curve(self.points)
        tangents = curve.tangents(self.twist_fractions)
        carried = curve.carry(flapwise(curve.tangents(np.zeros(1))[0]), self.twist_fractions)
        turned = [np.arctan2(np.cross(y, wanted) @ t, y @ wanted) for y, wanted, t in zip(carried, map(flapwise, tangents), tangents)]
        return self.twist + np.unwrap(turned)


def check_blade(blade: Blade, fault: Fault) -> Blade:
    """Refuses stations out of order and matrices that no section has; makes them symmetric to the last bit."""
    check_fractions(blade.fractions, fault)
    for i in range(len(blade.fractions)):
        refuse = lambda what, i=i: fault(i, what, "correct the matrix")
        check_matrix(blade.stiffness[i], "stiffness", refuse)
        if blade.has_mass:
            check_matrix(blade.mass[i], "mass", refuse)
            check_slice(blade.mass[i], refuse)
    blade.stiffness = (blade.stiffness + blade.stiffness.transpose(0, 2, 1)) / 2.0
    blade.mass = (blade.mass + blade.mass.transpose(0, 2, 1)) / 2.0
    return blade


def flapwise(tangent: Array) -> Array:
    """The flapwise axis of an untwisted section: across the tangent, in the root's x-z plane."""
    x, _, z = tangent
    return np.array([z, 0.0, -x]) / float(np.hypot(x, z))


def check_fractions(fractions: Array, fault: Fault) -> None:
    """From 0 to 1, and none falls; a fraction that stands twice is a jump."""
    if len(fractions) < 2:
        raise fault(0, f"{len(fractions)} station; expected two or more", "give those at the root and at the tip")
    for i, step in enumerate(np.diff(fractions)):
        if step < 0.0:
            raise fault(i + 1, f"this station, at {fractions[i + 1]:g}, comes before the last one, at {fractions[i]:g}; expected them from root to tip", "sort them")
    for i, end in ((0, 0.0), (-1, 1.0)):
        if fractions[i] != end:
            raise fault(i % len(fractions), f"the {'last' if i else 'first'} station is at {fractions[i]:g}; expected {end:g}", "add one there")


def check_matrix(matrix: Array, name: str, fault: Callable[[str], ImportFault]) -> None:
    """Symmetric to 1e-6 of the diagonal, and positive definite."""
    diagonal = np.diag(matrix)
    if np.min(diagonal) <= 0.0:
        i = int(np.argmin(diagonal))
        raise fault(f"the {name} has {diagonal[i]:g} on its diagonal ({NAMES[i]}); expected numbers above 0")
    scaled = matrix / np.sqrt(np.outer(diagonal, diagonal))
    i, j = map(int, np.unravel_index(np.argmax(np.abs(scaled - scaled.T)), (6, 6)))
    if abs(scaled[i, j] - scaled[j, i]) > 1e-6:
        raise fault(f"the {name} is not symmetric: {matrix[i, j]:g} and {matrix[j, i]:g} ({NAMES[i]}, {NAMES[j]})")
    if np.min(np.linalg.eigvalsh((scaled + scaled.T) / 2.0)) <= 0.0:
        raise fault(f"the {name} is not positive definite: some motion would give no or negative energy")


def check_slice(mass: Array, fault: Callable[[str], ImportFault]) -> None:
    """Whether the mass is that of a rigid slice, to 1e-6: its upper half [m 1, −m [d]×]."""
    m = mass[0, 0]
    wanted = np.hstack((m * np.eye(3), (mass[:3, 3:] - mass[:3, 3:].T) / 2.0))
    radius = np.sqrt(np.max(np.diag(mass)[3:]) / m)
    off = np.abs(mass[:3] - wanted) / (m * np.repeat((1.0, radius), 3))
    i, j = map(int, np.unravel_index(np.argmax(off), off.shape))
    if off[i, j] > 1e-6:
        raise fault(f"the mass is not that of a rigid slice: {mass[i, j]:g} where {wanted[i, j]:g} would be ({NAMES[i]}, {NAMES[j]})")
