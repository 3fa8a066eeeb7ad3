"""Stages: which steps are theirs, and what they have found: modes, factors, answers, sweeps, critical points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import FileError, unknown_name
from ..typed import Array
from .display import Shown, shape_text
from .records import Named, split_components
from .source import UNREADABLE, Source, check_is_file, import_h5py, plain, read_column
from .tables import Table, read_table
from .tabular import import_pandas

if TYPE_CHECKING:
    import pandas
    from numpy.typing import NDArray

# What a user calls it: what the file does.
ALIASES = {
    "frequencies": "frequency",
    "angular_frequencies": "omega",
    "growth_rates": "growth",
    "damping_ratios": "damping_ratio",
    "factors": "factor",
    "residuals": "residual",
    "errors": "error",
    "scales": "scale",
    "effective_masses": "effective_mass",
    "energy_shares": "energy_share",
    "values": "value",
    "speeds": "speed",
}


class Stage(Shown):
    """A stage of a run. Its steps are `rows` of the histories; what it has found are attributes.

    | kind | what it has |
    |---|---|
    | `modes` | `frequencies` [n] in cycles per time, `angular_frequencies` [n] in rad per time, `growth_rates` [n], `words` [n], `effective_masses` [n,6] along and about x, y, z, `total_mass` [6], `energy_shares` [n,rods,6], `shapes` |
    | `eigenvalues` | the same without masses; `damping_ratios` [n], `eigenvalues` [n], complex: growth + iω |
    | `eigenvalues` with a sweep | `values` [V] of the `key`, `angular_frequencies`, `growth_rates` [V,n], `mode_words` [V,n], `speeds` [V], `onsets`, with `shapes = true` also `shapes` |
    | `buckling` | `factors` [n], `words` [n], `shapes` |
    | `response` | `frequencies`, `angular_frequencies` [F], `histories["tip"].displacement` [F,3], complex |
    | `path` | `critical_points`, `branches`: tables |

    Names of the file's datasets work as well: `stage.omega`, `stage["omega"]`.
    """

    def __init__(self, source: Source, name: str) -> None:
        self._source, self.name = source, name
        self._path = f"stages/{name}"
        self._attributes, self._shapes_of = source.once(("stage", name), self._look)

    def _look(self, file):
        group = file[self._path]
        attributes = {key: plain(value) for key, value in group.attrs.items()}
        return attributes, {key: dataset.shape for key, dataset in group.items() if hasattr(dataset, "shape")}

    @property
    def kind(self) -> str:
        """As the deck has it: "static", "dynamic", "modes" …"""
        return self._attributes["kind"]

    @property
    def number(self) -> int:
        """From 0."""
        return self._attributes["number"]

    @property
    def attributes(self) -> dict[str, Any]:
        """What the file notes of the stage: a dict, of modes with `complete` (1: counted, none is missing), `limit` …"""
        return dict(self._attributes)

    @property
    def rows(self) -> slice:
        """Its steps: a slice of the histories, `r["tip"].position[stage.rows]`. Empty if it takes no steps."""
        column = self._source.once("stage column", lambda file: file["histories/stage"][()] if "stage" in file["histories"] else None)
        if column is None:
            return slice(0, len(self._source.times)) if self.kind not in ("modes", "eigenvalues", "buckling", "response") else slice(0, 0)
        rows = np.flatnonzero(column[: len(self._source.times)] == self.number)
        return slice(int(rows[0]), int(rows[-1]) + 1) if len(rows) else slice(0, 0)

    @property
    def time(self) -> Array:
        """Times of its steps."""
        return self._source.times[self.rows]

    @property
    def names(self) -> list[str]:
        """Names of what it has found."""
        return [ALIASED.get(name, name) for name in self._shapes_of]

    def __getitem__(self, name: str) -> Any:
        there = ALIASES.get(name, name)
        if there not in self._shapes_of:
            raise unknown_name(f"finding of stage {self.name}", name, self.names)
        return self._source.read(lambda file: read_column(file[self._path][there]))

    def __contains__(self, name: object) -> bool:
        return ALIASES.get(name, name) in self._shapes_of

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.names]

    def _ipython_key_completions_(self):
        return self.names

    def to_pandas(self) -> pandas.DataFrame:
        """A pandas.DataFrame with a row for each shape found, value or frequency; columns as in `gxrod export --csv`."""
        pandas = import_pandas()
        columns = {}
        for name, shape in self._shapes_of.items():
            if len(shape) == 1 and shape[0] == self._length:
                columns[name] = self[name]
            elif len(shape) == 2 and shape[0] == self._length:
                columns.update(self._split(name))
        index = pandas.RangeIndex(1, self._length + 1, name="number")
        return pandas.DataFrame(columns, index=index)

    @property
    def _length(self):
        first = next((shape for shape in self._shapes_of.values() if shape), (0,))
        return self._shapes_of.get("words", first)[0]

    def _split(self, name):
        letters = [f"{kind}{letter}" for kind in ("", "r") for letter in "xyz"]
        return {f"{name}_{letter}": column for letter, column in zip(letters, self[name].T)}

    def _headline(self):
        steps = self.rows.stop - self.rows.start
        return f"stage {self.name}: {self.kind}" + (f", {steps} steps" if steps else "")

    def _rows(self):
        return [(ALIASED.get(name, name), shape_text(shape)) for name, shape in self._shapes_of.items()]


ALIASED = {name: alias for alias, name in ALIASES.items()}


class ShapesStage(Stage):
    """Modes, eigenvalues or buckling."""

    @property
    def eigenvalues(self) -> NDArray[np.complex128]:
        """Growth + iω [n], complex, of modes and eigenvalues."""
        return self["growth"] + 1j * self["omega"]

    @property
    def shapes(self) -> Shapes:
        """The shapes, from the file beside the results: see `Shapes`."""
        return Shapes(self._source.path, self.name)

    def _rows(self):
        words = list(self["words"])
        first = "factors" if "factors" in self else "frequencies"
        rows = [(i, f"{value:.6g}", text) for i, (value, text) in enumerate(zip(self[first], words), 1)]
        return [("", first, ""), *rows]


class Sweep(Stage):
    """Eigenvalues over a number of the deck; NaN where a mode was lost."""

    @property
    def key(self) -> str:
        """The key of the deck that varies."""
        return self._attributes["key"]

    @property
    def eigenvalues(self) -> NDArray[np.complex128]:
        """Growth + iω [V,n], complex."""
        return self["growth"] + 1j * self["omega"]

    @property
    def mode_words(self) -> NDArray[np.object_]:
        """Each mode in words at each value [V,n]; "" where it was lost."""
        return self["words_at_values"].reshape(self._shapes_of["omega"])

    @property
    def shapes(self) -> SweepShapes:
        """The shapes at each value, of a sweep with `shapes = true`: see `SweepShapes`."""
        return SweepShapes(self._source.path, self.name, self._shapes_of["omega"])

    @property
    def onsets(self) -> Table:
        """Where motions begin or cease to grow: a table with value, omega, kind, begins."""
        return read_table(self._source, f"{self._path}/onset", "onsets")

    @property
    def _length(self):
        return self._shapes_of["value"][0]

    def to_pandas(self) -> pandas.DataFrame:
        """A pandas.DataFrame with a row for each value; omega_1, omega_2 … of the modes."""
        return super().to_pandas().set_index("value")

    def _split(self, name):
        return {f"{name}_{i}": column for i, column in enumerate(self[name].T, 1)}


class Answers(Shown):
    """Of one point under forces that swing: `displacement`, `rotation_vector`, `reaction_force`, `reaction_moment` [F,3],
    complex amplitudes in global axes; the motion is Re(amplitude · exp(iωt))."""

    def __init__(self, source, path, name):
        self._source, self._path, self.name = source, path, name

    @property
    def names(self) -> list[str]:
        """Names of the quantities."""
        return self._source.once(("answers", self._path), lambda file: list(file[self._path]))

    def __getitem__(self, name: str) -> NDArray[np.complex128]:
        if name not in self.names:
            raise unknown_name(f"answer of {self.name}", name, self.names)
        parts = self._source.read(lambda file: file[self._path][name][()])
        return parts[..., 0] + 1j * parts[..., 1]

    def __getattr__(self, name: str) -> NDArray[np.complex128]:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.names]

    def _headline(self):
        return f"answers of {self.name}: " + ", ".join(self.names)


class Response(Stage):
    """Answers to forces that swing."""

    @property
    def histories(self) -> Named[Answers]:
        """Answers by the names of the deck's histories."""
        path = f"{self._path}/histories"
        names = self._source.once(("answers", self.name), lambda file: list(file[path]))
        return Named("history", names, lambda name: Answers(self._source, f"{path}/{name}", name))

    @property
    def _length(self):
        return self._shapes_of["omega"][0]

    def to_pandas(self) -> pandas.DataFrame:
        """A pandas.DataFrame with a row for each frequency; complex columns, as tip_displacement_x."""
        table = super().to_pandas()
        for name, answers in self.histories.items():
            for quantity in answers.names:
                for column, values in split_components(f"{name}_{quantity}", answers[quantity]).items():
                    table[column] = values
        return table.set_index("omega")


class PathStage(Stage):
    """Equilibria along a path."""

    @property
    def critical_points(self) -> Table:
        """A table: kind, load_factor, row of the histories, branch, finding …"""
        return read_table(self._source, f"{self._path}/critical_points", "critical points")

    @property
    def branches(self) -> Table:
        """A table, the main path first: name, parent, critical_point, side, first_row, cause."""
        return read_table(self._source, f"{self._path}/branches", "branches")

    @property
    def shapes(self) -> Shapes:
        """The shapes at critical points, about the equilibrium there: see `Shapes`."""
        return Shapes(self._source.path, self.name, has_own_places=True)

    def to_pandas(self) -> pandas.DataFrame:
        """The critical points as a pandas.DataFrame."""
        return self.critical_points.to_pandas()

    def _rows(self):
        points = self.critical_points
        return [(number, row["finding"]) for number, row in enumerate(points)] if len(points) else []


class Shapes(Shown):
    """The n shapes that a stage has found, scaled for drawing: the largest displacement is a tenth of the model. In global axes.

    Read from the file beside the results, NAME.STAGE.vtkhdf; FileError if it is not there.
    """

    def __init__(self, results, stage, has_own_places=False):
        self._has_own_places = has_own_places
        self.path = results.with_name(f"{results.stem}.{stage}.vtkhdf")
        if not self.path.exists():
            raise FileError(f"{self.path}: there is no such file; it holds the shapes of stage {stage}")

    @property
    def position(self) -> Array:
        """Of the nodes in the equilibrium [N,3]; of a path at each of its points [n,N,3]."""
        def read(grid, count, points):
            values = grid["Points"][()]
            return values.reshape(count, points, 3) if self._has_own_places else values

        return self._read(read)

    @property
    def displacement(self) -> NDArray[Any]:
        """From there [n,N,3]; complex if the stage finds complex shapes."""
        return self._shapes("displacement")

    @property
    def rotation_vector(self) -> NDArray[Any]:
        """The turns of the nodes from there [n,N,3], in rad on the same scale; complex likewise."""
        return self._shapes("rotation_vector")

    def _shapes(self, name):
        def read(grid, count, points):
            fields = grid["PointData"]
            values = fields[name][()].reshape(count, points, 3)
            if f"{name}_imaginary" in fields:
                values = values + 1j * fields[f"{name}_imaginary"][()].reshape(count, points, 3)
            return values

        return self._read(read)

    def __len__(self) -> int:
        return self._read(lambda grid, count, points: count)

    def _read(self, function):
        check_is_file(self.path)
        try:
            with import_h5py().File(self.path, "r") as file:
                grid = file["VTKHDF"]
                return function(grid, len(grid["Steps/Values"]), int(grid["NumberOfPoints"][0]))
        except UNREADABLE as error:
            raise FileError(f"{self.path}: cannot be read as shapes of gxrod: {error}") from error

    def _headline(self):
        return f"{len(self)} shapes in {self.path.name}"


class SweepShapes(Shapes):
    """The shapes that a sweep has kept: for V values and n modes, `displacement` and `rotation_vector` [V,n,N,3], complex if the file has
    imaginary parts, about the `position` [V,N,3] at each value; 0 where a mode was lost. Scaled as `Shapes`."""

    def __init__(self, results, stage, size):
        super().__init__(results, stage, has_own_places=True)
        self._size = size

    @property
    def position(self) -> Array:
        """Of the nodes in the equilibrium at each value [V,N,3]."""
        places = super().position
        return places.reshape(*self._size, *places.shape[1:])[:, 0]

    def _shapes(self, name):
        values = super()._shapes(name)
        return values.reshape(*self._size, *values.shape[1:])

    def __len__(self) -> int:
        return self._size[0]

    def _headline(self):
        values, modes = self._size
        return f"shapes of {modes} modes at {values} values in {self.path.name}"


def read_stages(source: Source):
    """All stages of the file in their order, by their names."""
    def look(file):
        group = file.get("stages", {})
        return sorted(group, key=lambda name: int(plain(group[name].attrs["number"])))

    return Named("stage", source.once("stages", look), lambda name: make_stage(source, name))


def make_stage(source, name):
    stage = Stage(source, name)
    kind = (Sweep if "value" in stage else Response if stage.kind == "response" else PathStage if stage.kind == "path"
            else ShapesStage if "words" in stage else Stage)
    return kind(source, name)
