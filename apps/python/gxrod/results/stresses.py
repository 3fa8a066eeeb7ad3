"""Stresses in sections: at any place of a rod and any frame, and the largest ones of all steps."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import FileError, UnknownNameError
from ..typed import Array, WholeArray
from .display import Shown
from .frames import find_rod
from .records import Named
from .source import Source, plain, read_column
from .tables import Table

if TYPE_CHECKING:
    from numpy.typing import NDArray

COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")
RESULTANTS = ("N", "Vy", "Vz", "T", "My", "Mz")
MEASURES = ("von_mises", "exposure")


class ResultSection(Shown):
    """A section on cells, as the file has it: `r.sections["post"]`. y and z are its axes; the rod passes through (0, 0).

    `name`, `source`: texts, as "IPE 200". `nodes` [n,2]: y, z. `cells` [c,m]: corners, as rows of `nodes`, of triangles among quads the last
    twice. `layer` [c]: row of `layers`, the material of each layer. `points` [p,2]: where stresses are known, one for each node and
    layer. `point_layer` [p]. `cell_points` [c,m]: points of each cell's corners. `stress_operator` [p,6,6]: stresses (xx yy zz yz xz xy) by
    resultants (N, Vy, Vz, T, My, Mz). `is_singular` [p]: True where stress has no finite value.
    """

    nodes: Array
    cells: WholeArray
    layer: WholeArray
    points: Array
    point_layer: WholeArray
    cell_points: WholeArray
    stress_operator: Array
    is_singular: NDArray[np.bool_]
    layers: list[str]

    def __init__(self, source: Source, number: int, name: str) -> None:
        def read(file):
            group = file[f"sections/{number}"]
            return plain(group.attrs["source"]), {key: read_column(dataset) for key, dataset in group.items()}

        self.name = name
        self.source, columns = source.once(("section", number), read)
        for key in ("nodes", "cells", "layer", "points", "point_layer", "cell_points"):
            setattr(self, key, columns[key])
        self.layers = list(columns["layers"])
        self.stress_operator = columns["stress_operator"].astype(float).reshape(-1, 6, 6)
        self.is_singular = columns["is_singular"].astype(bool)

    def stress(self, resultants: Array) -> Array:
        """Stresses [p,6] (xx yy zz yz xz xy) at all points under the resultants (N, Vy, Vz, T, My, Mz), about the rod."""
        return self.stress_operator @ np.asarray(resultants, dtype=float)

    def _headline(self):
        return f"section {self.name}: {self.source}, {len(self.cells)} cells, {len(self.points)} points, {', '.join(self.layers)}"


class SectionStress(Shown):
    """Stresses in a section at a place of a rod and a time: `r.stress("beam", s=0.3, t=2.0)`.

    `rod`, `s`, `time`: where and when. `section`: a ResultSection. `resultants` [6]: N, Vy, Vz, T, My, Mz. `points` [p,2]: y, z. `layer` [p]:
    rows of `section.layers`. `tensor` [p,6]: xx yy zz yz xz xy, x along the rod; also `stress.xx` to `stress.xy` [p].
    """

    def __init__(self, rod: str, s: float, time: float, section: ResultSection, resultants: Array) -> None:
        self.rod, self.s, self.time, self.section, self.resultants = rod, s, time, section, resultants
        self.points, self.layer, self.tensor = section.points, section.point_layer, section.stress(resultants)

    @property
    def von_mises(self) -> Array:
        """Von Mises' stress [p]."""
        return von_mises(self.tensor)

    @property
    def principal(self) -> Array:
        """Principal stresses [p,3], the largest first."""
        xx, yy, zz, yz, xz, xy = self.tensor.T
        tensors = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).transpose(2, 0, 1)
        return np.linalg.eigvalsh(tensors)[:, ::-1]

    @property
    def worst(self) -> dict:
        """The point of the largest von Mises stress: `index`, `point` (y, z), `layer` (its material), `von_mises`, `tensor` [6]. Points without a finite stress are left out."""
        values = np.where(self.section.is_singular, -np.inf, self.von_mises)
        index = int(values.argmax())
        return {"index": index, "point": self.points[index], "layer": self.section.layers[self.layer[index]],
                "von_mises": float(values[index]), "tensor": self.tensor[index]}

    def __getattr__(self, name: str) -> Array:
        if name in COMPONENTS:
            return self.tensor[:, COMPONENTS.index(name)]
        raise AttributeError(name)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *COMPONENTS]

    def __len__(self) -> int:
        return len(self.points)

    def _headline(self):
        return f"stress of {self.rod} at s = {self.s:g}, time {self.time:g}: {len(self)} points of {self.section.name}"

    def _rows(self):
        worst = self.worst
        y, z = worst["point"]
        return [*zip(RESULTANTS, (f"{value:g}" for value in self.resultants)),
                ("von Mises", f"{worst['von_mises']:g} at ({y:g}, {z:g}), {worst['layer']}")]


class Envelope(Shown):
    """The largest stresses of all steps along a rod: `r.envelope("beam").von_mises.value` [n].

    `arc_length`, `element` [n]: places, the start, middle and end of each element whose section has a shape and no law, where it varies the nodes. `section` [n]: row
    of the file's sections. `criterion`: of exposure. `von_mises`, `exposure`: tables with `value` (of exposure NaN without a strength), `time`
    [n], `point` [n,2] (y, z), `layer` [n] and `resultants` [n,6] (N, Vy, Vz, T, My, Mz).
    """

    von_mises: Table
    exposure: Table

    def __init__(self, source: Source, rod: str, row: int) -> None:
        def read(file):
            group = file["envelopes"]
            places = {name: group[name][()] for name in ("rod", "element", "arc_length", "section")}
            tables = {name: {key: data[()] for key, data in group[name].items()} for name in MEASURES if name in group}
            return plain(group.attrs["criterion"]), places, tables

        self.rod = rod
        self.criterion, places, tables = source.once("envelopes", read)
        rows = places["rod"] == row
        self.element, self.arc_length, self.section = (places[name][rows] for name in ("element", "arc_length", "section"))
        self.measures = list(tables)
        for name, columns in tables.items():
            setattr(self, name, Table(f"{name} of {rod}", {key: values[rows] for key, values in columns.items()}))

    def worst(self, measure: str = "von_mises") -> dict:
        """The place of the largest value: its `arc_length`, `element`, `value`, `time`, `point`, `layer` and `resultants`. measure: "von_mises" or "exposure"."""
        table = getattr(self, measure)
        if not np.isfinite(table.value).any():
            raise UnknownNameError(f"rod {self.rod} has no stresses: its sections have no shape, or follow a law")
        row = int(np.nanargmax(table.value))
        return {"arc_length": float(self.arc_length[row]), "element": int(self.element[row]), "section": int(self.section[row]),
                **table.row(row)}

    def __len__(self) -> int:
        return len(self.arc_length)

    def _headline(self):
        return f"envelope of {self.rod}: {len(self)} places, exposure by {self.criterion}"

    def _rows(self):
        return [(name, f"{worst['value']:g} at s = {worst['arc_length']:g}, time {worst['time']:g}")
                for name in self.measures if np.isfinite(getattr(self, name).value).any() for worst in [self.worst(name)]]


def von_mises(tensor):
    """Of stresses [...,6]."""
    xx, yy, zz, yz, xz, xy = np.moveaxis(tensor, -1, 0)
    shear = yz**2 + xz**2 + xy**2
    return np.sqrt(0.5 * ((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) + 3.0 * shear)


def read_sections(source):
    names = source.once("sections", lambda file: list(read_column(file["sections/name"])) if "sections" in file else [])
    return Named("section", names, lambda name: ResultSection(source, names.index(name), name))


def check_has_stresses(source, group):
    if not source.once(("has", group), lambda file: group in file):
        raise UnknownNameError(f"{source.path.name} has no stresses: run it with stresses = \"von-mises\" in [output]")


def read_envelope(source, name):
    check_has_stresses(source, "envelopes")
    rod = find_rod(source, name)
    names = source.once("rod names", lambda file: list(read_column(file["rods/name"])))
    return Envelope(source, rod.name, names.index(name))


def read_stress(source, name, s, time):
    """See Results.stress."""
    check_has_stresses(source, "sections")
    rod = find_rod(source, name)
    if not 0.0 <= s <= rod.length * (1.0 + 1e-9):
        raise ValueError(f"s = {s:g} is not on rod {name}, which is {rod.length:g} long")
    if len(source.frame_times) == 0:
        raise FileError(f"{source.path}: has no frame yet")
    frame = len(source.frame_times) - 1 if time is None else int(np.abs(source.frame_times - time).argmin())
    forces = np.hstack([rod.read("force", frame), rod.read("moment", frame)])
    section = source.once("section numbers", lambda file: file["VTKHDF/CellData/section"][: source.cells])[rod.cells[find_element(rod, s)]]
    if section < 0:
        raise UnknownNameError(f"rod {name} has no stresses at s = {s:g}: its section has no shape, or follows a law")
    names = list(read_sections(source))
    return SectionStress(name, float(s), float(source.frame_times[frame]), ResultSection(source, int(section), names[section]),
                         interpolate(rod.cell_arc_length, forces, s))


def find_element(rod, s):
    """The element of a rod in which s is; of two that meet there the first."""
    ends = rod.arc_length[rod.order :: rod.order]
    return min(int(np.searchsorted(ends, s)), len(rod.cells) - 1)


def interpolate(places, rows, s):
    """Linear between places, and beyond the first and last one."""
    if len(places) == 1:
        return rows[0]
    after = int(np.clip(np.searchsorted(places, s), 1, len(places) - 1))
    part = (s - places[after - 1]) / (places[after] - places[after - 1])
    return (1.0 - part) * rows[after - 1] + part * rows[after]
