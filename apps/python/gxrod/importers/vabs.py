"""VABS: the input of a homogenization, as PreVABS (.sg) and SONATA write it, in its new and in its old format.

Its axes x1 x2 x3 are gxrod's x y z, its plane angle theta1 turns x2 towards x3, its layup angle theta3 the fibres from x1 towards the turned x2: those of
gxrod, in degrees.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..typed import AnyPath, Array
from .section_mesh import SectionMaterial, SectionMesh, make_layers, stray_side_node
from .text import Lines, to_number

UNIFORM = 540.0  # degrees: this as the second angle of an element says that the first one is for all of it
TYPES = {0: "isotropic", 1: "orthotropic", 2: "anisotropic"}
# The places of the six stresses in VABS's order 11 12 13 22 23 33, in the order 11 22 33 23 13 12.
STANDARD_ORDER = [0, 3, 5, 4, 2, 1]


def is_vabs(text: str) -> bool:
    """Whether its first lines are two, three and four whole numbers."""
    rows = [row for row in map(words_of, text.splitlines()) if row][:4]
    numbers = [[to_number(word) for word in row] for row in rows]
    return (len(rows) == 4 and [len(row) for row in rows[:3]] == [2, 3, 4] and len(rows[3]) in (2, 3)
            and all(value is not None and value == int(value) for row in numbers[:3] for value in row) and all(value is not None for value in numbers[3]))


def words_of(line: str) -> list[str]:
    """The words of a line; ! begins a comment."""
    return line.split("!")[0].replace(",", " ").split()


@dataclass
class Header:
    has_layers: bool  # the new format
    layers: int
    is_thermal: bool
    nodes: int = 0
    elements: int = 0
    materials: int = 0


def read_vabs(path: AnyPath) -> SectionMesh:
    """The section of an input file of VABS. Loads for recovery, which may follow, are not read.

    Raises FileError, with file, line, what was expected and what to do.
    """
    return Reader(Lines(path)).read()


class Reader:
    def __init__(self, lines: Lines) -> None:
        self.lines = lines
        self.notes: list[str] = []
        self.warnings: list[str] = []
        self.node_rows: dict[int, int] = {}

    def read(self) -> SectionMesh:
        header = self.read_header()
        nodes = self.read_nodes(header.nodes)
        elements = self.read_elements(header.elements, nodes)
        if header.has_layers:
            kinds, walls = self.read_layer_types(elements)
            layers = self.read_layers(header.layers)
            pairs = [self.find(layers, kind, "layer", line) for kind, line in kinds]
        else:
            pairs, walls = self.read_layups(elements)
        materials = self.read_materials(header.materials)
        chosen = [(self.find(materials, material, "material", line), np.radians(angle)) for material, angle, line in pairs]
        found, numbers = make_layers(chosen)
        idle = [str(number) for number in materials if number not in {material for material, _, _ in pairs}]
        if idle:
            self.notes.append(f"materials that no element has were left out: {', '.join(idle)}")
        return SectionMesh(title=f"Section {self.lines.path.stem}", source=f"VABS: {self.lines.path.name}", nodes=nodes, elements=list(elements.values()), element_layers=numbers,
                           wall_angles=walls, layers=found, notes=self.notes, warnings=self.warnings)

    # Lines

    def row(self, counts: tuple[int, ...], what: str) -> list[float]:
        """The numbers of the next line that has any; how many of them is one of `counts`."""
        words: list[str] = []
        while not words:
            words = words_of(self.lines.next(what))
        expected = f"expected {' or '.join(map(str, counts))} numbers ({what})"
        if len(words) not in counts:
            raise self.lines.fault(f"{expected}, found {len(words)}", "correct this line, or the count that announces it")
        return [self.lines.number(word, expected) for word in words]

    def whole(self, values: list[float], what: str) -> list[int]:
        if any(value != int(value) for value in values):
            raise self.lines.fault(f"expected whole numbers ({what})", "correct this line, or the count that announces it")
        return [int(value) for value in values]

    def constants(self, count: int, what: str) -> list[float]:
        """Numbers over as many lines as they take."""
        values: list[float] = []
        while len(values) < count:
            values += self.row(tuple(range(1, count - len(values) + 1)), f"{what}, {count - len(values)} more")
        return values

    def find(self, known: dict[int, Any], number: int, what: str, line: int) -> Any:
        if number not in known:
            raise self.lines.fault(f"there is no {what} {number}, the file has {', '.join(map(str, known))}", f"correct this line, or add the {what}", line)
        return known[number]

    # Parts of the file, in their order

    def read_header(self) -> Header:
        form, layers = self.whole(self.row((2,), "format, number of layers"), "format, number of layers")
        flags = self.whole(self.row((3,), "flags: Timoshenko, damping, thermal"), "flags")
        curved, oblique, *_ = self.whole(self.row((4,), "flags: curve, oblique, trapeze, Vlasov"), "flags")
        header = Header(form == 1, layers, flags[2] == 3)
        if curved:
            k = self.row((3,), "twist and curvatures k1 k2 k3")
            if any(k):
                self.warnings.append(f"the initial twist and curvatures {k[0]:g}, {k[1]:g}, {k[2]:g} are not in the stiffness of the section, which is that of a straight bar; give the rod its curve and twist")
        if oblique and self.row((2,), "cosines of an oblique section") != [1.0, 0.0]:
            raise self.lines.fault("the section is oblique", "give the mesh of the section across the rod")
        header.nodes, header.elements, header.materials = self.whole(self.row((3,), "numbers of nodes, elements and materials"), "numbers of nodes, elements and materials")
        return header

    def read_nodes(self, count: int) -> Array:
        points = np.zeros((count, 2))
        for i in range(count):
            number, *at = self.row((3,), f"node {i + 1} of {count}: its number, x2, x3")
            if int(number) in self.node_rows:
                raise self.lines.fault(f"the node {number:g} stands here again", "give each node its own number")
            self.node_rows[int(number)] = i
            points[i] = at
        return points

    def read_elements(self, count: int, points: Array) -> dict[int, Array]:
        """By their numbers, in the order of Gmsh."""
        elements: dict[int, Array] = {}
        for i in range(count):
            number, *nodes = self.whole(self.row((10,), f"element {i + 1} of {count}: its number and nine nodes"), "number and nodes of an element")
            corners, rest = (nodes[:3], nodes[4:7]) if nodes[3] == 0 else (nodes[:4], nodes[4:])
            kept = corners + [node for node in rest if node != 0]
            if 0 in corners or len(kept) not in ((3, 6) if nodes[3] == 0 else (4, 8, 9)) or (nodes[3] == 0 and any(nodes[7:])):
                raise self.lines.fault("expected the nodes of a triangle (three corners, a 0, then none or three on sides) or a quadrangle (four corners, then none, four on sides, or five)",
                                       "correct this line; elements with nodes on some sides are not read")
            missing = [node for node in kept if node not in self.node_rows]
            if missing:
                raise self.lines.fault(f"there is no node {missing[0]}", "correct this line, or add the node")
            elements[number] = np.array([self.node_rows[node] for node in kept])
            if stray := stray_side_node(points[elements[number]]):
                raise self.lines.fault(f"the node {kept[stray - 1]} is not on its side, between corners that follow each other", "give the nodes in VABS's order")
        return elements

    def read_layer_types(self, elements: dict[int, Array]) -> tuple[list[tuple[int, int]], list[Array]]:
        """Of the new format: layer of each element, with its line, and angle of its wall."""
        rows = self.rows_of(elements, (3,), "number, layer, theta1")
        return [(self.whole(row[1:2], "layer")[0], line) for row, line in rows], [np.radians(row[2:]) for row, _ in rows]

    def read_layups(self, elements: dict[int, Array]) -> tuple[list[tuple[int, float, int]], list[Array]]:
        """Of the old format: material, theta3 and line of each element, and angles of its wall."""
        rows = self.rows_of(elements, (12,), "number, material, theta3 and nine angles theta1")
        walls = [self.walls_of(element, row[3:]) for element, (row, _) in zip(elements.values(), rows)]
        return [(self.whole(row[1:2], "material")[0], row[2], line) for row, line in rows], walls

    @staticmethod
    def walls_of(element: Array, given: list[float]) -> Array:
        angles = np.radians(given[:1] if given[1] == UNIFORM else (given[:3] + given[4:7] if len(element) in (3, 6) else given)[: len(element)])
        return angles[:1] if np.ptp(angles) == 0.0 else angles

    def rows_of(self, elements: dict[int, Array], counts: tuple[int, ...], what: str) -> list[tuple[list[float], int]]:
        """A row for each element, with its line, in the order of the elements."""
        rows: dict[int, tuple[list[float], int]] = {}
        for i in range(len(elements)):
            row = self.row(counts, f"element {i + 1} of {len(elements)}: {what}")
            rows[int(row[0])] = (row, self.lines.at - 1)
        missing = [number for number in elements if number not in rows]
        if missing:
            raise self.lines.fault(f"the element {missing[0]} has no line with its layup", "give each element one")
        return [rows[number] for number in elements]

    def read_layers(self, count: int) -> dict[int, tuple[int, float, int]]:
        """By number: material, theta3, line."""
        layers = {}
        for i in range(count):
            number, material, angle, *_ = self.row((3, 4), f"layer {i + 1} of {count}: its number, material, theta3")
            layers[int(number)] = (int(material), angle, self.lines.at - 1)
        return layers

    def read_materials(self, count: int) -> dict[int, SectionMaterial]:
        materials = {}
        for i in range(count):
            self.skip_other_constants()
            number, kind = self.whole(self.row((2,), f"material {i + 1} of {count}: its number and type"), "number and type of a material")
            if kind not in TYPES:
                raise self.lines.fault(f"expected a type of material, {', '.join(f'{k} {v}' for k, v in TYPES.items())}, found {kind}", "correct it")
            materials[number] = self.read_material(f"m{number}", kind)
        return materials

    def skip_other_constants(self) -> None:
        """Damping and expansion, which may follow the density: lines that do not have two words."""
        while not self.lines.is_over and len(words_of(self.lines[self.lines.at])) != 2:
            if words_of(self.lines[self.lines.at]):
                self.notes = list(dict.fromkeys([*self.notes, "damping and thermal expansion of materials were left out"]))
            self.lines.at += 1

    def read_material(self, name: str, kind: int) -> SectionMaterial:
        if kind == 0:
            E, nu, density = self.constants(3, "E, nu, density")
            return SectionMaterial(name, E, nu, density=density)
        if kind == 1:
            values = self.constants(10, "E1 E2 E3, G12 G13 G23, nu12 nu13 nu23, density")
            return SectionMaterial(name, values[:3], values[6:9], values[3:6], values[9])
        return self.read_anisotropic(name)

    def read_anisotropic(self, name: str) -> SectionMaterial:
        """21 stiffnesses; those of an orthotropic material, the only ones that gxrod has."""
        *entries, density = self.constants(22, "21 stiffnesses, density")
        stiffness = np.zeros((6, 6))
        stiffness[np.triu_indices(6)] = entries
        stiffness += np.triu(stiffness, 1).T
        ordered = stiffness[np.ix_(STANDARD_ORDER, STANDARD_ORDER)]
        coupling = ordered.copy()
        coupling[:3, :3] = 0.0
        np.fill_diagonal(coupling, 0.0)
        if np.max(np.abs(coupling)) > 1e-9 * np.max(np.abs(ordered)) or np.linalg.matrix_rank(ordered) < 6:
            raise self.lines.fault(f"the material {name} is anisotropic in a way that gxrod does not have, normal and shear strains are coupled", "give its orthotropic constants, and its axes by theta1 and theta3")
        flexibility = np.linalg.inv(ordered)
        E = 1.0 / np.diagonal(flexibility)[:3]
        return SectionMaterial(name, E.tolist(), [-flexibility[0, 1] * E[0], -flexibility[0, 2] * E[0], -flexibility[1, 2] * E[1]], ordered[[5, 4, 3], [5, 4, 3]].tolist(), density)
