"""What touches in each frame: where, and with what forces."""

from __future__ import annotations

from collections.abc import Iterator
from typing import overload

import numpy as np

from ..typed import Array, WholeArray
from .display import Shown
from .frames import read_rod_table
from .source import Source, read_column
from .tables import Table

GROUP = "contacts"
COLUMNS = ("rods", "places", "point", "normal_force", "friction_force", "gap", "slides")


class Contacts(Shown):
    """What touches, frame by frame: `r.contacts[-1].normal_force` [K,3], `len(r.contacts)`. Empty frames where nothing touches, or the deck has no contact."""

    def __init__(self, source: Source) -> None:
        self._source = source

    @property
    def time(self) -> Array:
        """Times of all frames [F]; in statics load factors."""
        return self._source.frame_times

    @property
    def offsets(self) -> WholeArray:
        """[F+1]: the rows `offsets[f]` to `offsets[f + 1]` of the file's tables are those of frame f."""
        count = len(self._source.frame_times) + 1
        read = lambda file: file[GROUP]["offsets"][:count] if GROUP in file else np.zeros(count, dtype=np.int64)
        return self._source.once("contact offsets", read)

    @property
    def obstacles(self) -> list[str]:
        """Names of the obstacles, in the order of the deck."""
        has_names = lambda file: GROUP in file and "obstacle" in file[GROUP]
        return self._source.once("obstacles", lambda file: list(read_column(file[GROUP]["obstacle"])) if has_names(file) else [])

    @property
    def bodies(self) -> list[str]:
        """Names of all bodies, in the order of the deck, if some can touch."""
        has_names = lambda file: GROUP in file and "body" in file[GROUP]
        return self._source.once("bodies that touch", lambda file: list(read_column(file[GROUP]["body"])) if has_names(file) else [])

    def __len__(self) -> int:
        return len(self._source.frame_times)

    def __iter__(self) -> Iterator[ContactFrame]:
        return (self[number] for number in range(len(self)))

    @overload
    def __getitem__(self, which: int) -> ContactFrame: ...
    @overload
    def __getitem__(self, which: slice) -> list[ContactFrame]: ...
    def __getitem__(self, which):
        if isinstance(which, slice):
            return [self[number] for number in range(len(self))[which]]
        number = range(len(self))[which]
        first, end = self.offsets[number], self.offsets[number + 1]

        def read(file):
            if GROUP not in file:
                return {name: np.empty((0, 3) if name in ("point", "normal_force", "friction_force") else (0, 2) if name in ("rods", "places") else 0)
                        for name in COLUMNS}
            return {name: file[GROUP][name][first:end] for name in COLUMNS}

        columns = self._source.read(read)
        columns["rods"] = columns["rods"].astype(np.int64)
        columns["slides"] = columns["slides"].astype(bool)
        columns["force"] = columns["normal_force"] + columns["friction_force"]
        return ContactFrame(self, number, columns)

    def nearest(self, time: float) -> ContactFrame:
        """The frame nearest to a time; in statics to a load factor."""
        return self[int(np.abs(self.time - time).argmin())]

    def _headline(self):
        most = int(np.diff(self.offsets).max()) if len(self) else 0
        return f"contacts in {len(self)} frames, at most {most} in one"


class ContactFrame(Table):
    """What touches in one frame, a row each: `rods` and `places` [K,2], `point`, `force`, `normal_force`, `friction_force` [K,3], `gap`, `slides` [K].

    `rods` are rows of `/rods`; of N rods N + i is body i, −1 − j obstacle j; `names` has their names. `places` are fractions of the lengths.
    Forces are on the first of both; `slides` is False where friction holds.
    """

    def __init__(self, contacts, number, columns):
        super().__init__("contacts", columns)
        self._contacts, self.number = contacts, number

    @property
    def time(self) -> float:
        """Of the frame; in statics its load factor."""
        return float(self._contacts.time[self.number])

    @property
    def names(self) -> list[tuple[str, str]]:
        """[K] names of the rod or body and of what it touches."""
        parts = list(read_rod_table(self._contacts._source)["name"]) + self._contacts.bodies
        obstacles = self._contacts.obstacles
        name = lambda index: parts[index] if index >= 0 else obstacles[-1 - index]
        return [(name(a), name(b)) for a, b in self.rods]

    def of(self, name: str, other: str | None = None) -> Array:
        """The sum of all forces on the rod, body or obstacle of this name [3], by all that touches it or by another one alone."""
        total = np.zeros(3)
        for (first, second), force in zip(self.names, self.force):
            for own, partner, sign in ((first, second, 1.0), (second, first, -1.0)):
                if own == name and other in (None, partner):
                    total += sign * force
        return total
