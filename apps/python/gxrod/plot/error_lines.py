"""Errors of runs from the coarsest to the finest, and the orders with which they fall."""

from dataclasses import dataclass, field

import numpy as np

ROUND_OFF = 1e-12  # of the values: smaller errors have no order
MOST_ORDER = 16.0


@dataclass
class Line:
    """Errors of one series of runs, from the coarsest to the finest."""

    name: str
    x: np.ndarray
    values: np.ndarray
    errors: np.ndarray
    size: float  # of the values, for round-off
    finest: float | None = None  # x of the run that errors are measured from, if it has an error itself
    orders: np.ndarray = field(init=False)  # [n]: from the run before; NaN where there is none

    def __post_init__(self):
        self.orders = np.full(len(self.x), np.nan)
        for i in range(1, len(self.x)):
            self.orders[i] = order_between(self.x[i - 1 : i + 1], self.errors[i - 1 : i + 1], self.finest, ROUND_OFF * self.size)

    @property
    def last_order(self):
        """Index of the finest run that has an order; None if no error falls."""
        found = np.flatnonzero(np.isfinite(self.orders))
        return int(found[-1]) if len(found) else None


@dataclass
class Panel:
    """Lines over one axis."""

    title: str
    across: str
    upwards: str
    reference: str  # what errors are measured from, in words
    lines: list


def order_between(x, errors, finest, least):
    """The power p of the step with which errors fall from x[0] to x[1]; NaN if they do not, or are round-off.

    The finest run as reference has an error itself: then |h^p - h0^p| falls as the errors do, and p is found by bisection.
    """
    if not (errors[0] > errors[1] > least):
        return np.nan
    wanted = np.log(errors[0] / errors[1])
    if finest is None:
        return wanted / abs(np.log(x[1] / x[0]))
    # Steps in units of the finest one, whichever of step and number x is.
    a, b = (np.exp(abs(np.log(each / finest))) for each in x)
    fall = lambda p: np.log(np.expm1(p * np.log(a)) / np.expm1(p * np.log(b)))
    low, high = 1e-6, MOST_ORDER
    if not fall(low) < wanted < fall(high):
        return np.nan
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if fall(middle) < wanted else (low, middle)
    return 0.5 * (low + high)
