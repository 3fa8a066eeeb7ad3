"""A cross-section as a mesh of plies, as programs for sections have it: nodes, elements, materials and two angles."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..typed import Array

# The MSH format's numbers of element types, by how many nodes they have.
GMSH_TYPES = {3: 2, 6: 9, 4: 3, 8: 16, 9: 10}
SAME = 1e-9  # angles in rad, and ratios of moduli, nearer than that are one


@dataclass
class SectionMaterial:
    """An isotropic material: E and nu are numbers. An orthotropic one: E [1, 2, 3], G [12, 13, 23], nu [12, 13, 23], 1 along the fibres and 3 across the ply."""

    name: str
    E: Any
    nu: Any
    G: Any = None
    density: float = 0.0
    strength: dict[str, float] = field(default_factory=dict)

    @property
    def is_isotropic(self) -> bool:
        """Whether it has no axes."""
        return self.G is None


@dataclass
class SectionLayer:
    """Elements of one material whose fibres have one angle, from x towards the wall, in rad."""

    material: SectionMaterial
    fibre_angle: float = 0.0

    @property
    def name(self) -> str:
        """The material, and the angle in degrees."""
        degrees = np.degrees(self.fibre_angle)
        return self.material.name if abs(degrees) < SAME or self.material.is_isotropic else f"{self.material.name} {degrees:.10g}"


@dataclass
class SectionMesh:
    """A mesh in gxrod's axes: y to the right and z up, seen against x.

    nodes [n,2]. elements: the nodes of each, from 0, in the order of Gmsh: corners, then sides, then the middle. element_layers [e]: indices in `layers`.
    wall_angles: of each element the angle of its wall from y towards z in rad, [1], or [k] for one at each of its k nodes. notes, warnings: what was left
    out; warnings change the results.
    """

    title: str
    source: str
    nodes: Array
    elements: list[Array]
    element_layers: list[int]
    wall_angles: list[Array]
    layers: list[SectionLayer]
    notes: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    units: str = ""  # of a deck; "": as the file's, which does not say

    @property
    def extent(self) -> float:
        """The larger one of width and height."""
        used = self.nodes[np.unique(np.concatenate(self.elements))]
        return float(np.max(np.ptp(used, axis=0)))

    @property
    def area(self) -> float:
        """The area of the polygons between corners."""
        total = 0.0
        for element in self.elements:
            y, z = self.nodes[element[: corner_count(element)]].T
            total += abs(float(np.dot(y, np.roll(z, -1)) - np.dot(z, np.roll(y, -1)))) / 2.0
        return total


def corner_count(element: Array) -> int:
    return 3 if len(element) in (3, 6) else 4


def stray_side_node(nodes: Array) -> int:
    """The first node on a side [k,2] that is not about half-way along it, from 1; 0 if all are. Another order of nodes than the expected one shows so."""
    corners = corner_count(np.arange(len(nodes)))
    for side in range(corners if len(nodes) > corners else 0):
        a, b, middle = nodes[side], nodes[(side + 1) % corners], nodes[corners + side]
        if np.linalg.norm(middle - (a + b) / 2.0) > 0.3 * np.linalg.norm(b - a):
            return corners + side + 1
    return 0


def make_layers(pairs: list[tuple[SectionMaterial, float]]) -> tuple[list[SectionLayer], list[int]]:
    """Layers of materials and fibre angles (rad) of elements, and the layer of each element. Angles of isotropic materials do not count."""
    layers: dict[tuple[str, float], int] = {}
    found, numbers = [], []
    for material, angle in pairs:
        angle = 0.0 if material.is_isotropic else angle
        key = (material.name, round(angle / SAME) * SAME)
        if key not in layers:
            layers[key] = len(found)
            found.append(SectionLayer(material, angle))
        numbers.append(layers[key])
    return found, numbers
