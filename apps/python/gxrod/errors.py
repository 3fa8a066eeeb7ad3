"""What gxrod raises. All are `gxrod.Error`, and all can be pickled, so that they come back from other processes."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import Any, NamedTuple


class Error(Exception):
    """Anything that gxrod reports; its text is a sentence or more for the user."""


class Fault(NamedTuple):
    """One error in a deck or plan.

    `file`: as it was named; "" if the fault is in none. `line`: from 1; 0 of a value that is in no file. `column`: from 1, in
    characters. `key`: its full path, as "rod.flyer.section" or "load[0].force[1]"; "" of an error of syntax. `message`.
    """

    file: str = ""
    line: int = 0
    column: int = 0
    key: str = ""
    message: str = ""

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}:{self.column}" if self.line else self.file
        return ": ".join(filter(None, (place, self.key, self.message)))


class DeckError(Error):
    """A deck or plan that cannot be run. Its text has a line for each of its `faults`."""

    def __init__(self, faults: Iterable[Any]) -> None:
        super().__init__(tuple(Fault(message=fault) if isinstance(fault, str) else Fault(*fault) for fault in faults))

    @property
    def faults(self) -> tuple[Fault, ...]:
        """All errors, in the order of the deck."""
        return self.args[0]

    def __str__(self) -> str:
        return "\n".join(map(str, self.faults))


class ConvergenceError(Error):
    """A step that failed. The simulation keeps the last accepted state.

    `time`: where the step starts, in statics the load factor. `time_step`: the shortest that was tried. `outcome`: what
    became of it, as "out of iterations". `places`: where, the worst first, as "flyer.end (ry)". `advice`: what to try,
    the likeliest first. Unknown numbers are NaN.
    """

    def __init__(self, message: str, time: float = float("nan"), time_step: float = float("nan"), outcome: str = "", places: Iterable[str] = (), advice: Iterable[str] = ()) -> None:
        super().__init__(message)
        self.time, self.time_step, self.outcome = time, time_step, outcome
        self.places, self.advice = tuple(places), tuple(advice)


class FileError(Error):
    """A file could not be read or written, or is not what it should be. Its text begins with the path."""


class EvaluationError(Error):
    """An expression or function of the deck gave something that is not a finite number."""


class UnknownNameError(Error, KeyError, AttributeError):
    """A name that is not there: as a key, `r["tpi"]`, or as an attribute, `r["tip"].positoin`."""

    def __str__(self) -> str:
        return str(self.args[0])


def unknown_name(what: str, name: object, names: Iterable[object]) -> UnknownNameError:
    """An UnknownNameError that says which name was likely meant, and which there are: of `what`, as "history"."""
    there = [str(each) for each in names]
    meant = difflib.get_close_matches(str(name), there, n=1)
    most_named = 20
    more = f" and {len(there) - most_named} more" if len(there) > most_named else ""
    there_are = f"there are {', '.join(there[:most_named])}{more}" if len(there) > 1 else \
        f"there is {there[0]}" if there else "there are none"
    return UnknownNameError(f"there is no {what} {name!r}; " + (f"did you mean {meant[0]!r}? " if meant else "") + there_are)
