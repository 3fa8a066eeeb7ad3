"""A rod as an environment to learn in, with the interface of gymnasium."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import ConvergenceError, Error, EvaluationError
from .mapping import evaluate
from .typed import AnyPath, Array

if TYPE_CHECKING:
    from .decks import Deck, Model
    from .simulation import Simulation

try:
    import gymnasium
except ImportError as missing:
    raise ImportError("gxrod.gym needs gymnasium: python3 -m pip install gymnasium") from missing


class RodEnv(gymnasium.Env[Any, Any]):
    """An environment of one deck: actions set its inputs, observations are what its histories record.

        env = gxrod.gym.RodEnv("arm.toml", actions={"tendon": (-0.1, 0.1)}, observations=["tip.position"],
                               control_step=0.02, reward=lambda sim, action: -abs(sim["tip"].position[2]))

    deck: the path of a deck, a `gxrod.Deck`, or a `gxrod.Model`. actions: {name of an `[input.NAME]`: (lowest, highest)};
    an action is an array [inputs] in that order, and what is outside is cut to the limits. observations: "HISTORY.QUANTITY",
    "ledger.QUANTITY" or "time"; an observation is an array [n] of float64 of all their components, named by
    `observation_names`. control_step: time for which an action is held, in the deck's unit. reward: `function(sim,
    action)`, called after each step. terminated: `function(sim)` that says whether the task is over, as when a target is
    reached. on_reset: `function(sim, random, options)` that changes a start, as by `sim.inputs`; `random` is a NumPy
    generator with the seed of reset. failure_reward: the reward of a step that does not converge; it terminates the
    episode, and `info["error"]` says why.

    An episode is truncated where the deck ends (`end_time`). reset() restores the state at t = 0 by a Checkpoint, to the
    last bit; the model is built once. info has "time". simulation: what makes a simulation of a model, by default
    `gxrod.Simulation`; further options are handed to it.
    """

    metadata: dict[str, Any] = {"render_modes": []}

    def __init__(self, deck: Model | Deck | AnyPath, actions: Mapping[str, tuple[float, float]], observations: Sequence[str], control_step: float,
                 reward: Callable[[Simulation, Array], float], terminated: Callable[[Simulation], object] | None = None,
                 on_reset: Callable[[Simulation, np.random.Generator, dict[str, Any]], object] | None = None, failure_reward: float = 0.0,
                 simulation: Callable[..., Any] | None = None, **options: Any) -> None:
        if not control_step > 0.0:
            raise Error(f"control_step is {control_step}; expected a time greater than 0")
        if simulation is None:
            from . import Simulation as simulation
        self.sim = simulation(build(deck), **options)
        self.control_step, self.failure_reward = float(control_step), float(failure_reward)
        self._reward, self._terminated, self._on_reset = reward, terminated, on_reset
        self._inputs, self._observations = list(actions), list(observations)
        if not self._inputs or not self._observations:
            raise Error("an environment needs actions and observations")
        limits = np.array([actions[name] for name in self._inputs], dtype=np.float64).reshape(-1, 2)
        if not (limits[:, 0] < limits[:, 1]).all():
            raise Error(f"actions are {dict(actions)}; expected a lower and a higher limit for each")
        for name in self._inputs:
            self.sim.inputs[name]  # an error here, if the deck has no such input
        self._start = self.sim.save()
        self._has_ended = False
        self.observation_names = [name for what in self._observations for name in component_names(what, evaluate(self.sim, what))]
        self.action_space = gymnasium.spaces.Box(limits[:, 0], limits[:, 1], dtype=np.float64)
        self.observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (len(self.observation_names),), dtype=np.float64)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        """Back to t = 0: (observation [n], info). seed: of the generator that `on_reset` gets. options: a dict for `on_reset`."""
        super().reset(seed=seed)
        self.sim.restore(self._start)
        self._has_ended = False
        if self._on_reset:
            self._on_reset(self.sim, self.np_random, options or {})
        return self._observe(), {"time": float(self.sim.time)}

    def step(self, action: Any) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Holds an action [inputs] for a control step: (observation [n], reward, terminated, truncated, info).

        Raises Error if the episode has ended; a step that does not converge raises nothing, but terminates it.
        """
        if self._has_ended:
            raise Error("the episode has ended; reset() begins the next one")
        action = np.clip(np.asarray(action, dtype=np.float64).reshape(self.action_space.shape), self.action_space.low, self.action_space.high)
        for name, value in zip(self._inputs, action):
            self.sim.inputs[name] = float(value)
        try:
            self.sim.advance(until=self._next_time())
        except (ConvergenceError, EvaluationError) as error:
            self._has_ended = True
            return self._observe(), self.failure_reward, True, False, {"time": float(self.sim.time), "error": str(error)}
        terminated = bool(self._terminated(self.sim)) if self._terminated else False
        truncated = bool(self.sim.finished)
        self._has_ended = terminated or truncated
        return self._observe(), float(self._reward(self.sim, action)), terminated, truncated, {"time": float(self.sim.time)}

    def close(self) -> None:
        """Ends the simulation."""
        close = getattr(self.sim, "close", None)
        if close:
            close()

    def _next_time(self) -> float:
        """The end of the control step, at a multiple of it, so that round-off of many steps does not add up."""
        steps = math.floor(self.sim.time / self.control_step + 1e-9) + 1
        return steps * self.control_step

    def _observe(self) -> Array:
        parts = [np.ravel(evaluate(self.sim, what)) for what in self._observations]
        return np.concatenate(parts).astype(np.float64)


def build(deck: Model | Deck | AnyPath) -> Model:
    """A model of the path of a deck, of a Deck, or the Model itself."""
    if isinstance(deck, str) or hasattr(deck, "__fspath__"):
        from . import Deck

        deck = Deck(deck)
    return deck.build() if hasattr(deck, "build") else deck


def component_names(what: str, values: Any) -> list[str]:
    """ "tip.position[0]" …, or the name itself of a number."""
    count = np.size(values)
    return [what] if np.ndim(values) == 0 else [f"{what}[{i}]" for i in range(count)]
