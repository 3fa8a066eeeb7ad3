"""Many runs of a deck: a row of numbers for each."""

from __future__ import annotations

import os
import pickle
import sys
import warnings
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import CancelledError, Executor, ThreadPoolExecutor, as_completed
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, overload

import numpy as np

from .errors import Error
from .results.tabular import as_objects, import_pandas
from .typed import AnyPath, Overrides

if TYPE_CHECKING:
    import pandas
    from numpy.typing import NDArray

    from .decks import Deck

ERROR = "error"


Collected: TypeAlias = "Mapping[str, str | Callable[[Any], Any]] | Callable[[Any], Mapping[str, Any]]"


@overload
def map(deck: Deck | AnyPath, cases: Iterable[Overrides] | pandas.DataFrame, collect: Collected, executor: Executor | None = None,
        on_error: Literal["record", "raise"] = "record", progress: bool | Callable[[int, int], object] = False, *,
        as_arrays: Literal[True], simulation: Callable[..., Any] | None = None, **options: Any) -> dict[str, NDArray[Any]]: ...
@overload
def map(deck: Deck | AnyPath, cases: Iterable[Overrides] | pandas.DataFrame, collect: Collected, executor: Executor | None = None,
        on_error: Literal["record", "raise"] = "record", progress: bool | Callable[[int, int], object] = False,
        as_arrays: Literal[False] = False, simulation: Callable[..., Any] | None = None, **options: Any) -> pandas.DataFrame: ...
def map(deck, cases, collect, executor=None, on_error="record", progress=False, as_arrays=False, simulation=None,
        **options) -> pandas.DataFrame | dict[str, NDArray[Any]]:
    """Runs a deck once for each case and collects numbers of each: a pandas.DataFrame with a row for each case, in their order.

    deck: a `gxrod.Deck`, or the path of one. cases: a list of dicts of what differs, as `deck.build` takes them, `{"parameters.E": 2e7}`; or a
    DataFrame whose columns are such keys. collect: {name: function}, called with the `Simulation` after its run; or
    {name: "tip.position"}, a quantity at the end; or one function that returns a dict. What they return are numbers,
    texts, or arrays [k], which become columns name[0] … name[k-1].

    executor: any `concurrent.futures.Executor`; by default threads, one a core, as runs leave Python's lock free.
    With processes all that is handed over must be pickled: functions with a name, no lambdas. on_error: "record": a case that fails is a
    row with its error's text in the column `error` and NaN for what it lacks; "raise": the first error is raised, and
    cases that have not begun are dropped. progress: writes how many are done to sys.stderr; or a function that is
    called with the numbers of cases done and of all. as_arrays: a dict of NumPy arrays [cases] instead, for which pandas is not needed.
    simulation: what makes a simulation of a model, by default `gxrod.Simulation`; options are handed to it, as
    `record=("ledger", "tip")`.

    Columns: the keys of the cases, what is collected, `error` (None without one).
    """
    if on_error not in ("record", "raise"):
        raise ValueError(f'on_error is "record" or "raise", not {on_error!r}')
    cases = list_cases(cases)
    # What would fail after hours fails now.
    if not as_arrays:
        import_pandas()
    if not callable(collect):
        check_names(collect, dict.fromkeys(key for case in cases for key in case))
    if isinstance(deck, (str, os.PathLike)):
        from . import Deck

        deck = Deck(deck)
    if simulation is None:
        from . import Simulation as simulation
    calls = [(simulation, deck, case, collect, options) for case in cases]
    if executor is None:
        with ThreadPoolExecutor(max_workers=count_cores()) as threads:
            rows = run_all(threads, calls, on_error, report_to(progress))
    else:
        rows = run_all(executor, calls, on_error, report_to(progress))
    failed = sum(row[ERROR] is not None for row in rows)
    if failed:
        warnings.warn(f"{failed} of {len(rows)} cases failed; the column {ERROR!r} says why", stacklevel=2)
    columns = make_columns(cases, rows)
    return columns if as_arrays else import_pandas().DataFrame(columns)


def list_cases(cases):
    """As dicts, with the types that a table has."""
    if hasattr(cases, "columns") and hasattr(cases, "itertuples"):
        names = [str(name) for name in cases.columns]
        return [dict(zip(names, (plain(value) for value in row))) for row in cases.itertuples(index=False, name=None)]
    return [dict(case) for case in cases]


def plain(value):
    return value.item() if isinstance(value, np.generic) else value


def count_cores():
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def run_case(simulation, deck, case, collect, options):
    """One case: ({name: value}, None), or what failed: ({}, the error, its text). Runs in a thread or process of the executor."""
    try:
        with simulation(deck.build(case), **options) as sim:
            sim.run()
            return collect_all(collect, sim, case), None, None
    except Exception as error:  # whatever it is, it fails this case only
        return {}, portable(error), f"{type(error).__name__}: {error}" if not isinstance(error, Error) else str(error)


def collect_all(collect, sim, case):
    """{name: number or text}."""
    values = dict(collect(sim)) if callable(collect) else {name: evaluate(sim, what) for name, what in collect.items()}
    check_names(values, case)
    row = {}
    for name, value in values.items():
        row.update(split_array(name, value))
    return row


def check_names(names, case):
    taken = [name for name in names if name in case or name == ERROR]
    if taken:
        raise Error(f"{', '.join(taken)}: what is collected has the name of a key of the cases, or of the column for errors")


def evaluate(sim, what):
    """A function of the simulation, or a quantity that it has now, as "tip.position", "ledger.energy_error" or "time"."""
    if callable(what):
        return what(sim)
    name, _, quantity = what.partition(".")
    if not quantity and name != "time":
        raise Error(f"{what!r} is no quantity; expected one of a history or of the ledger, as \"{name}.position\", or \"time\"")
    if name in ("time", "ledger"):
        found = getattr(sim, name)
    else:
        found = sim[name]
    return np.array(getattr(found, quantity)) if quantity else found


def portable(error):
    """The error itself if another process can have it, else one with its text."""
    try:
        pickle.loads(pickle.dumps(error))
        return error
    except Exception:
        return Error(f"{type(error).__name__}: {error}")


def run_all(executor, calls, on_error, report):
    """Rows of all calls, in their order."""
    futures = [executor.submit(run_case, *call) for call in calls]
    try:
        for count, future in enumerate(as_completed(futures), 1):
            error = result_of(future)[1]
            if error is not None and on_error == "raise":
                raise error
            report(count, len(futures))
        return [row_of(result_of(future)) for future in futures]
    finally:
        # Of an error or Ctrl-C: those that have not begun.
        for future in futures:
            future.cancel()


def result_of(future):
    try:
        return future.result()
    except CancelledError:
        raise
    except Exception as error:  # of the executor: a process that ended, something that cannot be pickled
        return {}, error, f"{type(error).__name__}: {error}"


def row_of(result):
    values, _, text = result
    return {**values, ERROR: text}


def split_array(name, value):
    """{name: number}, or of an array {name[0]: …}."""
    values = np.asarray(value)
    if values.ndim == 0:
        return {name: plain(values[()])}
    if values.ndim > 1:
        raise Error(f"{name} is an array {list(values.shape)}; expected a number or an array of numbers")
    return {f"{name}[{i}]": plain(each) for i, each in enumerate(values)}


def make_columns(cases, rows):
    """{name: array} of what any case has."""
    keys = dict.fromkeys(key for case in cases for key in case)
    names = [name for name in dict.fromkeys(name for row in rows for name in row) if name != ERROR]
    columns = {key: column_of([case.get(key) for case in cases]) for key in keys}
    columns.update({name: column_of([row.get(name) for row in rows]) for name in names})
    columns[ERROR] = as_objects([row[ERROR] for row in rows])
    return columns


def column_of(values):
    """Numbers with NaN where there is none; whole numbers and booleans if there is one everywhere; else objects."""
    there = [value for value in values if value is not None]
    if not there or not all(isinstance(value, (bool, int, float)) for value in there):
        return np.full(len(values), np.nan) if not there else as_objects(values)
    if len(there) == len(values):
        kinds = {type(value) for value in there}
        return np.array(values, dtype=None if len(kinds) == 1 else float)
    return np.array([np.nan if value is None else float(value) for value in values])


def report_to(progress):
    """A function of the counts of cases done and of all."""
    if callable(progress):
        return progress
    if not progress:
        return lambda done, count: None

    def write(done, count):
        sys.stderr.write(f"\r{done} of {count} cases" + ("\n" if done == count else ""))
        sys.stderr.flush()

    return write
