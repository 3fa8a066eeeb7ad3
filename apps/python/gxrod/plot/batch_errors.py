"""The table of a batch as errors over the key that it refines."""

import json
import re

import numpy as np

from ..batches import read_batch
from ..errors import FileError
from .error_lines import Line, Panel
from .errors import FileFault, UsageError

FINER_IF_LARGER = ("elements", "steps")
FINER_IF_SMALLER = ("time_step", "min_step", "max_step", "first_step", "step", "tolerance")


class BatchErrors:
    """The table of a batch as errors over the key that it refines."""

    def __init__(self, folder, request):
        self.folder, self.request = folder, request
        try:
            self.columns = read_batch(folder, as_arrays=True)
            self.record = json.loads((folder / "batch.json").read_text(encoding="utf-8"))
        except (FileError, OSError, ValueError) as error:
            raise FileFault(str(error)) from error
        self.done = self.columns["status"] == "done"
        if self.record["combine"] == "latin-hypercube":
            raise UsageError(f"{folder}: holds random samples, whose errors fall with nothing; `gxrod report` draws them")
        self.meanings = {column["name"]: column["description"] for column in self.record["columns"]}
        self.varied = [key for key in self.record["parameters"] if len(set(self.columns[key].tolist())) > 1]
        self.key = self.choose_key()
        self.sign = self.choose_direction()

    def choose_key(self):
        numbers = [key for key in self.varied if np.issubdtype(self.columns[key].dtype, np.number) and (self.columns[key] > 0).all()]
        if wanted := self.request.x:
            matching = [key for key in numbers if key in (wanted, f"parameters.{wanted}") or key.endswith(f".{wanted}")]
            if len(matching) != 1:
                raise UsageError(f"--x {wanted}: not a key of positive numbers that differs between cases; {say_names(numbers)}")
            return matching[0]
        known = [key for key in numbers if last_word(key) in FINER_IF_LARGER + FINER_IF_SMALLER]
        if not known:
            raise UsageError(f"{self.folder}: varies neither elements nor steps nor a step or tolerance; --x takes the key that is refined; "
                             + say_names(numbers))
        return max(known, key=lambda key: len(set(self.columns[key].tolist())))

    def choose_direction(self):
        """1 if larger numbers of the key are finer, else -1; by the changes of the values if the key does not say so."""
        word = last_word(self.key)
        if word in FINER_IF_LARGER + FINER_IF_SMALLER:
            return 1 if word in FINER_IF_LARGER else -1
        votes = 0
        for name in self.names():
            for rows in self.groups().values():
                changes = np.abs(np.diff(self.columns[name][self.finite(name, rows)]))
                votes += int(np.sign(changes[0] - changes[-1])) if len(changes) > 1 else 0
        if votes == 0:
            raise UsageError(f"{self.folder}: which end of {self.key} is finer does not show; --x takes another key")
        return 1 if votes > 0 else -1

    def names(self):
        wanted = self.request.y or list(self.meanings)
        for name in wanted:
            if name not in self.meanings:
                raise UsageError(f"--y {name}: the batch collects no such column; {say_names(self.meanings)}")
        if not wanted:
            raise UsageError(f"{self.folder}: collects nothing; [collect] of the plan says what errors are of")
        return wanted

    def groups(self):
        """{values of the other keys: rows by rising numbers of the key}; one group where all keys change together."""
        others = [key for key in self.varied if key != self.key]
        numbers = self.columns[self.key]
        if len(set(numbers.tolist())) == len(numbers):
            others = []
        groups = {}
        for row in np.flatnonzero(self.done):
            groups.setdefault(tuple(self.columns[key][row] for key in others), []).append(row)
        self.others = others
        return {values: sorted(rows, key=lambda row: numbers[row]) for values, rows in groups.items()}

    def panels(self):
        names = self.names()
        if self.request.reference is not None and any(self.is_error(name) for name in names):
            raise UsageError("--reference: the plan has a `reference`, from which the column's values are distances already; leave one of them out")
        if self.request.reference is not None and len(names) > 1:
            raise UsageError(f"--reference is of one column; --y takes one of {', '.join(names)}")
        found = [self.panel(name) for name in names]
        if not any(panel.lines for panel in found):
            raise UsageError(f"{self.folder}: too few cases are done: a line needs two errors, and without a reference one more run")
        return [panel for panel in found if panel.lines]

    def is_error(self, name):
        """Whether the plan has a reference for a column, so that its values are distances from it."""
        return ", distance from " in self.meanings[name]

    def panel(self, name):
        is_error = self.is_error(name)
        lines = []
        for values, rows in self.groups().items():
            rows = self.finite(name, rows)[:: self.sign]
            label = ", ".join(f"{short(key)} = {value}" for key, value in zip(self.others, values))
            if line := self.line(label, self.columns[self.key][rows].astype(float), self.columns[name][rows], is_error):
                lines.append(line)
        reference = "the reference of the plan" if is_error else "the finest run" if self.request.reference is None else f"{self.request.reference:g}"
        if reference == "the finest run" and len(lines) > 1:
            reference += " of each line"
        if lost := int((~self.done).sum()):
            reference += f"; without {lost} of {len(self.done)} cases, which are not done"
        return Panel(f"{name}: {self.meanings[name]}", self.key, f"error of {name}", reference, lines)

    def finite(self, name, rows):
        """Those of these rows that have a value."""
        return [row for row in rows if np.isfinite(self.columns[name][row])]

    def line(self, label, x, values, is_error):
        if len(values) < 2:
            return None
        if self.request.reference is not None:
            errors, finest = np.abs(values - self.request.reference), None
        elif is_error:
            errors, finest = np.abs(values), None
        elif len(values) < 3:
            return None
        else:
            errors, finest = np.abs(values - values[-1])[:-1], x[-1]
        size = 0.0 if is_error else float(np.abs(values).max())
        return Line(label, x[: len(errors)], values[: len(errors)], errors, size, finest) if len(errors) > 1 else None


def say_names(names):
    return "there are " + ", ".join(names) if names else "there is none"


def last_word(key):
    return re.split(r"[.\]]", key)[-1]


def short(key):
    return key.removeprefix("parameters.") if key.startswith("parameters.") else last_word(key)
