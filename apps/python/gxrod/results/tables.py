"""Tables of what a file lists: joints, springs, critical points."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from ..errors import unknown_name
from .display import Shown
from .records import split_components
from .source import read_column
from .tabular import as_objects, import_pandas

if TYPE_CHECKING:
    import pandas
    from numpy.typing import NDArray


class Table(Shown):
    """Rows with named columns: `r.joints.type`, `r.joints["type"]` [n], `r.joints.row("elbow")`, `len(r.joints)`."""

    def __init__(self, what: str, columns: dict[str, NDArray[Any]]) -> None:
        self._what, self._columns = what, columns

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self._columns)

    def row(self, which: int | str) -> dict[str, Any]:
        """A row as a dict: by its number, from 0, or by its `name`; UnknownNameError if no row has that name."""
        number = which
        if isinstance(which, str):
            names = list(self._columns.get("name", []))
            if which not in names:
                raise unknown_name(f"row of {self._what}", which, names)
            number = names.index(which)
        return {name: values[number] for name, values in self._columns.items()}

    def to_pandas(self) -> pandas.DataFrame:
        """A pandas.DataFrame; vectors have a column for each component, as axis_a_x."""
        columns: dict[str, Any] = {}
        for name, values in self._columns.items():
            columns.update(split_components(name, values) if values.ndim == 2 and values.shape[1] in (2, 3, 4) else {name: list(values)})
        return import_pandas().DataFrame(columns)

    def __getitem__(self, name: str) -> NDArray[Any]:
        if name not in self._columns:
            raise unknown_name(f"column of {self._what}", name, self._columns)
        return self._columns[name]

    def __getattr__(self, name: str) -> NDArray[Any]:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __contains__(self, name: object) -> bool:
        return name in self._columns

    def __len__(self) -> int:
        return len(next(iter(self._columns.values()), ()))

    def __iter__(self) -> Iterator[dict[str, Any]]:
        return (self.row(number) for number in range(len(self)))

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._columns]

    def _ipython_key_completions_(self):
        return self.columns

    def _headline(self):
        return f"{self._what}: {len(self)} rows"

    def _rows(self):
        return [self.columns, *(list(row.values()) for row in self)] if len(self) else []


def read_table(source, path, what):
    """A group of columns of equal length; without rows if the file has no such group."""
    def read(file):
        if path not in file:
            return {}
        return {name: read_column(dataset) for name, dataset in file[path].items()}

    return Table(what, source.once(("table", path), read))


def table_of_deck(what, parts):
    """Of tables of the deck by their names {name: {key: value}}, as it writes them; None where one lacks a key."""
    keys = dict.fromkeys(key for part in parts.values() for key in part)
    columns = {"name": list(parts)} | {key: [part.get(key) for part in parts.values()] for key in keys}
    return Table(what, {key: as_objects(values) for key, values in columns.items()} if parts else {})


def parts_of_deck(deck, table, **wanted):
    """Parts of a table of the deck, as [joint.NAME], whose keys have these values."""
    parts = deck.get(table, {})
    parts = parts if isinstance(parts, Mapping) else {}
    return {name: part for name, part in parts.items() if all(part.get(key) == value for key, value in wanted.items())}
