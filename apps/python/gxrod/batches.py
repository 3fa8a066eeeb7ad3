"""Batches: many variants of a deck, run by the program, and their table."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np

from .errors import FileError
from .program import NOT_CONVERGED, run_program
from .results.tabular import as_objects, import_pandas
from .typed import AnyPath

if TYPE_CHECKING:
    import pandas
    from numpy.typing import NDArray

TEXTS = ("status", "reason", "results", "warning", "deck")  # columns that are texts even if all of them are empty
WHOLE = ("case", "steps", "newton_iterations", "rejected_steps")


def batch(plan: AnyPath | Sequence[AnyPath], folder: AnyPath | None = None, jobs: int | None = None, only: tuple[int, int] | None = None, retry_failed: bool = False, force: bool = False,
          quiet: bool = False) -> Path:
    """Runs the batch of a plan by the program `gxrod batch`; returns the folder with its table, for `read_batch`.

    plan: a TOML file, or a list of decks. folder: of the batch; by default the plan's name, in the current folder. jobs: how many cases run at
    once; by default one a core. only: (first, last) numbers of cases. retry_failed: also runs those again that are not
    done. force: discards what the folder holds. quiet: prints nothing of what the program says meanwhile.

    A batch that was stopped is resumed. Cases that fail are rows of the table with their status and reason; no exception
    is raised for them. Raises DeckError for faults in the plan or its decks, FileError, or KeyboardInterrupt.
    """
    plans = [plan] if isinstance(plan, (str, os.PathLike)) else list(plan)
    arguments = ["batch", *plans, "--summary", "-"]
    for option, value in (("--output", folder), ("--jobs", jobs), ("--only", f"{only[0]}..{only[1]}" if only else None)):
        arguments += [option, value] if value is not None else []
    arguments += ["--retry-failed"] if retry_failed else []
    arguments += ["--force"] if force else []
    printed = run_program(arguments, quiet, accept=(0, NOT_CONVERGED))
    return Path(json.loads(printed[printed.index("{"):])["folder"])


@overload
def read_batch(folder: AnyPath, as_arrays: Literal[False] = False) -> pandas.DataFrame: ...
@overload
def read_batch(folder: AnyPath, as_arrays: Literal[True]) -> dict[str, NDArray[Any]]: ...
def read_batch(folder: AnyPath, as_arrays: bool = False) -> pandas.DataFrame | dict[str, NDArray[Any]]:
    """The table of a batch: a pandas.DataFrame with a row for each case.

    folder: of the batch, or its index.csv. Columns: `case`, the parameters by their keys, `status`, `reason`, what the
    plan collects, `steps`, `newton_iterations`, `rejected_steps`, `time`, `seconds`, `results`, `warning`. Numbers are
    numbers, parameters also whole ones and booleans; what a case does not have is NaN, of texts "".
    as_arrays: a dict of NumPy arrays [cases] instead, without pandas. Raises FileError if there is no table there.
    """
    path = Path(folder)
    path = path / "index.csv" if path.is_dir() else path
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = csv.reader(file)
            names = next(rows, None)
            cells = [row for row in rows if names and len(row) == len(names)]  # a running batch may be writing its last one
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror}; gxrod.batch writes it") from error
    if not names or names[0] != "case":
        raise FileError(f"{path}: is not the table of a batch")
    parameters = names[1 : names.index("status")] if "status" in names else []
    columns = {name: read_cells([row[i] for row in cells], name in TEXTS, name in WHOLE or name in parameters)
               for i, name in enumerate(names)}
    return columns if as_arrays else import_pandas().DataFrame(columns)


def read_cells(texts, are_texts, can_be_whole):
    """A column as what its cells are: whole numbers, numbers, booleans or texts."""
    filled = [text for text in texts if text]
    if are_texts:
        return as_objects(texts)
    if can_be_whole and len(filled) == len(texts):
        if filled and set(filled) <= {"true", "false"}:
            return np.array([text == "true" for text in texts])
        if all(is_whole(text) for text in filled):
            return np.array([int(text) for text in texts], dtype=np.int64)
    try:
        return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        return as_objects(texts)


def is_whole(text):
    digits = text.removeprefix("-")
    return digits.isascii() and digits.isdigit() and len(digits) <= 18
