"""Columns of numbers over the steps, by the names that users give them."""

from dataclasses import dataclass

import numpy as np

from ..results.records import component_labels
from .errors import UsageError
from .results import choose_histories, listing

MAGNITUDE = "magnitude"


@dataclass
class Column:
    """One number a step."""

    label: str  # "tip: displacement z"
    values: np.ndarray  # [S]
    dimension: str
    unit: str = ""


def read_columns(results, name):
    """What `name` asks for: time, ledger/ENERGY, or NAME/QUANTITY or NAME/QUANTITY/COMPONENT of a history."""
    if name == "load-factor" and results.has_paths:
        return [Column("load factor", results.load_factors(), "1")]
    if name == "limit-load-factor" and results.follows_limits:
        return [Column("load factor of the limit point", results.limit_load_factors(), "1")]
    if name in ("time", "load-factor"):
        dimension = "1" if results.is_static else "time"
        return [Column(results.time_label, results.times, dimension, results.unit_of(dimension))]
    group, _, rest = name.partition("/")
    quantity, _, component = rest.partition("/")
    if group == "ledger":
        return ledger_columns(results, quantity, component)
    if not quantity:
        raise UsageError(f"{name!r}: expected time, ledger/ENERGY or NAME/QUANTITY/COMPONENT of a history")
    [history] = choose_histories(results, [f"{group}/{quantity}"])
    return components(f"{history.name}: ", history.quantities[0], component)


def ledger_columns(results, quantity, component):
    ledger = results.ledger()
    if quantity not in ledger:
        raise UsageError(f"the ledger has no {quantity!r}; {listing(list(ledger))}")
    return components("", ledger[quantity], component)


def components(start, series, component):
    """The components of a vector, or the one named; "magnitude" is its length."""
    name = start + series.name.replace("_", " ")
    values = series.values.reshape(len(series.values), -1)
    if values.shape[1] == 1:
        if component:
            raise UsageError(f"{series.name!r} is one number, without a component {component!r}")
        return [Column(name, values[:, 0], series.dimension, series.unit)]
    letters = component_labels(series.name, values.shape[1])
    columns = {letter: Column(f"{name} {letter}", values[:, i], series.dimension, series.unit) for i, letter in enumerate(letters)}
    if component == MAGNITUDE:
        return [Column(f"{name}, {MAGNITUDE}", np.linalg.norm(values, axis=1), series.dimension, series.unit)]
    if component and component not in columns:
        raise UsageError(f"{series.name!r} has no component {component!r}; it has {', '.join([*columns, MAGNITUDE])}")
    return [columns[component]] if component else list(columns.values())
