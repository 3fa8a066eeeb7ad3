"""windIO, a wind turbine in YAML: `elastic_properties_mb: six_x_six` of version 1, `structure: elastic_properties` of version 2.

The matrices are BeamDyn's, in its axes and order; the twist is in rad in version 1 and in degrees in version 2, about −z.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ..typed import AnyPath, Array
from .axes import FROM_BEAMDYN, from_upper, slice_mass, turn
from .beamdyn import in_gxrod_order
from .blade import Blade, check_blade
from .text import ImportFault, read_text

SHAPE = ("outer_shape_bem", "outer_shape", "internal_structure_2d_fem", "structure")  # from which the matrices come
ENTRIES = [f"K{i}{j}" for i in range(1, 7) for j in range(i, 7)]


def is_windio(text: str) -> bool:
    return any(line.startswith("components:") for line in text.splitlines())


class Node:
    """A table of the YAML text, and the path by which it was reached."""

    def __init__(self, values: Any, file: Path, path: str = "") -> None:
        self.values, self.file, self.path = values, file, path

    def fault(self, message: str, todo: str = "correct it") -> ImportFault:
        lines = read_text(self.file).splitlines()
        return ImportFault(f"{self.file}:{find_line(lines, self.path)}: {self.path}: {message}; {todo}")

    def has(self, key: str) -> bool:
        return isinstance(self.values, Mapping) and key in self.values

    def __getitem__(self, key: str) -> Node:
        if not self.has(key):
            there = f", found {', '.join(map(str, self.values))[:200]}" if isinstance(self.values, Mapping) else ""
            raise self.fault(f"expected a key {key}{there}", "give a windIO file of a blade with its 6×6 matrices")
        return Node(self.values[key], self.file, f"{self.path}/{key}".lstrip("/"))

    def numbers(self, shape: tuple[int, ...]) -> Array:
        """An array of numbers; −1 in the shape is any length."""
        try:
            array = np.array(self.values, dtype=float)
        except (TypeError, ValueError) as error:
            raise self.fault("expected numbers") from error
        if array.ndim != len(shape) or any(want not in (-1, has) for want, has in zip(shape, array.shape)) or not np.all(np.isfinite(array)):
            raise self.fault(f"expected {' × '.join('n' if n < 0 else str(n) for n in shape)} finite numbers, found an array of {' × '.join(map(str, array.shape))}")
        return array

    def table(self) -> tuple[Array, Array]:
        """`grid` and `values` of as many."""
        grid = self["grid"].numbers((-1,))
        return grid, self["values"].numbers((len(grid),))


def find_line(lines: list[str], path: str) -> int:
    """The line of the last key of a path, each key looked for after the one before; 1 if it is not in block style."""
    at = 0
    for key in path.split("/"):
        at = next((i for i in range(at, len(lines)) if lines[i].strip().startswith(f"{key}:")), at)
    return at + 1


def read_windio(path: AnyPath) -> Blade:
    file = Path(path)
    root = Node(load_yaml(file), file)
    blade = root["components"]["blade"]
    is_first = blade.has("elastic_properties_mb")
    found = read_version_1(blade) if is_first else read_version_2(blade)
    found.title = str(root.values.get("name", ""))
    found.source = f"windIO {1 if is_first else 2}: {file.name}"
    name_unused(found, blade, is_first)
    return check_blade(found, lambda i, what, todo: blade.fault(f"station {i + 1}: {what}", todo))


def name_unused(found: Blade, blade: Node, is_first: bool) -> None:
    """Keys next to those that were read: of shape and inner structure in a note, of masses, stiffness and damping in a warning."""
    idle = [f"{name}" for name in SHAPE if blade.has(name) and (is_first or name not in ("outer_shape", "structure"))]
    found.notes += [f"not used, as the matrices have it: {', '.join(idle)}"] if idle else []
    others = [str(key) for key in blade.values if key not in (*SHAPE, "elastic_properties_mb", "name", "id", "DOE", "reference_axis")]
    if is_first:
        others += [f"elastic_properties_mb/{key}" for key in blade["elastic_properties_mb"].values if key != "six_x_six"]
        others += [f"six_x_six/{key}" for key in blade["elastic_properties_mb"]["six_x_six"].values if key not in ("reference_axis", "twist", "stiff_matrix", "inertia_matrix")]
    else:
        others += [f"elastic_properties/{key}" for key in blade["structure"]["elastic_properties"].values if key not in ("stiffness_matrix", "inertia_matrix", "structural_damping")]
    structure = next((blade[name] for name in ("internal_structure_2d_fem", "structure") if blade.has(name)), None)
    if structure is not None and structure.has("joint") and structure["joint"].has("mass") and structure["joint"].values["mass"]:
        others.append(f"joint (of the mass {structure['joint'].values['mass']:g})")
    found.warnings += [f"not used: {', '.join(others)}"] if others else []


def load_yaml(file: Path) -> Any:
    try:
        import yaml
    except ImportError as error:
        raise ImportFault(f"{file}: windIO files need the Python module yaml, which is not installed; on Debian: apt install python3-yaml, "
                          "elsewhere: python3 -m pip install pyyaml") from error
    try:
        return yaml.load(read_text(file), Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        raise ImportFault(f"{file}:{mark.line + 1 if mark else 1}: this is no YAML: {getattr(error, 'problem', None) or error}; correct the text") from error


def read_version_1(blade: Node) -> Blade:
    """Upper triangles row by row."""
    six = blade["elastic_properties_mb"]["six_x_six"]
    stiff, inertia = six["stiff_matrix"], six["inertia_matrix"]
    grid = stiff["grid"].numbers((-1,))
    mass_grid = inertia["grid"].numbers((-1,))
    stiffness = triangles(stiff["values"].numbers((len(grid), 21)))
    mass = triangles(inertia["values"].numbers((len(mass_grid), 21)))
    return assemble((grid, stiffness), (mass_grid, mass), six["reference_axis"], six["twist"].table(), None)


def read_version_2(blade: Node) -> Blade:
    """Entries as columns; the mass by its centre and moments of inertia about the axis."""
    elastic = blade["structure"]["elastic_properties"]
    stiff, inertia = elastic["stiffness_matrix"], elastic["inertia_matrix"]
    grid, mass_grid = stiff["grid"].numbers((-1,)), inertia["grid"].numbers((-1,))
    entries = np.stack([column(stiff, key, len(grid)) for key in ENTRIES], axis=1)
    m, x, y, edge, flap, polar, product = (column(inertia, key, len(mass_grid)) for key in ("mass", "cm_x", "cm_y", "i_edge", "i_flap", "i_plr", "i_cp"))
    mass = np.array([turn(about_axis(*values), FROM_BEAMDYN) for values in zip(m, x, y, edge, flap, polar, product)])
    twist_grid, twist = blade["outer_shape"]["twist"].table()
    damping = in_gxrod_order(elastic["structural_damping"]["mu"].numbers((6,))) if elastic.has("structural_damping") else None
    axis = blade["reference_axis"] if blade.has("reference_axis") else blade["outer_shape"]["reference_axis"]
    found = assemble((grid, triangles(entries)), (mass_grid, mass), axis, (twist_grid, np.radians(twist)), damping)
    found.notes.append("matrices in BeamDyn's axes (K44 edgewise, K55 flapwise), as windIO's converter from version 1 leaves them")
    return found


def column(node: Node, key: str, count: int) -> Array:
    """The numbers of a key; 0 without it, as windIO has it."""
    return node[key].numbers((count,)) if node.has(key) else np.zeros(count)


def about_axis(m: float, x: float, y: float, edge: float, flap: float, polar: float, product: float) -> Array:
    """The mass 6×6 in BeamDyn's axes: centre at (x, y), moments of inertia about the axis, i_edge about x, i_flap about y."""
    matrix = slice_mass(m, np.array([x, y, 0.0]), np.zeros((3, 3)))
    matrix[3:, 3:] = [[edge, -product, 0.0], [-product, flap, 0.0], [0.0, 0.0, polar]]
    return matrix


def triangles(rows: Array) -> Array:
    """[n,6,6] in gxrod's axes."""
    return np.array([turn(from_upper(row), FROM_BEAMDYN) for row in rows])


def assemble(stiff: tuple[Array, Array], inertia: tuple[Array, Array], axis: Node, twist: tuple[Array, Array], damping: Array | None) -> Blade:
    """Stations where either matrix has one; both are linear between."""
    tables = [axis[name].table() for name in "xyz"]
    points = on_grid(np.unique(np.concatenate([grid for grid, _ in tables])), tables)
    stations = stiff[0] if np.array_equal(stiff[0], inertia[0]) else np.union1d(stiff[0], inertia[0])
    stiffness, mass = (values if np.array_equal(stations, grid) else interpolate(stations, grid, values) for grid, values in (stiff, inertia))
    twist_grid = np.union1d(twist[0], (0.0, 1.0))
    return Blade(title="", source="", fractions=stations, stiffness=stiffness, mass=mass, points=points,
                 twist_fractions=twist_grid, twist=-np.interp(twist_grid, *twist), damping=damping if damping is not None and np.any(damping) else None)


def on_grid(grid: Array, tables: list[tuple[Array, Array]]) -> Array:
    return np.stack([np.interp(grid, *table) for table in tables], axis=1)


def interpolate(at: Array, grid: Array, matrices: Array) -> Array:
    """Matrices [n,6,6] at other fractions, linear between, entry by entry."""
    flat = matrices.reshape(len(grid), 36)
    return np.stack([np.interp(at, grid, entry) for entry in flat.T], axis=1).reshape(-1, 6, 6)
