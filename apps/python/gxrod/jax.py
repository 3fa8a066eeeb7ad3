"""Runs as functions of JAX."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from .decks import Deck, Model
from .functions import RunFunction
from .typed import AnyPath, Names

try:
    import jax
    import jax.numpy as jnp
except ImportError as missing:
    raise ImportError("gxrod.jax needs JAX: python3 -m pip install jax") from missing


def jax_run(deck: Model | Deck | AnyPath, observations: Sequence[str], parameters: Names = (), inputs: Names = (), control_step: float | None = None,
                 records: bool | str = False, carried: bool = False, states: int | None = None, **options: Any) -> Callable[..., Any]:
    """A run of a deck as a function of arrays, through which `jax.grad` goes, also within `jit` and `vmap`.

        run = gxrod.jax.jax_run("arm.toml", ["tip.position"], parameters=["EI"])
        jax.grad(lambda numbers: run(numbers)[2])(jnp.array([6.0]))

    Arguments as of [`gxrod.torch.torch_run`](#torch_run). states: S, how many states there are with
    `records=True`; without it a run at the deck's own numbers, whose inputs rest, counts them. Where steps may be cut, "control" has
    as many states as there are control steps and one. Enable double precision by
    `jax.config.update("jax_enable_x64", True)`: otherwise what comes from runs is rounded to single precision.

    Derivatives are the first ones, backwards (`grad`, `vjp`, `jacrev`).
    """
    function = RunFunction(deck, observations, parameters, inputs, control_step, records, carried, **options)
    shapes = Shapes(function, states)

    def evaluate(*arguments: Any) -> Any:
        return call_back(lambda *values: function(*split(function, values)), shapes.of(*arguments), *arguments)

    def forward(*arguments: Any) -> Any:
        return evaluate(*arguments), arguments

    def backward(arguments: Any, weights: Any) -> Any:
        def pull_back(*values: Any) -> Any:
            gradients = function.pull_back(*split(function, values[:-1]), weights=values[-1])
            return tuple(gradient for gradient, is_there in zip(gradients, (function.parameters, function.inputs)) if is_there)

        like = tuple(jax.ShapeDtypeStruct(jnp.shape(one), jnp.result_type(one)) for one in arguments)
        return tuple(call_back(pull_back, like, *arguments, weights))

    run = jax.custom_vjp(evaluate)
    run.defvjp(forward, backward)
    return run


class Shapes:
    """The shapes of what a run returns, which JAX wants beforehand."""

    def __init__(self, function: RunFunction, states: int | None) -> None:
        self._function, self._states, self._known, self._count = function, states, {}, 0

    def of(self, *arguments: Any) -> Any:
        function = self._function
        rows = np.shape(arguments[-1])[0] if function.inputs else 0
        if rows not in self._known and function.records == "control" and self._count:
            return jax.ShapeDtypeStruct((rows + 1, self._count), jnp.result_type(float))
        if rows not in self._known:
            # A run at the deck's own numbers; its inputs rest.
            values = function(function.start, np.zeros((rows, len(function.inputs))) if function.inputs else None)
            self._known[rows] = (self._states, *values.shape[1:]) if self._states is not None and function.records is True else values.shape
            self._count = values.shape[-1]
        return jax.ShapeDtypeStruct(self._known[rows], jnp.result_type(float))


def split(function: RunFunction, values: Any) -> tuple[Any, Any]:
    """The parameters and the inputs of a function's arguments."""
    return values[0] if function.parameters else (), values[-1] if function.inputs else None


def call_back(work: Callable[..., Any], shapes: Any, *arguments: Any) -> Any:
    def in_the_types_of_jax(*values: Any) -> Any:
        return jax.tree_util.tree_map(lambda shape, value: np.asarray(value, dtype=shape.dtype), shapes, work(*map(np.asarray, values)))

    takes = inspect.signature(jax.pure_callback).parameters
    return jax.pure_callback(in_the_types_of_jax, shapes, *arguments, **({"vmap_method": "sequential"} if "vmap_method" in takes else {}))
