"""Derivatives that a simulation carries along, against differences of whole runs."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from .decks import Deck, Model
from .simulation import Simulation, list_names
from .typed import AnyPath, Names
from .variations import change, find_number, key_of


def check_gradient(deck: Model | Deck | AnyPath, names: Names, quantity: str, step: float = 1e-4) -> list[dict[str, Any]]:
    """Derivatives of a quantity at the end, "tip.position", against differences of whole runs: a row for each name.

    deck: a `Deck`, a `Model`, or the path of a deck. names: of [parameters], or other keys of numbers. quantity: of a
    history. step: of the differences, relative to the number; they are extrapolated from runs with this step and half of it.

    A row is a dict: `parameter`, the name; `derivative` and `difference`, numbers or arrays as the quantity is; `distance`
    between them, relative. Warns where runs take other steps than the one with derivatives, so that they cannot be compared.
    """
    history, _, what = quantity.partition(".")
    names = list_names(names)
    sim = Simulation(deck, sensitivities=names, record=())
    sim.run()
    model = sim.model
    rows = []
    for name in names:
        key = key_of(model, name)
        value = find_number(model, key, name)
        counts = {len(sim.records.time)}

        def end(number, key=key, counts=counts):
            other = Simulation(change(model, key, number), record=())
            other.run()
            counts.add(len(other.records.time))
            return np.asarray(other[history][what])

        def difference(h, value=value, end=end):
            return (end(value + h) - end(value - h)) / (2 * h)

        h = step * (abs(value) or 1.0)
        expected = (4 * difference(h / 2) - difference(h)) / 3
        if len(counts) > 1:
            warnings.warn(f"{name}: runs for the differences take other steps than the one with derivatives, so that they cannot "
                          "be compared; a shorter time step, or more steps, may avoid that any is cut", stacklevel=2)
        derivative = np.asarray(sim[history].derivative(name)[what])
        distance = float(np.linalg.norm(derivative - expected) / (np.linalg.norm(expected) or 1.0))
        rows.append({"parameter": name, "derivative": derivative, "difference": expected, "distance": distance})
    return rows
