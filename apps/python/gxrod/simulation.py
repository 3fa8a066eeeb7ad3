"""Runs that are driven from Python."""

from __future__ import annotations

import json
import math
import time
from collections.abc import Callable, Iterator, Mapping, MutableMapping
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from .decks import Deck, Model, Section, add_points, schema
from .errors import Error, unknown_name
from .installing import pip_install
from .results.display import Shown
from .typed import AnyPath, Array, Names, WholeArray

if TYPE_CHECKING:
    import scipy.sparse

__all__ = ["Checkpoint", "Deck", "Model", "Section", "Simulation", "Step", "Summary", "schema"]

Checkpoint = _core.Checkpoint
LONGEST_CALL = 0.05  # seconds in which Python is not asked whether Ctrl-C was pressed


class Step(NamedTuple):
    """An accepted step. `time`: at its end, on the axis of `sim.time`. `time_step`: its length. `newton_iterations`: that it took. `rejected`: how many trials failed before it."""

    time: float
    time_step: float
    newton_iterations: int
    rejected: int


class Elements(NamedTuple):
    """Of each rod element at its middle [E,3], in section axes.

    `force` and `strain` are (axial, shear y, shear z), `moment` and `curvature` are about x, y, z. Strain, a plain number,
    and curvature, one by a length, are those since the reference shape.
    """

    force: Array
    moment: Array
    strain: Array
    curvature: Array


class Summary(dict):
    """What `gxrod run --summary` writes: `summary["steps"]`, or as attributes, `summary.steps`.

    `status` ("complete", "failed", "interrupted"), `reason`, `time`, `steps`, `newton_iterations`, `rejected_steps`,
    `unknowns`, `wall_seconds`, `found` by stages, and more.
    """

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise unknown_name("entry of the summary", name, self) from None

    def __dir__(self) -> list[str]:
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
    keys of numbers, by which derivatives are carried along: `sim["tip"].derivative("EI").position`. points: {name: point},
    `{"quarter": "arm@0.25"}`, rods' points and bodies that the deck has no history of: each becomes one, with all quantities
    of a point.

    It begins at t = 0, with the accepted state there. Simulations share nothing: each may be driven by a thread of its
    own. One that cannot start is a ConvergenceError or an EvaluationError; faults of a deck are a DeckError.
    """

    model: Model

    def __init__(self, model: Model | Deck | AnyPath, results: AnyPath | None = None, threads: int = 1, record: Names | None = None,
                 sensitivities: Names = (), points: Mapping[str, str] | None = None) -> None:
        if not isinstance(model, (Deck, Model)):
            model = Deck(model)
        self.model = add_points(model.build() if isinstance(model, Deck) else model, points or {})
        self._names = self.model.histories
        self._recorded = ["ledger", *self._names] if record is None else list_names(record)
        for name in self._recorded:
            if name != "ledger" and name not in self._names:
                raise unknown_name("history", name, ["ledger", *self._names])
        self._varied = list_names(sensitivities)
        self._wall = time.perf_counter()
        try:
            self._core = _core.Simulation(self.model._core, "" if results is None else str(results), threads, self._recorded, self._varied)
        except ValueError as error:
            raise Error(f"sensitivities by {', '.join(self._varied)}: {error}") from error

    # Stepping.

    def step(self) -> Step | None:
        """One accepted step, as a `Step`; None if the run ends without one, as a last stage of modes does.

        Raises ConvergenceError, or EvaluationError where an expression of the deck gives no number; the state stays the last
        accepted one.
        """
        self._check_open()
        if not self._core.step():
            return None  # a stage without steps was the last
        return Step(*self._core.last_step)

    def advance(self, until: float | None = None, steps: int | None = None) -> Step:
        """Steps until a time, which is reached exactly, or so many steps; or to the end of the run, if that is sooner. The last `Step`.

        until: on the axis of `sim.time`. An input that changes linearly has its new value there. Other threads of Python
        run in the meantime, and Ctrl-C ends it after the step at hand. Raises what `step` raises.
        """
        if (until is None) == (steps is None):
            raise TypeError("advance takes one of until and steps")
        if until is not None and not until > self.time:
            raise Error(f"advance: until is {until}, which is not after t = {self.time}")
        self._check_open()
        left, size = math.inf if steps is None else steps, 1
        while left > 0 and not self.finished and (until is None or self.time < until):
            begin = time.perf_counter()
            done = self._core.advance(until, int(min(size, left)))
            if done == 0:
                break  # a time that differs from this one by rounding
            left -= done
            if time.perf_counter() - begin < 0.5 * LONGEST_CALL:
                size *= 2
        return Step(*self._core.last_step)

    def run(self, progress: bool = False, on_step: Callable[[Simulation], object] | None = None) -> Summary:
        """To the end of the run: its `Summary`. on_step: `function(sim)`, called after each step; the run ends where it returns False.

        progress: True shows how far it is, by tqdm where that is there. An exception of `on_step` comes through, and the
        simulation can be used on. Raises what `step` raises.
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
    def time(self) -> float:
        """Of the last accepted step; on the axis that stages share. In statics the load factor."""
        return self._core.time

    @property
    def finished(self) -> bool:
        """Whether no step comes any more."""
        return self._core.ended

    @property
    def stage(self) -> str:
        """The name of the stage at hand; "" of a run of one."""
        return self._core.stage

    @property
    def summary(self) -> Summary:
        """What the run has done so far, as `gxrod run --summary` says it."""
        summary = Summary(json.loads(self._core.summary()))
        summary["time"] = self.time
        summary["wall_seconds"]["total"] = time.perf_counter() - self._wall
        return summary

    def close(self) -> None:
        """The end of the run: a results file is completed; one that is not finished counts as interrupted."""
        self._core.close()

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    # What it is like.

    @property
    def state(self) -> State:
        """The nodes at the last accepted state: `sim.state.position` [N,3]. Views that follow the run; `.copy()` what is kept."""
        return State(self._core)

    def __getitem__(self, name: str) -> Values:
        """What the deck's `[[history]]` of this name records, at the last accepted state: `sim["tip"].position` [3]; or a point of `points`."""
        if name not in self._names:
            raise unknown_name("history", name, self._names)
        index = self._names.index(name)
        return Values(f"history {name}", self._core.quantities(index), lambda quantity: as_value(self._core.history(index, quantity)),
                      lambda parameter: self._derivatives(name, index, parameter))

    def _derivatives(self, name: str, index: int, parameter: str) -> Values:
        if parameter not in self._varied:
            raise unknown_name("sensitivity", parameter, self._varied)
        number = self._varied.index(parameter)

        def read(quantity):
            try:
                return as_value(self._core.derivative(number, index, quantity))
            except RuntimeError as error:
                raise Error(f"the derivative of history {name} by {parameter}: {error}") from error

        return Values(f"derivative of history {name} by {parameter}", self._core.quantities(index), read)

    def adjoint(self, weights: Mapping[str, ArrayLike], parameters: Names = (), inputs: Names | None = None) -> Array | tuple[Array, Array]:
        """The gradient [n] of a weighted sum by n numbers of the deck, by multipliers; with `inputs` a pair: also [S,m], by the values of m inputs.

        weights: {"tip.displacement": [0, 0, 1]}, what the numbers of histories' quantities count at the last accepted state, in
        the shapes of these; or [S,3], in those of `sim.records`, at each of the S accepted states.
        parameters: as `sensitivities`, which are not needed here.
        inputs: names of inputs of the deck. Row k of [S,m] is by the values at the end of step k; the first is by those at t = 0.

        One transposed solution serves all numbers, in a motion one in each step, so that many of them cost little. A
        motion is repeated from states that are kept on the way, and so are load steps of an equilibrium that depends on how it was
        reached: elements "simo", laws that remember, friction. Raises Error for quantities of joints and reactions, for contact, for
        motions of other schemes than newmark-simplified, newmark-ibrahimbegovic and generalized-alpha, and for several stages.
        """
        total = []
        for key, weight in weights.items():
            name, _, quantity = key.partition(".")
            value, weight = np.asarray(self[name][quantity]), np.asarray(weight, dtype=float)
            if weight.shape not in (value.shape, np.atleast_1d(value).shape, (len(self._core.times()), *value.shape)):
                raise Error(f"adjoint: {key} has {value.size} numbers, and {weight.size} weights were given")
            index = self._names.index(name)
            total.append((index, self._core.quantities(index).index(quantity), np.ravel(weight).tolist()))
        try:
            found, by_inputs = self._core.gradient(total, self.model._core, list_names(parameters), list_names(inputs or ()))
        except (ValueError, RuntimeError) as error:
            raise Error(f"adjoint: {error}") from error
        return np.array(found) if inputs is None else (np.array(found), np.array(by_inputs))

    @property
    def ledger(self) -> SimpleNamespace:
        """Energies and momenta at the last accepted state: `sim.ledger.kinetic_energy`.

        `kinetic_energy`, `strain_energy`, `external_work`, `fluid_work`, `work_uncertainty`, `dissipated_energy`, `numerical_dissipation`
        and `energy_error`, what none of these explains: numbers. `linear_momentum`, and `angular_momentum` about the
        origin: [3], global components.
        """
        return SimpleNamespace(**self._core.ledger())

    @property
    def elements(self) -> Elements:
        """Of each rod element at its middle, at the last accepted state: `sim.elements.moment` [E,3], in section axes. Copies."""
        return Elements(**self._core.elements())

    @property
    def records(self) -> Records:
        """Of each accepted step, the state at t = 0 included: `sim.records["tip"].position` [S,3]; copies of what `record` keeps."""
        return Records(self)

    @property
    def inputs(self) -> Inputs:
        """The deck's inputs by their names: `sim.inputs["tendon"] = 1.2` counts from the next step on."""
        return Inputs(self)

    # Back.

    def save(self) -> Checkpoint:
        """The last accepted state as a `Checkpoint`; it can be pickled."""
        return self._core.save()

    def restore(self, checkpoint: Checkpoint) -> None:
        """Returns to a state that this simulation, or another one of the same model, has saved: all that follows is equal to the last bit.

        Raises Error if the checkpoint is of another model, or if the run writes results. Derivatives come back with a checkpoint of this
        simulation, but for pickles.
        """
        try:
            self._core.restore(checkpoint)
        except (ValueError, RuntimeError) as error:
            raise Error(str(error)) from error
    # Matrices.

    def tangent(self) -> scipy.sparse.csc_matrix:
        """∂(residual)/∂(δr, δφ) at the last accepted state at unchanged rates: a scipy.sparse matrix [n,n]; rows and columns are `unknowns`.

        δr and δφ, the turn, have global components. Sections with laws are elastic and relaxed here, as in `modes`. Needs SciPy.
        """
        return self._matrix(0)

    def damping_matrix(self) -> scipy.sparse.csc_matrix:
        """∂(residual)/∂(velocities) [n,n], gyroscopic terms included."""
        return self._matrix(1)

    def mass_matrix(self) -> scipy.sparse.csc_matrix:
        """∂(residual)/∂(accelerations) [n,n]."""
        return self._matrix(2)

    @property
    def unknowns(self) -> WholeArray:
        """[n,2]: of each of the n unknowns the row of its node in states and its component, 0 … 5 for x y z rx ry rz; -1 of multipliers of joints."""
        return self._core.unknowns()

    def _matrix(self, which: int) -> scipy.sparse.csc_matrix:
        try:
            from scipy import sparse
        except ImportError as missing:
            raise ImportError(f"matrices of a simulation need SciPy: {pip_install('scipy')}") from missing
        values, rows, columns, size = self._core.matrices()[which]
        return sparse.coo_matrix((values, (rows, columns)), shape=(size, size)).tocsc()

    def _check_open(self):
        if self.finished:
            raise Error("the run is finished: " + (self._core.reason or f"t = {self.time} is its end"))

    def _headline(self):
        state = "finished" if self.finished else "at"
        return f"gxrod.Simulation of {self.model.deck.file}, {state} t = {self.time:.10g}"

    def _rows(self):
        return [(name, ", ".join(self._core.quantities(i))) for i, name in enumerate(self._names)]


class State:
    """The N nodes of a simulation at the last accepted state, in global components: `sim.state.position`.

    Read-only arrays that follow the simulation, without a copy; `.copy()` what is kept. They outlive the simulation.
    """

    def __init__(self, core: _core.Simulation) -> None:
        self._core = core

    @property
    def position(self) -> Array:
        """[N,3]"""
        return self._core.position

    @property
    def velocity(self) -> Array:
        """[N,3]; zero in statics."""
        return self._core.velocity

    @property
    def acceleration(self) -> Array:
        """[N,3]; zero in statics."""
        return self._core.acceleration

    @property
    def angular_velocity(self) -> Array:
        """[N,3], in rad per time."""
        return self._core.angular_velocity

    @property
    def angular_acceleration(self) -> Array:
        """[N,3], in rad per time²."""
        return self._core.angular_acceleration

    @property
    def orientation(self) -> Array:
        """[N,4]: the quaternion w x y z of the rotation since the reference shape; of a body its attitude."""
        return self._core.orientation

    @property
    def rotation_vector(self) -> Array:
        """[N,3]: the same rotation as a vector along its axis, whose length is the angle in rad, at most π."""
        return self._core.rotation_vector

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            raise unknown_name("quantity of the state", name, dir(self))

    def __dir__(self) -> list[str]:
        return [name for name, member in vars(State).items() if isinstance(member, property)]


class Values(Shown, Mapping):
    """Quantities by their names, as attributes and as keys: `sim["tip"].position`, `sim["tip"]["position"]`.

    Numbers; or copies, arrays [3] of vectors, x y z, [4] of quaternions, w x y z. In global axes, if the deck does not
    name others; `force`, `moment`, `strain` and `curvature` of rods in section axes. In records there are S of them: [S], [S,3], [S,4].
    """

    def __init__(self, what: str, names: list[str], read: Callable[[int], Any], differentiate: Callable[[str], Values] | None = None) -> None:
        self._what, self._quantities, self._read, self._differentiate = what, names, read, differentiate

    def derivative(self, parameter: str) -> Values:
        """The same by one of the `sensitivities` of the simulation: `sim["tip"].derivative("EI").position` [3]."""
        if self._differentiate is None:
            raise Error(f"{self._what} has no derivatives")
        return self._differentiate(parameter)

    def __getitem__(self, name: str) -> Any:
        if name not in self._quantities:
            raise unknown_name(f"quantity of {self._what}", name, self._quantities)
        return self._read(self._quantities.index(name))

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return self[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._quantities)

    def __len__(self) -> int:
        return len(self._quantities)

    def __dir__(self) -> list[str]:
        return self._quantities

    def _headline(self):
        return self._what

    def _rows(self):
        return [(name, np.array2string(np.asarray(self[name]), precision=6, threshold=6)) for name in self]


class Records:
    """What was kept of each of the S accepted steps, the state at t = 0 included: `sim.records["tip"].position` [S,3]."""

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation

    @property
    def time(self) -> Array:
        """Of each step [S], on the axis of `sim.time`."""
        return self._simulation._core.times()

    @property
    def ledger(self) -> SimpleNamespace:
        """Energies [S] and momenta [S,3], by the names that `sim.ledger` has."""
        self._check("ledger")
        return SimpleNamespace(**self._simulation._core.ledgers())

    def __getitem__(self, name: str) -> Values:
        """What a history has recorded: `sim.records["tip"].position` [S,3]."""
        self._check(name)
        core, index = self._simulation._core, self._simulation._names.index(name)
        return Values(f"history {name}", core.quantities(index), lambda quantity: core.records(index, quantity))

    def _check(self, name: str) -> None:
        if name not in self._simulation._recorded:
            raise unknown_name("record", name, self._simulation._recorded)


class Inputs(Shown, MutableMapping):
    """The deck's inputs by their names, numbers: `sim.inputs["tendon"] = 1.2` counts from the next step on.

    With `hold = "step"` of the input it has the value from the start of that step; with "linear" it goes there until its end,
    or until the time of `advance`. A value that is not finite is an Error.
    """

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation

    def __getitem__(self, name: str) -> float:
        names = self._simulation.model.inputs
        if name not in names:
            raise unknown_name("input", name, names)
        return self._simulation._core.input(name)

    def __setitem__(self, name: str, value: float) -> None:
        self[name]  # whether there is one
        value = float(value)
        if not math.isfinite(value):
            raise Error(f"input {name} cannot be {value}")
        self._simulation._core.set(name, value)

    def __delitem__(self, name: str) -> None:
        raise TypeError("inputs of a deck cannot be removed")

    def __iter__(self) -> Iterator[str]:
        return iter(self._simulation.model.inputs)

    def __len__(self) -> int:
        return len(self._simulation.model.inputs)

    def _headline(self):
        return "inputs" if len(self) else "no inputs"

    def _rows(self):
        return [(name, f"{value:.10g}") for name, value in self.items()]


def is_false(result):
    """Whether a function says False, as a comparison of NumPy's numbers too; None is not."""
    return isinstance(result, (bool, np.bool_)) and not result


def list_names(names: Names) -> list[str]:
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
