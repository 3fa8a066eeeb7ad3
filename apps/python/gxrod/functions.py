"""Runs as functions with derivatives, of which gxrod.torch and gxrod.jax make functions of PyTorch and JAX."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Sequence
from typing import Any

import numpy as np

from .decks import Deck, Model
from .errors import Error, unknown_name
from .simulation import Simulation, list_names
from .typed import AnyPath, Array, Names
from .variations import change, find_number, key_of

KEPT_RUNS = 8  # whose derivatives may still be asked for


class RunFunction:
    """A run of a deck as a function of numbers of the deck and of the courses of inputs.

        run = RunFunction("arm.toml", ["tip.position"], parameters=["EI"])
        seen = run([6.0])                            # [3]
        gradient, _ = run.pull_back([6.0], weights=[0, 0, 1])

    deck: a `Deck`, a `Model`, or the path of a deck. observations: "HISTORY.QUANTITY", whose numbers come one after the other.
    parameters: names of [parameters], or other keys of numbers: n of them. inputs: names of m inputs of the deck; the function
    then also takes their values [T,m], each held, or reached on a straight line, as the input's `hold` says, for a `control_step`.
    control_step: a time; without it each value is for one step. records: False for what is observed at the end of the run [k];
    True for all states [S,k], that at t = 0 the first; "control" for the start and the ends of control steps [T+1,k]. carried: derivatives are carried along from step to step in place of one
    way back: for decks of which `Simulation.adjoint` has none, as with contact or stages; without inputs and records. Further
    options are those of `Simulation`.

    With inputs a run ends after the last of their values, or where the deck ends.
    """

    def __init__(self, deck: Model | Deck | AnyPath, observations: Sequence[str], parameters: Names = (), inputs: Names = (),
                 control_step: float | None = None, records: bool | str = False, carried: bool = False, **options: Any) -> None:
        if not isinstance(deck, (Deck, Model)):
            deck = Deck(deck)
        self.model = deck.build() if isinstance(deck, Deck) else deck
        self.observations, self.parameters, self.inputs = list(observations), list_names(parameters), list_names(inputs)
        self.control_step, self.records, self.carried, self.options = control_step, records, carried, options
        if not self.observations or not (self.parameters or self.inputs):
            raise Error("a run as a function needs observations, and parameters or inputs")
        if carried and (self.inputs or records):
            raise Error("carried is for parameters and what is observed at the end; expected neither inputs nor records with it")
        if records not in (False, True, "control") or (records == "control" and not self.inputs):
            raise Error(f"records is {records!r}; expected False or True, or, with inputs, \"control\"")
        if control_step is not None and not control_step > 0.0:
            raise Error(f"control_step is {control_step}; expected a time greater than 0")
        for name in self.inputs:
            if name not in self.model.inputs:
                raise unknown_name("input", name, self.model.inputs)
        self._keys = [key_of(self.model, name) for name in self.parameters]
        self.start = np.array([find_number(self.model, key, name) for key, name in zip(self._keys, self.parameters)])
        self._linear = [self.model.deck._tables.get("input", {}).get(name, {}).get("hold") == "linear" for name in self.inputs]
        self._runs: OrderedDict[tuple[bytes, bytes], Run] = OrderedDict()

    def __call__(self, parameters: Any = (), inputs: Any = None) -> Array:
        """What is observed, [k] or [S,k]. parameters: [n]. inputs: [T,m]."""
        return self._find(parameters, inputs).values

    def pull_back(self, parameters: Any = (), inputs: Any = None, weights: Any = None) -> tuple[Array, Array]:
        """The gradient of the sum of weights times what is observed, [k] or [S,k], by the parameters [n] and the inputs [T,m]."""
        run = self._find(parameters, inputs)
        weights = np.asarray(weights, dtype=float)
        if weights.shape != run.values.shape:
            raise Error(f"weights have the shape {weights.shape}; expected that of what is observed, {run.values.shape}")
        if self.carried:
            return run.jacobian.T @ weights, np.zeros((0, 0))
        weights = run.spread(weights)
        shares, first = {}, 0
        for what, shape in zip(self.observations, run.shapes):
            count = int(np.prod(shape))
            share = weights[..., first : first + count]
            shares[what] = shares.get(what, 0.0) + share.reshape(*weights.shape[:-1], *shape)
            first += count
        by_parameters, by_states = run.sim.adjoint(shares, self.parameters, self.inputs)
        return by_parameters, run.courses(by_states) if self.inputs else np.zeros((0, 0))

    def _find(self, parameters: Any, inputs: Any) -> Run:
        """The run with these values, made once while it is among the last ones."""
        parameters = np.array(parameters, dtype=float).ravel()
        inputs = np.zeros((0, 0)) if inputs is None else np.array(inputs, dtype=float)
        if len(parameters) != len(self.parameters):
            raise Error(f"{len(parameters)} values were given for the {len(self.parameters)} parameters {', '.join(self.parameters)}")
        if self.inputs and (inputs.ndim != 2 or inputs.shape[1] != len(self.inputs) or len(inputs) == 0):
            raise Error(f"inputs have the shape {inputs.shape}; expected [T, {len(self.inputs)}], a row for each control step")
        if not self.inputs and inputs.size:
            raise Error("values of inputs were given to a function without inputs")
        key = (parameters.tobytes(), inputs.tobytes())
        if key not in self._runs:
            self._runs[key] = Run(self, parameters, inputs)
        self._runs.move_to_end(key)
        while len(self._runs) > KEPT_RUNS:
            self._runs.popitem(last=False)
        return self._runs[key]


class Run:
    """One run of a RunFunction."""

    def __init__(self, function: RunFunction, parameters: Array, inputs: Array) -> None:
        model = function.model
        for key, value in zip(function._keys, parameters):
            model = change(model, key, float(value))
        histories = list(dict.fromkeys(what.partition(".")[0] for what in function.observations))
        options = {"record": histories, **function.options}
        if function.carried:
            options["sensitivities"] = function.parameters
        self.function, self.inputs, self.sim = function, inputs, Simulation(model, **options)
        self.owner = self._drive() if function.inputs else self.sim.run()
        self._observe()

    def _drive(self) -> Array:
        """The row of `inputs` that acted in each step [S]; −1 at t = 0."""
        sim, rows = self.sim, [-1]
        for row, values in enumerate(self.inputs):
            if sim.finished:
                raise Error(f"the deck ends at t = {sim.time} after {row} of {len(self.inputs)} values of inputs")
            for name, value in zip(self.function.inputs, values):
                sim.inputs[name] = float(value)
            before = len(sim._core.times())
            if self.function.control_step is None:
                sim.step()
            else:
                sim.advance(until=(row + 1) * self.function.control_step)
            rows += [row] * (len(sim._core.times()) - before)
        return np.array(rows)

    def _observe(self) -> None:
        found, self.shapes, derivatives = [], [], []
        for what in self.function.observations:
            history, _, quantity = what.partition(".")
            now = np.asarray(self.sim[history][quantity])
            self.shapes.append(now.shape)
            values = np.asarray(self.sim.records[history][quantity]) if self.function.records else now
            found.append(values.reshape(len(values), -1)[self._states()] if self.function.records else values.ravel())
            if self.function.carried:
                derivatives.append(np.stack([np.ravel(self.sim[history].derivative(name)[quantity]) for name in self.function.parameters], axis=-1))
        self.values = np.concatenate(found, axis=-1)
        self.jacobian = np.concatenate(derivatives) if derivatives else None

    def _states(self) -> Any:
        """Which of all states are observed."""
        if self.function.records is True:
            return slice(None)
        return np.append(np.flatnonzero(np.diff(self.owner)), len(self.owner) - 1)

    def spread(self, weights: Array) -> Array:
        """Weights of what is observed as weights of all states, where these are recorded."""
        if self.function.records is not True and self.function.records:
            everywhere = np.zeros((len(self.owner), weights.shape[1]))
            everywhere[self._states()] = weights
            return everywhere
        return weights

    def courses(self, by_states: Array) -> Array:
        """The gradient by the values that were given [T,m], of that by the inputs at the end of each step [S,m]."""
        gradient, times = np.zeros_like(self.inputs), self.sim.records.time
        for column, linear in enumerate(self.function._linear):
            for state, row in enumerate(self.owner):
                if row < 0:
                    continue  # before the first value
                share = 1.0
                if linear and self.function.control_step is not None:
                    share = min(times[state] / self.function.control_step - row, 1.0)
                gradient[row, column] += share * by_states[state, column]
                if row > 0:
                    gradient[row - 1, column] += (1.0 - share) * by_states[state, column]
        return gradient
