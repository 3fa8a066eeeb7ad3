"""Decks and the models that are built from them."""

from __future__ import annotations

import copy
import json
import os
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from . import _core
from .errors import DeckError, Error, unknown_name
from .results.display import Shown
from .typed import AnyPath, Array, Overrides, WholeArray


def schema() -> dict[str, Any]:
    """The JSON Schema of decks, as a dict; [every key of a deck](deck.md) is the same as a page."""
    return json.loads(_core.schema())


class Deck:
    """A deck, read once and built as often as wanted.

    path: of the file; meshes and tables are found from its folder. Faults of its syntax are a `DeckError`, a file that
    cannot be read a `FileError`.
    """

    def __init__(self, path: AnyPath) -> None:
        self._core = _core.Deck(Path(path))

    @classmethod
    def from_text(cls, text: str, folder: AnyPath = ".", name: str = "deck.toml") -> Deck:
        """A deck of a text in TOML; files that it names are found from `folder`, and faults say that they are in `name`."""
        deck = cls.__new__(cls)
        deck._core = _core.Deck(text, Path(folder) / name)
        return deck

    @classmethod
    def from_dict(cls, tree: Mapping[str, Any], folder: AnyPath = ".", name: str = "deck.toml") -> Deck:
        """A deck of tables as dicts: `{"body": {"top": {"mass": 1.0, …}}, "load": [{"at": "top", …}], …}`; NumPy's numbers and arrays, too."""
        return cls.from_text("\n".join(f"{write_key(key)} = {write_value(value)}" for key, value in tree.items()) + "\n", folder, name)

    @property
    def text(self) -> str:
        """The deck as it was read."""
        return self._core.text

    @property
    def file(self) -> str:
        """The path by which faults name it."""
        return self._core.file

    def tree(self) -> dict[str, Any]:
        """The deck's tables as a dict, a copy; `from_dict` takes it back."""
        return copy.deepcopy(self._tables)

    @cached_property
    def _tables(self) -> dict[str, Any]:
        """The same, to be read only."""
        try:
            import tomllib
        except ImportError:  # before Python 3.11
            import tomli as tomllib
        return tomllib.loads(self.text)

    def build(self, overrides: Overrides | None = None) -> Model:
        """The deck checked and built as a `Model`. overrides: {key: value} as of `--set`, `{"parameters.E": 2e7, "load[0].force": [0, 0, 1]}`.

        Raises DeckError with all that is wrong.
        """
        return Model(self, overrides or {})

    def __reduce__(self):
        folder, name = os.path.split(self.file)
        return Deck.from_text, (self.text, folder, name)

    def __repr__(self):
        return f"gxrod.Deck({self.file!r})"


class Section(Shown):
    """A cross-section: its stiffness and mass and, where a shape was computed on cells, its constants and stresses.

    `Section.profile("IPE 200", {"E": 2.1e11, "nu": 0.3}, units="m, N")`, `Section.from_table` for every shape that `[section.NAME]` of a deck has, or
    `model.sections["post"]`. All is about the rod and in its section axes, y and z across, order x y z rx ry rz.
    """

    def __init__(self) -> None:
        raise TypeError("use Section.profile, Section.from_table, or the sections of a model")

    @classmethod
    def _of(cls, core):
        section = cls.__new__(cls)
        section._core = core
        section._table = None
        return section

    @classmethod
    def from_table(cls, table: Mapping[str, Any], units: str = "", folder: AnyPath = ".", **tables: Any) -> Section:
        """A section of a table as a deck has it: `{"shape": {…}, "material": {…}}`. tables: of the deck, such as `material={"steel": {…}}`.
        Raises DeckError with all that is wrong."""
        rod = {"section": "section", "line": {"from": [0, 0, 0], "to": [1, 0, 0]}, "y_axis": [0, 1, 0], "elements": 1}
        tree = {"units": units, **tables, "section": {"section": dict(table)}, "rod": {"rod": rod}, "support": [{"at": "rod.start", "fix": "all"}],
                "analysis": {"kind": "static"}}
        section = Deck.from_dict(tree, folder, "section").build().sections["section"]
        section._table = copy.deepcopy(dict(table))
        return section

    @classmethod
    def profile(cls, name: str, material: Mapping[str, Any], units: str = "", **keys: Any) -> Section:
        """A profile of the catalogue. material: as `material` of a section; units: the first of them says the length ("m, N"); keys: more of
        `shape`, such as `origin="shear centre"`, or `millimetre=1e-3` in place of units."""
        return cls.from_table({"shape": {"profile": name, **keys}, "material": dict(material)}, units)

    @property
    def name(self) -> str:
        """Its name in the deck."""
        return self._core.name

    @property
    def stiffness(self) -> Array:
        """[6, 6]: resultants from strains."""
        return self._core.stiffness

    @property
    def mass(self) -> Array:
        """[6, 6]: momenta from velocities, for each length."""
        return self._core.mass

    @property
    def shear_centre(self) -> Array:
        """[2]: where forces across cause no twist."""
        return self._core.shear_centre

    @property
    def tension_centre(self) -> Array:
        """[2]: where a force along causes no bending."""
        return self._core.tension_centre

    @property
    def constants(self) -> dict[str, Any]:
        """Of a shape on cells: `source`, `area`, `centroid` [2], `second_moment_y`, `second_moment_z` and `product_moment` about the centroid,
        `warping_stiffness` E Iw and `warping_length` √(E Iw/(G J))."""
        return dict(self._core.constants)

    @property
    def points(self) -> Array:
        """[n, 2]: where stresses are known: the nodes of the cells, once for each layer that meets there."""
        return self._core.points

    @property
    def layers(self) -> list[str]:
        """The layer of each point: a material, or a ply."""
        return list(self._core.layers)

    def stress(self, resultants: Sequence[float]) -> Array:
        """[n, 6]: the stresses xx yy zz yz xz xy at the points, of N, Vy, Vz, T, My, Mz."""
        wanted = np.asarray(resultants, float)
        if wanted.shape != (6,):
            raise ValueError(f"expected six resultants: N, Vy, Vz, T, My, Mz, got an array of shape {wanted.shape}")
        return self._core.operators @ wanted

    def von_mises(self, resultants: Sequence[float]) -> Array:
        """[n]: the von Mises stress at the points; NaN next to sharp re-entrant corners, where stress has no bound."""
        xx, yy, zz, yz, xz, xy = self.stress(resultants).T
        values = np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3.0 * (yz**2 + xz**2 + xy**2))
        return np.where(self._core.singular, np.nan, values)

    def draw(self, path: AnyPath, resultants: Sequence[float] | None = None) -> None:
        """Writes a picture, SVG: the layers, or coloured by the von Mises stress of N, Vy, Vz, T, My, Mz."""
        Path(path).write_text(self._core.draw(None if resultants is None else [float(value) for value in resultants]), encoding="utf-8")

    def to_deck(self) -> dict[str, Any]:
        """The table of a deck, for `from_dict`: as it was given, or its matrices."""
        if self._table is not None:
            return copy.deepcopy(self._table)
        return {"stiffness_matrix": self.stiffness.tolist(), "mass_matrix": self.mass.tolist()}

    def _headline(self):
        return f"gxrod.Section {self.name}"

    def _rows(self):
        return [(line.strip(), "") for line in self._core.describe().splitlines()[1:]]


class RodPlaces(NamedTuple):
    """Where a rod is in a model. `nodes` [n]: the rows of its nodes in states, from start to end. `arc_length` [n]: of these along it, at t = 0.
    `cells` [e,order+1]: the nodes of each element, likewise."""

    nodes: WholeArray
    arc_length: Array
    cells: WholeArray


class Model(Shown):
    """A deck that was checked and built; it never changes, any number of simulations may share it, and it can be pickled.

    `deck.build` makes it. `deck`: the Deck; `overrides`: what it was built with.
    """

    deck: Deck
    overrides: dict[str, Any]

    def __init__(self, deck: Deck, overrides: Overrides | None = None) -> None:
        self.deck, self.overrides = deck, dict(overrides or {})
        self._core = _core.Model(deck._core, [f"{key}={write_value(value)}" for key, value in self.overrides.items()])

    @property
    def notes(self) -> list[str]:
        """Choices that the reader made, a sentence each."""
        return list(self._core.notes)

    @property
    def nodes(self) -> int:
        """The number of nodes, N in shapes of a state."""
        return self._core.nodes

    @property
    def elements(self) -> int:
        """The number of rod elements, E in shapes of `sim.elements`."""
        return sum(len(rod.cells) for rod in self.rods.values())

    @property
    def rods(self) -> dict[str, RodPlaces]:
        """{name: where it is}: `model.rods["arm"].nodes` [n], the rows of its nodes in states."""
        return {name: RodPlaces(nodes=np.array(nodes), arc_length=np.array(lengths), cells=np.reshape(cells, (-1, order + 1)))
                for name, (nodes, lengths, cells, order) in self._core.rods.items()}

    @property
    def bodies(self) -> dict[str, int]:
        """{name: row of the body's node in states}."""
        return dict(self._core.bodies)

    @property
    def sections(self) -> dict[str, Section]:
        """{name: `Section`} of the deck, as they are at the start of a rod."""
        return {core.name: Section._of(core) for core in self._core.sections}

    @property
    def inputs(self) -> list[str]:
        """Names of the deck's inputs."""
        return list(self._core.inputs)

    @property
    def histories(self) -> list[str]:
        """Names of the deck's histories."""
        return list(self._core.histories)

    def check(self) -> list[str]:
        """What `gxrod check` finds about the model: a sentence each, notes, warnings and errors."""
        return list(self._core.examine())

    def node(self, point: str) -> int:
        """The row in states of a point that has a node: "arm.end", "arm.start", "arm@0.5", or a body.

        Raises Error for a point between nodes; `points` of a Simulation can be anywhere.
        """
        if point in self.bodies:
            return self.bodies[point]
        name, separator, fraction = point.partition("@")
        if not separator:
            name, _, end = point.rpartition(".")
            fraction = {"start": "0", "end": "1"}.get(end, "nan")
        if name not in self.rods:
            raise unknown_name("point", point, [*self.bodies, *(f"{rod}.{end}" for rod in self.rods for end in ("start", "end"))])
        rod = self.rods[name]
        wanted = float(fraction) * rod.arc_length[-1]
        nearest = int(np.abs(rod.arc_length - wanted).argmin())
        if not abs(rod.arc_length[nearest] - wanted) <= 1e-9 * rod.arc_length[-1]:
            raise Error(f"{point} is between nodes; nodes of {name} are at the fractions {(rod.arc_length / rod.arc_length[-1]).round(6).tolist()}")
        return int(rod.nodes[nearest])

    def __reduce__(self):
        return Model, (self.deck, self.overrides)

    def _headline(self):
        return f"gxrod.Model of {self.deck.file}: {self.nodes} nodes, {self.elements} elements"

    def _rows(self):
        return [(key, value) for key, value in self.overrides.items()]


OF_POINTS = ("position", "displacement", "rotation_vector", "orientation", "velocity", "angular_velocity", "angular_velocity_material", "acceleration")
OF_RODS = ("force", "moment", "force_spatial", "moment_spatial", "strain", "curvature")


def add_points(model: Model, points: Mapping[str, str]) -> Model:
    """The model with a history of each point, by its name, that records all that points of rods or bodies have."""
    if not points:
        return model
    there = model.overrides.get("history", model.deck._tables.get("history", []))
    more = [{"name": name, "at": at, "quantities": [*OF_POINTS, *(("centre_of_mass",) if at in model.bodies else OF_RODS)]} for name, at in points.items()]
    others = {key: value for key, value in model.overrides.items() if key != "history"}
    try:
        return Model(model.deck, {"history": [*there, *more], **others})
    except DeckError as error:
        raise DeckError(fault._replace(file="points") if fault.file.startswith("--set history=") else fault for fault in error.faults) from None


def write_key(key):
    return key if key.replace("_", "").replace("-", "").isalnum() else json.dumps(key)


def write_value(value):
    """A value in TOML: numbers to the last bit, texts in quotes."""
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        text = repr(value)
        return text if "e" not in text or "." in text.split("e")[0] else text.replace("e", ".0e")
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(str(value), ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{write_key(str(key))} = {write_value(each)}" for key, each in value.items()) + " }"
    if isinstance(value, Sequence):
        return "[" + ", ".join(map(write_value, value)) + "]"
    raise TypeError(f"a deck has numbers, booleans, texts, lists and tables; {value!r} is a {type(value).__name__}")
