"""A rod as an environment to learn in, and many of them side by side, with the interfaces of gymnasium."""

from __future__ import annotations

import math
import os
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
    import gymnasium.vector
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
        limits = limits_of(actions)
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


class RodVectorEnv(gymnasium.vector.VectorEnv[Any, Any, Any]):
    """Environments of one deck side by side, which threads step at once; each has the numbers that `RodEnv` has.

        envs = gxrod.gym.RodVectorEnv("arm.toml", 16, actions={"tendon": (-0.1, 0.1)}, observations=["tip.position"],
                                      control_step=0.02, reward=lambda seen, actions: -abs(seen[:, 2]))

    deck, actions, observations, control_step, on_reset, failure_reward: as of `RodEnv`. num_envs: n, how many. reward:
    `function(observations [n,k], actions [n,m])`, the rewards [n], called after each step. terminated:
    `function(observations)`, which tasks are over [n]. threads: that share the environments, by default as many as there are
    cores. autoreset_mode: one of `gymnasium.vector.AutoresetMode`, by default NEXT_STEP: the step after the end of an episode
    takes no action and begins the next one.

    `sims` has the simulations. They keep no records of their steps unless the option `record` says so. infos has "time" and, of
    steps that do not converge, "error".
    """

    metadata: dict[str, Any] = {"render_modes": [], "autoreset_mode": gymnasium.vector.AutoresetMode.NEXT_STEP}

    def __init__(self, deck: Model | Deck | AnyPath, num_envs: int, actions: Mapping[str, tuple[float, float]], observations: Sequence[str], control_step: float,
                 reward: Callable[[Array, Array], Array], terminated: Callable[[Array], Array] | None = None,
                 on_reset: Callable[[Simulation, np.random.Generator, dict[str, Any]], object] | None = None, failure_reward: float = 0.0,
                 threads: int | None = None, autoreset_mode: Any = gymnasium.vector.AutoresetMode.NEXT_STEP, **options: Any) -> None:
        from . import Simulation, _core

        if not control_step > 0.0:
            raise Error(f"control_step is {control_step}; expected a time greater than 0")
        if not actions or not observations or num_envs < 1:
            raise Error("environments need actions, observations and a number of them of at least 1")
        self.num_envs, self.control_step, self.failure_reward = int(num_envs), float(control_step), float(failure_reward)
        self.autoreset_mode = gymnasium.vector.AutoresetMode(autoreset_mode)
        self.metadata = {**type(self).metadata, "autoreset_mode": self.autoreset_mode}
        self._reward, self._terminated, self._on_reset = reward, terminated, on_reset
        model = build(deck)
        self.sims = [Simulation(model, **{"record": [], **options}) for _ in range(self.num_envs)]
        self._group = _core.Group([sim._core for sim in self.sims], list(actions), self._find_columns(observations), threads or os.cpu_count() or 1)
        self._spaces(limits_of(actions))
        self._randoms: list[Any] = [None] * self.num_envs
        self._ended = np.zeros(self.num_envs, dtype=bool)
        self._times = np.zeros(self.num_envs)

    def reset(self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        """Back to t = 0: (observations [n,k], infos). seed: one for all, of which environment i gets seed + i, or a list. options: a dict for `on_reset`; its "reset_mask" [n] says which environments are reset, by default all."""
        options = dict(options or {})
        mask = np.asarray(options.pop("reset_mask", np.ones(self.num_envs, dtype=bool)), dtype=bool)
        if mask.shape != (self.num_envs,):
            raise Error(f"reset_mask has the shape {mask.shape}; expected ({self.num_envs},)")
        seeds = [None if seed is None else seed + i for i in range(self.num_envs)] if seed is None or isinstance(seed, int) else list(seed)
        for i in np.flatnonzero(mask):
            if seeds[i] is not None or self._randoms[i] is None:
                self._randoms[i] = gymnasium.utils.seeding.np_random(seeds[i])[0]
        self._restart(np.flatnonzero(mask), options)
        return self._observe(), {"time": self._times.copy(), "_time": mask}

    def step(self, actions: Any) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """Holds the actions [n,m] for a control step: (observations [n,k], rewards [n], terminated [n], truncated [n], infos)."""
        actions = np.asarray(actions, dtype=np.float64).reshape(self.action_space.shape)
        actions = np.minimum(np.maximum(actions, self.action_space.low), self.action_space.high)
        rests = self._ended.copy()
        if rests.any() and self.autoreset_mode != gymnasium.vector.AutoresetMode.NEXT_STEP:
            raise Error("an episode has ended; reset(options={\"reset_mask\": …}) begins the next one")
        # The end of the control step, at a multiple of it, so that round-off of many steps does not add up.
        until = (np.floor(self._times / self.control_step + 1e-9) + 1.0) * self.control_step
        until[rests] = np.nan
        failures = self._group.advance(actions, until)
        self._restart(np.flatnonzero(rests), {})
        seen = self._observe()
        failed = np.array([failure != "" for failure in failures])
        terminated = failed | self._ask(self._terminated, seen) if self._terminated else failed
        truncated = np.array(self._group.ended()) & ~failed
        rewards = np.where(failed, self.failure_reward, self._ask(self._reward, seen, actions))
        rewards[rests], terminated[rests], truncated[rests] = 0.0, False, False
        infos: dict[str, Any] = {"time": self._times.copy(), "_time": np.ones(self.num_envs, dtype=bool)}
        for i in np.flatnonzero(failed):
            infos = self._add_info(infos, {"error": failures[i]}, i)
        self._ended = terminated | truncated
        if self.autoreset_mode == gymnasium.vector.AutoresetMode.SAME_STEP and self._ended.any():
            seen = self._begin_again(seen, infos)
        return seen, rewards, terminated, truncated, infos

    def close_extras(self, **_: Any) -> None:
        """Ends the simulations."""
        for sim in self.sims:
            sim.close()

    def _find_columns(self, observations: Sequence[str]) -> list[tuple[int, int]]:
        """What the group observes; and the columns of all observations, of which those that the group does not have are evaluated one by one."""
        grouped: list[tuple[int, int]] = []
        self._others: list[tuple[str, slice]] = []
        self.observation_names: list[str] = []
        own: list[int] = []
        first = self.sims[0]
        for what in observations:
            names = component_names(what, evaluate(first, what))
            columns = range(len(self.observation_names), len(self.observation_names) + len(names))
            history, _, quantity = what.partition(".")
            if history in ("time", "ledger"):
                self._others.append((what, slice(columns.start, columns.stop)))
            else:
                index = first._names.index(history)
                grouped.append((index, first._core.quantities(index).index(quantity)))
                own += columns
            self.observation_names += names
        self._own = np.array(own, dtype=int)
        return grouped

    def _spaces(self, limits: Array) -> None:
        space = gymnasium.spaces.Box
        self.single_action_space = space(limits[:, 0], limits[:, 1], dtype=np.float64)
        self.single_observation_space = space(-np.inf, np.inf, (len(self.observation_names),), dtype=np.float64)
        self.action_space = gymnasium.vector.utils.batch_space(self.single_action_space, self.num_envs)
        self.observation_space = gymnasium.vector.utils.batch_space(self.single_observation_space, self.num_envs)

    def _restart(self, which: Array, options: dict[str, Any]) -> None:
        if len(which) == 0:
            return
        self._group.reset(which.tolist())
        self._ended[which] = False
        if self._on_reset:
            for i in which:
                self._on_reset(self.sims[i], self._randoms[i], options)
            self._group.observe(which.tolist())

    def _begin_again(self, seen: Array, infos: dict[str, Any]) -> Array:
        which = np.flatnonzero(self._ended)
        for i in which:
            infos.update(self._add_info(infos, {"final_obs": seen[i].copy(), "final_info": {"time": self._times[i]}}, i))
        self._restart(which, {})
        seen = self._observe()
        infos["time"][which] = self._times[which]
        return seen

    def _observe(self) -> Array:
        grouped = np.empty((self.num_envs, self._group.width))
        self._group.copy(grouped, self._times)
        if not self._others:
            return grouped
        seen = np.empty((self.num_envs, len(self.observation_names)))
        seen[:, self._own] = grouped
        for what, columns in self._others:
            if what == "time":
                seen[:, columns] = self._times[:, None]
            else:
                seen[:, columns] = [np.ravel(evaluate(sim, what)) for sim in self.sims]
        return seen

    def _ask(self, function: Callable[..., Any], *arguments: Array) -> Array:
        answer = np.asarray(function(*arguments))
        if answer.shape != (self.num_envs,):
            raise Error(f"reward and terminated are called once for all {self.num_envs} environments and answer an array ({self.num_envs},); this one has the shape {answer.shape}")
        return answer


def limits_of(actions: Mapping[str, tuple[float, float]]) -> Array:
    """The lowest and highest of each action [m,2]."""
    limits = np.array(list(actions.values()), dtype=np.float64).reshape(-1, 2)
    if not (limits[:, 0] < limits[:, 1]).all():
        raise Error(f"actions are {dict(actions)}; expected a lower and a higher limit for each")
    return limits


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
