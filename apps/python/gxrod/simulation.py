"""Runs that are driven from Python."""

import json
import math
import time
from collections.abc import Mapping, MutableMapping
from types import SimpleNamespace
from typing import NamedTuple

import numpy as np

from . import _core
from .decks import Deck, Model, schema
from .errors import ConvergenceError, Error, EvaluationError, unknown_name
from .results.display import Shown
from .variations import vary

__all__ = ["Checkpoint", "Deck", "Model", "Simulation", "Step", "Summary", "schema"]

Checkpoint = _core.Checkpoint
LONGEST_CALL = 0.05  # seconds in which Python is not asked whether Ctrl-C was pressed


class Step(NamedTuple):
    """An accepted step: the time at its end, its length, its Newton iterations, and how many shorter ones were tried before."""

    time: float
    time_step: float
    newton_iterations: int
    rejected: int


class Summary(dict):
    """What `gxrod run --summary` writes: summary["steps"], or as attributes, summary.steps."""

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise unknown_name("entry of the summary", name, self) from None

    def __dir__(self):
        return [*super().__dir__(), *self]


class Simulation(Shown):
    """A run of a model, step by step.

        with gxrod.Simulation(gxrod.Deck("arm.toml").build()) as sim:
            while not sim.finished:
                sim.inputs["tendon"] = 0.4 * (0.2 - sim["tip"].position[2])
                sim.advance(until=sim.time + 0.02)

    model: a `Model`, a `Deck`, or the path of a deck. results: the path of a results file, as `gxrod run` writes it; None:
    no file. threads: that share the work of a step; they change no result. record: what `records` keeps in memory of each
    accepted step: "ledger" and names of histories; by default all of them. sensitivities: names of [parameters], or other
    keys of numbers, by which derivatives are carried along: sim["tip"].derivative("EI").position.

    It begins at t = 0, with the accepted state there. Simulations share nothing: each may be driven by a thread of its
    own. One that cannot start is a ConvergenceError or an EvaluationError.
    """

    def __init__(self, model, results=None, threads=1, record=None, sensitivities=()):
        if not isinstance(model, (Deck, Model)):
            model = Deck(model)
        self.model = model.build() if isinstance(model, Deck) else model
        self._names = self.model.histories
        record = ["ledger", *self._names] if record is None else list_names(record)
        for name in record:
            if name != "ledger" and name not in self._names:
                raise unknown_name("history", name, ["ledger", *self._names])
        self._recorded = record
        histories = [self._names.index(name) for name in record if name != "ledger"]
        self._varied = list_names(sensitivities)
        varied = [vary(self.model, name) for name in self._varied]
        try:
            self._core = _core.Simulation(self.model._core, "" if results is None else str(results), threads, "ledger" in record, histories,
                                          [([model._core for model in models], step) for models, step in varied])
        except ValueError as error:
            raise Error(f"sensitivities by {', '.join(self._varied)}: {error}") from error
        self._pending = {}
        self._wall = time.perf_counter()
        if not self._core.start():
            raise self._failure()

    # Stepping.

    def step(self):
        """One accepted step, as a `Step`. What fails is a ConvergenceError; the state stays the last accepted one."""
        self._check_open()
        self._set_inputs(self._core.next_time)
        if not self._core.step():
            self._raise_failure()
            return None  # a stage without steps was the last
        return Step(*self._core.last_step)

    def advance(self, until=None, steps=None):
        """Steps until a time, which is reached exactly, or so many steps; or to the end of the run, if that is sooner. The last `Step`.

        until: on the axis of sim.time. An input that changes linearly has its new value there. Other threads of Python
        run in the meantime, and Ctrl-C ends it after the step at hand.
        """
        if (until is None) == (steps is None):
            raise TypeError("advance takes one of until and steps")
        if until is not None and not until > self.time:
            raise Error(f"advance: until is {until}, which is not after t = {self.time}")
        self._check_open()
        self._set_inputs(self._core.next_time if until is None else until)
        left, size = math.inf if steps is None else steps, 1
        while left > 0 and not self.finished and (until is None or self.time < until):
            begin = time.perf_counter()
            done = self._core.advance(until, int(min(size, left)))
            self._raise_failure()
            if done == 0:
                break  # a time that differs from this one by rounding
            left -= done
            if time.perf_counter() - begin < 0.5 * LONGEST_CALL:
                size *= 2
        return Step(*self._core.last_step)

    def run(self, progress=False, on_step=None):
        """To the end of the run: its `Summary`. on_step: function(sim), called after each step; the run ends where it returns False.

        progress: True shows how far it is, by tqdm where that is there.
        """
        shown = show_progress() if progress else None
        try:
            while not self.finished:
                if on_step is None:
                    self.advance(steps=64 if shown else 1 << 30)
                else:
                    if self.step() is not None and is_false(on_step(self)):
                        self._core.interrupt()
                if shown:
                    shown(self._core.part_done)
        finally:
            if shown:
                shown(None)
        return self.summary

    @property
    def time(self):
        """Of the last accepted step; on the axis that stages share. In statics the load factor."""
        return self._core.time

    @property
    def finished(self):
        """Whether no step comes any more."""
        return self._core.ended

    @property
    def stage(self):
        """The name of the stage at hand; "" of a run of one."""
        return self._core.stage

    @property
    def summary(self):
        """What the run has done so far, as `gxrod run --summary` says it."""
        summary = Summary(json.loads(self._core.summary()))
        summary["time"] = self.time
        summary["wall_seconds"]["total"] = time.perf_counter() - self._wall
        return summary

    def close(self):
        """The end of the run: a results file is completed; one that is not finished counts as interrupted."""
        self._core.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    # What it is like.

    @property
    def state(self):
        """The nodes at the last accepted state, global components.

        Read-only arrays that follow the simulation, without a copy; `.copy()` what is kept. position, velocity,
        acceleration, angular_velocity, angular_acceleration [N,3]; orientation [N,4], the quaternion w x y z of the
        rotation since the reference shape, and rotation_vector [N,3] of it.
        """
        return State(self._core)

    def __getitem__(self, name):
        """What the deck's [[history]] of this name records, at the last accepted state: sim["tip"].position."""
        if name not in self._names:
            raise unknown_name("history", name, self._names)
        index = self._names.index(name)
        return Values(f"history {name}", self._core.quantities(index), lambda quantity: as_value(self._core.history(index, quantity)),
                      lambda parameter: self._derivatives(name, index, parameter))

    def _derivatives(self, name, index, parameter):
        if parameter not in self._varied:
            raise unknown_name("sensitivity", parameter, self._varied)
        number = self._varied.index(parameter)

        def read(quantity):
            try:
                return as_value(self._core.derivative(number, index, quantity))
            except RuntimeError as error:
                raise Error(str(error)) from error

        names = [quantity for quantity in self._core.quantities(index) if not quantity.startswith("reaction_")]
        every = self._core.quantities(index)
        return Values(f"derivative of history {name} by {parameter}", names, lambda number: read(every.index(names[number])))

    @property
    def ledger(self):
        """Energies and momenta at the last accepted state: sim.ledger.kinetic_energy."""
        return SimpleNamespace(**self._core.ledger())

    @property
    def elements(self):
        """Of each element at its middle, in section axes [E,3]: force, moment, strain, curvature."""
        return SimpleNamespace(**self._core.elements())

    @property
    def records(self):
        """Of each accepted step, the state at t = 0 included: records.time [S], records["tip"].position [S,3], records.ledger.energy_error [S]."""
        return Records(self)

    @property
    def inputs(self):
        """The deck's inputs by their names: sim.inputs["tendon"] = 1.2 counts from the next step on."""
        return Inputs(self)

    # Back.

    def save(self):
        """The last accepted state as a `Checkpoint`; it can be pickled."""
        return self._core.save()

    def restore(self, checkpoint):
        """Returns to a state that this simulation, or another one of the same model, has saved: all that follows is equal to the last bit."""
        try:
            self._core.restore(checkpoint)
        except (ValueError, RuntimeError) as error:
            raise Error(str(error)) from error
        self._pending.clear()

    # Matrices.

    def tangent(self):
        """∂(residual)/∂(δr, δφ) at the last accepted state at unchanged rates: a scipy.sparse matrix; rows and columns are `unknowns`."""
        return self._matrix(0)

    def damping_matrix(self):
        """The same by velocities."""
        return self._matrix(1)

    def mass_matrix(self):
        """The same by accelerations."""
        return self._matrix(2)

    @property
    def unknowns(self):
        """Of each unknown the row of its node and its component, 0 … 5 for x y z rx ry rz; -1 of multipliers of joints. [n,2]"""
        return self._core.unknowns()

    def _matrix(self, which):
        try:
            from scipy import sparse
        except ImportError as missing:
            raise ImportError("matrices of a simulation need SciPy: python3 -m pip install scipy") from missing
        values, rows, columns, size = self._core.matrices()[which]
        return sparse.coo_matrix((values, (rows, columns)), shape=(size, size)).tocsc()

    def _check_open(self):
        if self.finished:
            raise Error("the run is finished: " + (self._core.reason or f"t = {self.time} is its end"))

    def _set_inputs(self, until):
        for name, value in self._pending.items():
            self._core.set_input(name, value, until)
        self._pending.clear()

    def _raise_failure(self):
        if self._core.status == "failed":
            raise self._failure()

    def _failure(self):
        failure = self._core.failure()
        if failure is None:
            return (EvaluationError if self._core.is_deck_fault else ConvergenceError)(self._core.reason)
        return ConvergenceError(self._core.reason, *failure)

    def _headline(self):
        state = "finished" if self.finished else "at"
        return f"gxrod.Simulation of {self.model.deck.file}, {state} t = {self.time:.10g}"

    def _rows(self):
        return [(name, ", ".join(self._core.quantities(i))) for i, name in enumerate(self._names)]


class State:
    """Views of a simulation's nodes; see Simulation.state."""

    _names = ("position", "velocity", "acceleration", "angular_velocity", "angular_acceleration", "orientation", "rotation_vector")

    def __init__(self, core):
        self._core = core

    def __getattr__(self, name):
        if name not in State._names:
            raise unknown_name("quantity of the state", name, State._names)
        return getattr(self._core, name)

    def __dir__(self):
        return State._names


class Values(Shown, Mapping):
    """Quantities by their names, as attributes and as keys."""

    def __init__(self, what, names, read, differentiate=None):
        self._what, self._quantities, self._read, self._differentiate = what, names, read, differentiate

    def derivative(self, parameter):
        """The same by one of the `sensitivities` of the simulation; not of reactions."""
        if self._differentiate is None:
            raise Error(f"{self._what} has no derivatives")
        return self._differentiate(parameter)

    def __getitem__(self, name):
        if name not in self._quantities:
            raise unknown_name(f"quantity of {self._what}", name, self._quantities)
        return self._read(self._quantities.index(name))

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return self[name]

    def __iter__(self):
        return iter(self._quantities)

    def __len__(self):
        return len(self._quantities)

    def __dir__(self):
        return self._quantities

    def _headline(self):
        return self._what

    def _rows(self):
        return [(name, np.array2string(np.asarray(self[name]), precision=6, threshold=6)) for name in self]


class Records:
    """What was kept of each accepted step; see Simulation.records."""

    def __init__(self, simulation):
        self._simulation = simulation

    @property
    def time(self):
        """[S]"""
        return self._simulation._core.times()

    @property
    def ledger(self):
        """Energies [S] and momenta [S,3]."""
        self._check("ledger")
        return SimpleNamespace(**self._simulation._core.ledgers())

    def __getitem__(self, name):
        self._check(name)
        core, index = self._simulation._core, self._simulation._names.index(name)
        return Values(f"history {name}", core.quantities(index), lambda quantity: core.records(index, quantity))

    def _check(self, name):
        if name not in self._simulation._recorded:
            raise unknown_name("record", name, self._simulation._recorded)


class Inputs(Shown, MutableMapping):
    """The inputs of a simulation; see Simulation.inputs."""

    def __init__(self, simulation):
        self._simulation = simulation

    def __getitem__(self, name):
        names = self._simulation.model.inputs
        if name not in names:
            raise unknown_name("input", name, names)
        pending = self._simulation._pending
        return pending[name] if name in pending else self._simulation._core.input(names.index(name))

    def __setitem__(self, name, value):
        self[name]  # whether there is one
        value = float(value)
        if not math.isfinite(value):
            raise Error(f"input {name} cannot be {value}")
        self._simulation._pending[name] = value

    def __delitem__(self, name):
        raise TypeError("inputs of a deck cannot be removed")

    def __iter__(self):
        return iter(self._simulation.model.inputs)

    def __len__(self):
        return len(self._simulation.model.inputs)

    def _headline(self):
        return "inputs" if len(self) else "no inputs"

    def _rows(self):
        return [(name, f"{value:.10g}") for name, value in self.items()]


def is_false(result):
    """Whether a function says False, as a comparison of NumPy's numbers too; None is not."""
    return isinstance(result, (bool, np.bool_)) and not result


def list_names(names):
    """A list, of one name alone too."""
    return [names] if isinstance(names, str) else list(names)


def as_value(numbers):
    return numbers[0] if len(numbers) == 1 else np.array(numbers)


def show_progress():
    """A function of the part done, None at the end: a bar by tqdm, or a line."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        import sys

        def write(part):
            sys.stderr.write("\n" if part is None else f"\r{100 * part:5.1f} %")
            sys.stderr.flush()

        return write
    bar = tqdm(total=1.0, bar_format="{percentage:3.0f} % |{bar}| {elapsed} < {remaining}")

    def update(part):
        if part is None:
            bar.close()
        else:
            bar.update(part - bar.n)

    return update
