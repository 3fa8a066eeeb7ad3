"""Models that differ from another one in one number of the deck."""

import re
from collections.abc import Sequence

import numpy as np

from .decks import Model
from .errors import Error, unknown_name


def key_of(model, name):
    return f"parameters.{name}" if name in model.deck._tables.get("parameters", {}) else name


def change(model, key, value):
    """The model with another value, whatever overrides it has."""
    return Model(model.deck, {**{each: kept for each, kept in model.overrides.items() if each != key}, key: value})


def split_key(key):
    return re.findall(r"[^.\[\]]+", key)


def find_number(model, key, name):
    """The value of a key, from the overrides, that of a list or table with it too, or from the deck."""
    path, value, parts = split_key(key), model.deck._tables, split_key(key)
    for changed, new in model.overrides.items():
        above = split_key(changed)
        if path[: len(above)] == above:
            value, parts = new, path[len(above) :]
    for part in parts:
        try:
            value = value[int(part)] if isinstance(value, (Sequence, np.ndarray)) else value[part]
        except (KeyError, IndexError, TypeError, ValueError):
            raise unknown_name("number of the deck", name, model.deck._tables.get("parameters", {})) from None
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise Error(f"{name} is {value!r}, not a number; take derivatives by the parameters in it")
    return float(value)
