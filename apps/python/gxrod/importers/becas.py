"""BECAS: the folder of a section, with N2D.in, E2D.in, EMAT.in and MATPROPS.in, and FAILMAT.in if it is there.

Its axes x y z are gxrod's y z x. The fibre plane angle turns its x towards its y, the fibre angle the fibres from its z towards the turned x, in degrees.
Materials: 1 along the fibres, 2 in the fibre plane, 3 across it, as gxrod's.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ..typed import AnyPath, Array
from .section_mesh import SectionMaterial, SectionMesh, make_layers, stray_side_node
from .text import ImportFault, Lines

NODES, ELEMENTS, LAYUP, MATERIALS, STRENGTHS = "N2D.in", "E2D.in", "EMAT.in", "MATPROPS.in", "FAILMAT.in"
NEEDED = (NODES, ELEMENTS, LAYUP, MATERIALS)


def is_becas(path: AnyPath) -> bool:
    """Whether it is such a folder, or one of its files."""
    folder = folder_of(path)
    return (folder / NODES).is_file() and (Path(path).is_dir() or Path(path).name in (*NEEDED, STRENGTHS))


def folder_of(path: AnyPath) -> Path:
    return Path(path) if Path(path).is_dir() else Path(path).parent


def read_becas(path: AnyPath) -> SectionMesh:
    """The section of a folder of BECAS.

    Raises FileError, with file, line, what was expected and what to do.
    """
    folder = folder_of(path)
    missing = [name for name in NEEDED if not (folder / name).is_file()]
    if missing:
        raise ImportFault(f"{folder}: there is no {' and no '.join(missing)}; a folder of BECAS has {', '.join(NEEDED)}")
    return Reader(folder).read()


class Table:
    """Rows of numbers, with their lines."""

    def __init__(self, path: Path, counts: tuple[int, ...], what: str) -> None:
        self.lines = Lines(path)
        self.rows: list[list[float]] = []
        self.places: list[int] = []
        for i, text in enumerate(self.lines.lines, 1):
            words = text.split("%")[0].replace(",", " ").split()
            if not words:
                continue
            self.lines.at = i + 1
            expected = f"expected {' or '.join(map(str, counts))} numbers ({what})"
            if len(words) not in counts:
                raise self.lines.fault(f"{expected}, found {len(words)}", "correct this line")
            self.rows.append([self.lines.number(word, expected) for word in words])
            self.places.append(i)
        if not self.rows:
            raise self.lines.fault(f"there is nothing in it; expected {what}", "look whether it is whole", 0)

    def whole(self, row: int, columns: slice) -> list[int]:
        values = self.rows[row][columns]
        if any(value != int(value) for value in values):
            raise self.fault(row, "expected whole numbers of nodes, elements and materials", "correct this line")
        return [int(value) for value in values]

    def fault(self, row: int, message: str, todo: str) -> ImportFault:
        return self.lines.fault(message, todo, self.places[row])


class Reader:
    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.notes: list[str] = []
        self.warnings: list[str] = []

    def read(self) -> SectionMesh:
        nodes, node_rows = self.read_nodes()
        elements = self.read_elements(nodes, node_rows)
        materials = self.read_materials()
        pairs, walls = self.read_layup(elements, materials)
        layers, numbers = make_layers(pairs)
        idle = [each.name for each in materials if each.name not in {layer.material.name for layer in layers}]
        if idle:
            self.notes.append(f"materials that no element has were left out: {', '.join(idle)}")
        name = self.folder.resolve().name
        return SectionMesh(title=f"Section {name}", source=f"BECAS: {name}", nodes=nodes, elements=list(elements.values()), element_layers=numbers, wall_angles=walls, layers=layers,
                           notes=self.notes, warnings=self.warnings)

    def read_nodes(self) -> tuple[Array, dict[int, int]]:
        table = Table(self.folder / NODES, (3, 4), "number of the node, x, y")
        rows = {}
        for i in range(len(table.rows)):
            number = table.whole(i, slice(0, 1))[0]
            if number in rows:
                raise table.fault(i, f"the node {number} stands here again", "give each node its own number")
            rows[number] = i
        return np.array([row[1:3] for row in table.rows]), rows

    def read_elements(self, points: Array, node_rows: dict[int, int]) -> dict[int, Array]:
        """By their numbers, in the order of Gmsh."""
        table = Table(self.folder / ELEMENTS, (5, 7, 9), "number of the element and its eight nodes, 0 for those that it does not have")
        elements: dict[int, Array] = {}
        for i in range(len(table.rows)):
            number, *nodes = table.whole(i, slice(None))
            kept = [node for node in nodes if node != 0]
            if len(kept) == 4 and len(set(kept)) == 3:
                kept = list(dict.fromkeys(kept))
            if len(kept) not in (3, 4, 6, 8) or any(nodes[len(kept) + (len(nodes) == 4):]) or len(set(kept)) != len(kept):
                raise table.fault(i, "expected 3, 4, 6 or 8 nodes, corners first, then those on sides, then zeros", "correct this line")
            missing = [node for node in kept if node not in node_rows]
            if missing:
                raise table.fault(i, f"there is no node {missing[0]} in {NODES}", "correct this line, or add the node")
            elements[number] = np.array([node_rows[node] for node in kept])
            if stray := stray_side_node(points[elements[number]]):
                raise table.fault(i, f"the node {kept[stray - 1]} is not on its side, between corners that follow each other", "give corners first, then the nodes on sides, all the same way round")
        return elements

    def read_layup(self, elements: dict[int, Array], materials: list[SectionMaterial]) -> tuple[list[tuple[SectionMaterial, float]], list[Array]]:
        table = Table(self.folder / LAYUP, (4,), "number of the element, material, fibre angle, fibre plane angle")
        rows: dict[int, int] = {}
        for i in range(len(table.rows)):
            number, material = table.whole(i, slice(0, 2))
            if number not in elements:
                raise table.fault(i, f"there is no element {number} in {ELEMENTS}", "correct this line")
            if not 1 <= material <= len(materials):
                raise table.fault(i, f"there is no material {material}, {MATERIALS} has {len(materials)}", "correct this line, or add the material")
            rows[number] = i
        missing = [number for number in elements if number not in rows]
        if missing:
            raise table.lines.fault(f"the element {missing[0]} has no line", "give each element its material and angles", 0)
        chosen = [table.rows[rows[number]] for number in elements]
        return [(materials[int(row[1]) - 1], float(np.radians(row[2]))) for row in chosen], [np.radians(row[3:4]) for row in chosen]

    def read_materials(self) -> list[SectionMaterial]:
        table = Table(self.folder / MATERIALS, (10,), "E1 E2 E3 G12 G13 G23 nu12 nu13 nu23 density")
        materials = [SectionMaterial(f"m{i}", row[:3], row[6:9], row[3:6], row[9]) for i, row in enumerate(table.rows, 1)]
        if (self.folder / STRENGTHS).is_file():
            self.read_strengths(materials)
        return materials

    def read_strengths(self, materials: list[SectionMaterial]) -> None:
        """Strengths as stresses; tension, shear and compression are in columns 2 to 4, 5 to 7 and 8 to 10."""
        table = Table(self.folder / STRENGTHS, (19,), "criterion, nine strengths, nine ultimate strains")
        unused = []
        for material, row in zip(materials, table.rows):
            (Xt, Yt, Zt), shear, (Xc, Yc, Zc) = row[1:4], row[4:7], row[7:10]
            if min(row[1:10]) > 0.0 and Yt == Zt and Yc == Zc and shear[0] == shear[1] == shear[2]:
                material.strength = {"Xt": Xt, "Xc": Xc, "Yt": Yt, "Yc": Yc, "S12": shear[0], "S23": shear[2]}
            elif any(row[1:10]):
                unused.append(material.name)
        if unused:
            self.notes.append(f"strengths that differ across the fibres, or are incomplete, were left out: {', '.join(unused)}")
