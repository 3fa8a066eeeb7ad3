"""A wind turbine as importers give it and the writer of decks takes it: a tower, a nacelle, a shaft, a hub and equal blades."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..typed import Array
from .blade import Blade


@dataclass
class Turbine:
    """A tower with a rotor. Global axes: x downwind at no yaw, z up, the yaw axis through the origin. SI units, angles in rad.

    `tower`, `blade`: rods in their own root axes; the tower's are global, from its base. `base`: height of the tower's base, in m. `twr2shft`: from the tower's top up to the shaft.
    `overhang`: from the yaw axis along the shaft to the apex, positive downwind. `tilt`: of the shaft, positive if its downwind end is up. `yaw`: right-handed about z. `cone`: positive downwind.
    `hub_radius`: from the apex to the blade's root. `azimuth`: of blade 1 from up, right-handed about the shaft downwind. `pitch`: to feather. `speed`: of the rotor, rad/s.
    `nacelle_mass`, `nacelle_centre` [3] from the tower's top, `nacelle_inertia` about the yaw axis. `hub_mass`, `hub_centre` from the apex along the shaft, `hub_inertia` about the shaft.
    `yaw_bearing_mass` at the tower's top, `tip_mass` at each blade's tip. `shaft_stiffness`, `shaft_damping`: of the turn between nacelle and hub. `notes`, `warnings`: as of a blade.
    """

    title: str
    source: str
    tower: Blade
    blade: Blade
    blades: int
    base: float
    twr2shft: float
    overhang: float
    tilt: float
    cone: float
    hub_radius: float
    nacelle_mass: float
    nacelle_centre: Array
    nacelle_inertia: float
    hub_mass: float
    hub_centre: float
    hub_inertia: float
    yaw: float = 0.0
    azimuth: float = 0.0
    pitch: float = 0.0
    speed: float = 0.0
    yaw_bearing_mass: float = 0.0
    tip_mass: float = 0.0
    shaft_stiffness: float = 0.0
    shaft_damping: float = 0.0
    notes: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)

    @property
    def top(self) -> Array:
        """The tower's top, [3]."""
        return np.array([0.0, 0.0, self.base + self.tower.length])

    @property
    def nacelle_axes(self) -> Array:
        """3×3, global components of the nacelle's axes as columns."""
        return about(2, self.yaw)

    @property
    def shaft_axes(self) -> Array:
        """3×3, the same of axes that do not turn with the rotor: x along the shaft downwind, z up."""
        return np.asarray(self.nacelle_axes @ about(1, -self.tilt))

    @property
    def shaft(self) -> Array:
        """The shaft's direction downwind, [3]."""
        return np.asarray(self.shaft_axes[:, 0])

    @property
    def apex(self) -> Array:
        """Where the blades' axes meet the shaft, [3]."""
        return np.asarray(self.top + self.twr2shft * np.array([0.0, 0.0, 1.0]) + self.overhang * self.shaft)

    @property
    def blade_axes(self) -> Array:
        """3×3, global components of the root axes of blade 1 as columns."""
        return np.asarray(self.shaft_axes @ about(0, self.azimuth) @ about(1, self.cone) @ about(2, -self.pitch))

    @property
    def blade_root(self) -> Array:
        """Where blade 1 begins, [3]."""
        return np.asarray(self.apex + self.hub_radius * self.blade_axes[:, 2])

    @property
    def rotor_mass(self) -> float:
        """Of the hub and the blades."""
        return self.hub_mass + self.blades * (self.blade.total_mass + self.tip_mass)

    @property
    def total_mass(self) -> float:
        """Of the tower and all on it."""
        return self.tower.total_mass + self.yaw_bearing_mass + self.nacelle_mass + self.rotor_mass


def about(axis: int, angle: float) -> Array:
    """3×3, a right-handed turn about x, y or z."""
    turned = np.eye(3)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turned[[i, j, i, j], [i, j, j, i]] = np.cos(angle), np.cos(angle), -np.sin(angle), np.sin(angle)
    return turned
