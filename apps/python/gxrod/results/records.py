"""What was recorded at each step: histories, the ledger, the solver's record, inputs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np

from ..errors import unknown_name
from ..typed import Array
from .display import Shown, shape_text
from .source import Source, plain
from .tabular import import_pandas, import_xarray

if TYPE_CHECKING:
    import pandas
    import xarray

T = TypeVar("T")


class Quantity(NamedTuple):
    """What an array is: `name`, `description`, `frame`, `dimension`, `unit`, `shape`.

    `frame`: "spatial", global axes; "material", section or body axes; "axes of POINT"; or "none". `dimension`: as "force·length";
    "1" of plain numbers. `unit`: as "N·m", if the deck's `units` name units that are known; else "".
    """

    name: str
    description: str
    frame: str
    dimension: str
    unit: str
    shape: tuple[int, ...]


class Record(Mapping[str, Array], Shown):
    """Quantities over the steps, as attributes and by name: `r.ledger.energy_error`, `r.ledger["energy_error"]`.

    Each is an array with a row for each accepted step, the state at t = 0 included: [S] of numbers, [S,3] of vectors
    (x, y, z), [S,4] of quaternions (w, x, y, z). Arrays are read when asked for, and not kept.
    """

    _rows_are = "steps"

    def __init__(self, source: Source, path: str, what: str) -> None:
        self._source, self._path, self._what = source, path, what

    @property
    def time(self) -> Array:
        """Time at the end of each step [S]; in statics the load factor, along a path its arc length."""
        return self._source.times

    @property
    def _along(self):
        """What the rows go along, and its unit."""
        return self._source.time_name, self._source.time_unit

    @property
    def names(self) -> list[str]:
        """Names of the quantities."""
        return list(self._quantities)

    def describe(self, name: str) -> Quantity:
        """What a quantity is: a `Quantity` with description, frame, dimension, unit and shape."""
        return self._quantities[self._check(name)]

    def to_pandas(self) -> pandas.DataFrame:
        """A pandas.DataFrame with the time as index; columns as in `gxrod export --csv`: position_x, position_y, position_z."""
        pandas = import_pandas()
        columns: dict[str, Array] = {}
        for name, values in self.items():
            columns.update(split_components(name, values))
        return pandas.DataFrame(columns, index=pandas.Index(self.time, name=self._along[0]))

    def to_xarray(self) -> xarray.Dataset:
        """An xarray.Dataset with the dimensions time and component (x, y, z) or quaternion (w, x, y, z).

        Attributes of each array: long_name, units (where the deck's label names them), frame, dimension.
        """
        xarray = import_xarray()
        along, unit = self._along
        arrays = {name: variable_of(values, along, self.describe(name)) for name, values in self.items()}
        coordinates = {along: (along, self.time, {"units": unit} if unit else {})}
        used = {dims[1] for dims, *_ in arrays.values() if len(dims) > 1}
        coordinates.update({name: list(letters) for name, letters in AXES.items() if name in used})
        return xarray.Dataset(arrays, coordinates, self._attributes())

    def _attributes(self):
        return {}

    @property
    def _quantities(self):
        return self._source.once(("quantities", self._path), self._read_quantities)

    def _read_quantities(self, file):
        found = {}
        for name, dataset in file[self._path].items():
            if name != "time":
                text = lambda key, dataset=dataset: plain(dataset.attrs.get(key, ""))
                shape = (len(self.time), *dataset.shape[1:])
                found[name] = Quantity(name, text("description"), text("frame"), text("dimension"),
                                       self._source.unit(text("dimension")), shape)
        return found

    def _check(self, name):
        if name not in self._quantities:
            raise unknown_name(f"quantity of {self._what}", name, self._quantities)
        return name

    def __getitem__(self, name: str) -> Array:
        self._check(name)
        return self._source.read(lambda file: file[self._path][name][: len(self.time)])

    def __getattr__(self, name: str) -> Array:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(name for name in self._quantities if name.isidentifier())]

    def __iter__(self) -> Iterator[str]:
        return iter(self._quantities)

    def __len__(self) -> int:
        return len(self._quantities)

    def __contains__(self, name: object) -> bool:
        return name in self._quantities

    def __eq__(self, other: object) -> bool:
        return self is other

    __hash__ = object.__hash__

    def _ipython_key_completions_(self):
        return self.names

    def _headline(self):
        return f"{self._what}: {len(self.time)} {self._rows_are}"

    def _rows(self):
        return [(each.name, shape_text(each.shape), each.unit or each.dimension, each.frame, each.description)
                for each in self._quantities.values()]


class History(Record):
    """What the deck's `[[history]]` records at a point, joint or spring: `r["tip"].position` [S,3]."""

    def __init__(self, source: Source, name: str, group: str = "histories") -> None:
        super().__init__(source, f"{group}/{name}", f"history {name}")
        self.name = name

    @property
    def at(self) -> str:
        """The point, as the deck names it: "arm.end"."""
        return self._group_attributes.get("at", "")

    @property
    def relative_to(self) -> str:
        """The point in whose axes it is recorded; "" for the global axes."""
        return self._group_attributes.get("relative_to", "")

    @property
    def _group_attributes(self):
        return self._source.once(("attributes", self._path),
                                 lambda file: {name: plain(value) for name, value in file[self._path].attrs.items()})

    def _attributes(self):
        return {key: value for key, value in (("at", self.at), ("relative_to", self.relative_to)) if value}

    def _headline(self):
        return f"{super()._headline()}, at {self.at}" + (f" relative to {self.relative_to}" if self.relative_to else "")


class SampledHistory(History):
    """The same at the multiples of `output.history_interval`: `r.sampled["tip"].position` [T,3] at its own `time` [T]."""

    _rows_are = "samples"

    def __init__(self, source: Source, name: str) -> None:
        super().__init__(source, name, "sampled")

    @property
    def time(self) -> Array:
        """Time of each sample [T]."""
        return self._source.sample_times

    @property
    def _along(self):
        return "time", self._source.unit("time")


# Names of components, by what xarray calls their dimension.
AXES = {"component": tuple("xyz"), "quaternion": tuple("wxyz"), "stress_component": ("xx", "yy", "zz", "yz", "xz", "xy"),
        "principal": tuple("123"), "section_axis": tuple("yz")}
DIMENSIONS = {2: "section_axis", 4: "quaternion", 6: "stress_component"}


def split_components(name, values):
    """{name: column} of numbers, {name_x: …} of vectors and quaternions."""
    if values.ndim == 1:
        return {name: values}
    return {f"{name}_{label}": values[:, i] for i, label in enumerate(component_labels(name, values.shape[1]))}


def component_dimension(name, width):
    return "principal" if name == "principal_stress" else DIMENSIONS.get(width, "component")


def component_labels(name, width):
    """x y z of vectors, w x y z of quaternions, xx to xy of stresses, 1 2 3 of principal ones, y z of places in a section."""
    return AXES[component_dimension(name, width)]


def variable_of(values, along, quantity):
    """Dimensions, values and attributes of an array of xarray."""
    dims = (along,) if values.ndim == 1 else (along, component_dimension(quantity.name, values.shape[1]))
    return dims, np.asarray(values), attributes_of(quantity)


def attributes_of(quantity):
    """Of an array of xarray: those that are known."""
    attributes = {"long_name": quantity.description, "units": quantity.unit, "frame": quantity.frame,
                  "dimension": quantity.dimension}
    return {key: text for key, text in attributes.items() if text}


PLURALS = {"history": "histories"}


class Named(Mapping[str, T], Shown):
    """Things by their names, a mapping that cannot be changed: `r.histories["tip"]`, `list(r.rods)`. A name that is not there is answered with the nearest one."""

    def __init__(self, what: str, names: Iterable[str], make: Callable[[str], T]) -> None:
        self._what, self._list, self._make = what, list(names), make

    def __getitem__(self, name: str) -> T:
        if name not in self._list:
            raise unknown_name(self._what, name, self._list)
        return self._make(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._list)

    def __len__(self) -> int:
        return len(self._list)

    def _ipython_key_completions_(self):
        return self._list

    def _headline(self):
        return f"{len(self)} {self._what}" if len(self) == 1 else f"{len(self)} {PLURALS.get(self._what, self._what + 's')}"

    def _rows(self):
        return [(name, self[name]._headline()) for name in self._list]
