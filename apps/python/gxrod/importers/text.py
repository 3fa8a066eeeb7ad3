"""Lines of text files, and what is wrong with them: file, line, what was expected, what to do."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from difflib import get_close_matches
from pathlib import Path

from ..errors import FileError
from ..typed import AnyPath


class ImportFault(FileError):
    """A file that cannot be imported. Its text begins with path and line, and ends with what to do."""


class Lines:
    """The lines of a file, from 1, and where a reader stands: `at` is the line that it reads next."""

    def __init__(self, path: AnyPath) -> None:
        self.path = Path(path)
        self.lines = read_text(self.path).splitlines()
        self.at = 1

    def fault(self, message: str, todo: str, line: int | None = None) -> ImportFault:
        """The error of a line, by default of the one that was read last; `line` 0 is the whole file."""
        line = max(self.at - 1, 1) if line is None else line
        place = f"{self.path}:{line}" if line else str(self.path)
        return ImportFault(f"{place}: {message}; {todo}")

    def __getitem__(self, line: int) -> str:
        return self.lines[line - 1]

    @property
    def is_over(self) -> bool:
        return self.at > len(self.lines)

    def next(self, what: str, skip_empty: bool = False) -> str:
        """The next line; an error says what was expected there."""
        while skip_empty and not self.is_over and not self[self.at].strip():
            self.at += 1
        if self.is_over:
            raise self.fault(f"the file ends here; expected {what}", "look whether it is whole", len(self.lines))
        self.at += 1
        return self[self.at - 1]

    def find(self, is_meant: Callable[[str], bool]) -> int:
        """The first line that is meant, from 1; 0 if none is."""
        return next((i for i, line in enumerate(self.lines, 1) if is_meant(line)), 0)

    def numbers(self, count: int, what: str, exact: bool = False) -> list[float]:
        """The first `count` numbers of the next line that is not empty, whose words are apart by blanks or commas; if `exact`, all of it."""
        wanted = f"{count} number{'s' * (count > 1)} ({what})"
        words = self.next(wanted, skip_empty=True).replace(",", " ").split()
        expected = f"expected {wanted}"
        if len(words) < count or exact and len(words) != count:
            raise self.fault(f"{expected}, found {len(words)}", "correct this line, or the count that announces it")
        return [self.number(word, expected) for word in words[:count]]

    def numbers_after(self, key: str) -> list[float]:
        """The numbers that follow a key in its line; the next line to read is the one after it."""
        self.at = self.find(lambda line: line.split()[:1] == [key]) + 1
        if self.at == 1:
            raise self.fault(f"there is no line with {key}", "add it", 0)
        return [self.number(word, f"expected a number for {key}") for word in self[self.at - 1].split()[1:2]] or [self.number("", f"expected a number for {key}")]

    def number(self, word: str, expected: str) -> float:
        """A number of the line that was read last, also with an exponent D of Fortran."""
        value = to_number(word)
        if value is None:
            raise self.fault(f'{expected}, found "{word[:40]}"', "correct this line, or the count that announces it")
        return value


class UnusedKeys:
    """Keys of a file that a reader does not use. Those that a deck does not need are named in a note; others, unknown ones, in a warning each, with a key that looks like it."""

    def __init__(self, what: str, used: Iterable[str], not_needed: Iterable[str]) -> None:
        self.what = what
        self.names = list(used)
        self.not_needed = {name.lower(): name for name in not_needed}
        self.found: dict[str, str] = {}

    def add(self, name: str) -> None:
        """Once, whatever the capitals."""
        self.found.setdefault(name.lower(), name)

    def notes(self, purpose: str) -> list[str]:
        idle = [name for key, name in self.found.items() if key in self.not_needed]
        return [f"not used, for {purpose}: {', '.join(idle)}"] if idle else []

    def warnings(self) -> list[str]:
        return [f"the {self.what} {name[:40]} is unknown and was not used{self.similar(key)}" for key, name in self.found.items() if key not in self.not_needed]

    def similar(self, key: str) -> str:
        known = {name.lower(): name for name in [*self.names, *self.not_needed.values()]}
        close = get_close_matches(key, known, 1, 0.7)
        return f"; is {known[close[0]]} meant?" if close else ""


def to_number(word: str) -> float | None:
    """The finite number that a word is, or None."""
    try:
        value = float(word.replace("D", "E").replace("d", "e"))
    except ValueError:
        return None
    return value if abs(value) < float("inf") else None


def read_text(path: Path) -> str:
    """The text of a file; bytes that are not UTF-8 are those of Latin-1."""
    try:
        data = path.read_bytes()
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror or error}") from error
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def find_beside(named: str, places: Iterable[Path]) -> tuple[Path | None, list[Path]]:
    """The first file that is there of a name that another file gives, and all that were tried."""
    relative = named.replace("\\", "/")
    tried = list(dict.fromkeys(each for place in places for each in (place / relative, place / Path(relative).name)))
    return next((each for each in tried if each.is_file()), None), tried
