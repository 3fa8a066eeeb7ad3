"""Lines in the water, what they are made of and where they end: what the importers of mooring programs fill."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi
from typing import TypeAlias

from ..typed import Array

Vector: TypeAlias = tuple[float, float, float]


@dataclass
class LineType:
    """What a line is made of, in SI units.

    `name`. `diameter`: that of a cylinder that displaces as much water. `mass`: per length, in air. `EA`, `EI`: axial and bending stiffness; EI 0 if the file has none.
    `damping`: axial, force per rate of strain. `drag`: coefficients across the line, and along it on the surface π × diameter. `added_mass`: across and along it, of the mass
    of the water that it displaces. `notes`: what of a library was not used. `stretch`: rows of strain and tension, from (0, 0) on, in place of EA, which is then the first slope.
    """

    name: str
    diameter: float
    mass: float
    EA: float
    EI: float = 0.0
    damping: float = 0.0
    drag: tuple[float, float] = (0.0, 0.0)
    added_mass: tuple[float, float] = (0.0, 0.0)
    notes: list[str] = field(default_factory=list)
    stretch: list[tuple[float, float]] = field(default_factory=list)

    def submerged_weight(self, density: float, gravity: float) -> float:
        """Per length; negative of what floats."""
        return gravity * (self.mass - density * pi / 4 * self.diameter**2)


@dataclass
class Place:
    """Where lines end.

    `name`. `kind`: "fixed", "coupled" to a vessel, "clamped" with its rotations, "free" where lines meet in hinges, or "corner" where they meet rigidly. `at`: x, y, z. `mass`, `volume`: of
    a weight or a buoy there. `drag_area`: its area times the coefficient. `added_mass`: its coefficient, of the mass of its volume in water.
    """

    name: str
    kind: str
    at: Vector
    mass: float = 0.0
    volume: float = 0.0
    drag_area: float = 0.0
    added_mass: float = 0.0
    body: str = ""


@dataclass
class Body:
    """A rigid body that is free to move and carries places.

    `name`. `at`: its point of reference. `mass`, `inertia`: about the centre of mass, along body axes. `centre_of_mass`: from `at`. `volume`: of the water that it displaces, at `at`.
    `drag_area`: areas times coefficients along body axes. `added_mass`: along them. `rotation_vector`: of body axes against global ones. `line`: of the file, for errors.
    `centre_of_mass` is along body axes, too.
    """

    name: str
    at: Vector
    mass: float = 0.0
    inertia: Vector = (0.0, 0.0, 0.0)
    centre_of_mass: Vector = (0.0, 0.0, 0.0)
    volume: float = 0.0
    drag_area: Vector = (0.0, 0.0, 0.0)
    added_mass: Vector = (0.0, 0.0, 0.0)
    rotation_vector: Vector = (0.0, 0.0, 0.0)
    line: int = 0


@dataclass
class Line:
    """A line of one type between two places.

    `name`, `type`. `ends`: where it starts and ends. `length`: without tension. `segments`: elements of the rod. `line`: of the file, for errors.
    """

    name: str
    type: LineType
    ends: tuple[Place, Place]
    length: float
    segments: int
    line: int = 0


@dataclass
class Mooring:
    """Lines with the water and the ground around them, in SI units, z up and still water at z = 0.

    `title`, `source`: of the deck. `lines`. `gravity`, `density`: of the water, 0 in air. `depth`: 0 without ground. `ground_stiffness`, `ground_damping`: per area; a ground without stiffness holds
    nothing and is left out. `friction`: coefficient. `bodies`: free ones. `notes`: what the reader assumed, and what it left out that changes nothing. `warnings`: what it left out that changes the
    results. `ground`: x, y, z of a full grid [n,3] in place of a level ground.
    """

    title: str
    source: str
    lines: list[Line]
    gravity: float
    density: float
    depth: float
    ground_stiffness: float
    ground_damping: float
    friction: float
    notes: list[str] = field(default_factory=list)
    bodies: list[Body] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    ground: Array | None = None

    @property
    def has_water(self) -> bool:
        """Whether water is around."""
        return self.density > 0.0

    @property
    def has_ground(self) -> bool:
        """Whether there is a ground that holds something."""
        return (self.depth > 0.0 or self.ground is not None) and self.ground_stiffness > 0.0

    @property
    def types(self) -> list[LineType]:
        """Those that lines have, each once."""
        return list({line.type.name: line.type for line in self.lines}.values())
