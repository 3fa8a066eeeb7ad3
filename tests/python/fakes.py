"""The least of a Deck, a Model and a Simulation: a point of mass 1 on a spring that an input pulls.

What the compiled part of gxrod offers, as far as gxrod.map and gxrod.gym use it; exact, and quick.
"""

import math
from types import SimpleNamespace

import gxrod
import numpy as np


class Deck:
    def __init__(self, end_time=1.0, **parameters):
        self.end_time, self.parameters = end_time, {"parameters.k": 1.0, "parameters.x": 1.0, **parameters}
        self.builds = 0

    def build(self, changes=None):
        self.builds += 1
        changes = changes or {}
        for key in changes:
            if key not in self.parameters:
                raise gxrod.DeckError([("arm.toml", 3, 1, key, "unknown key")])
        return SimpleNamespace(end_time=self.end_time, **{key[-1]: value for key, value in {**self.parameters, **changes}.items()})


class Simulation:
    """x'' = u − k x from rest; a stiffness below 0 does not converge."""

    def __init__(self, model, record=("ledger",)):
        self.model, self.record = model, record
        self.time, self.x, self.v = 0.0, model.x, 0.0
        self.inputs = {"tendon": 0.0}
        self.is_open, self.longest = True, model.x

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.is_open = False

    @property
    def finished(self):
        return self.time >= self.model.end_time - 1e-12

    def run(self):
        self.advance(until=self.model.end_time)

    def advance(self, until):
        assert until > self.time
        if self.model.k < 0.0:
            raise gxrod.ConvergenceError("the step from t = 0 failed", time=self.time, places=("arm.end (y)",), advice=("a shorter step",))
        until = min(until, self.model.end_time)
        omega, rest = math.sqrt(self.model.k), self.inputs["tendon"] / self.model.k
        c, s = math.cos(omega * (until - self.time)), math.sin(omega * (until - self.time))
        x = self.x - rest
        self.x, self.v, self.time = rest + c * x + s * self.v / omega, c * self.v - s * omega * x, until

    def __getitem__(self, name):
        assert name == "tip"
        return SimpleNamespace(position=np.array([self.x, 0.0, 0.0]), velocity=np.array([self.v, 0.0, 0.0]))

    @property
    def ledger(self):
        return SimpleNamespace(energy_error=0.0)

    def save(self):
        return (self.time, self.x, self.v, dict(self.inputs))

    def restore(self, point):
        self.time, self.x, self.v, inputs = point
        self.inputs = dict(inputs)
