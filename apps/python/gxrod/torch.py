"""Runs as functions of PyTorch."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from .decks import Deck, Model
from .functions import RunFunction
from .typed import AnyPath, Names

try:
    import torch
except ImportError as missing:
    raise ImportError("gxrod.torch needs PyTorch: python3 -m pip install torch") from missing


def torch_run(deck: Model | Deck | AnyPath, observations: Sequence[str], parameters: Names = (), inputs: Names = (), control_step: float | None = None,
                 records: bool | str = False, carried: bool = False, **options: Any) -> Callable[..., Any]:
    """A run of a deck as a function of tensors, through which `backward` goes.

        run = gxrod.torch.torch_run("arm.toml", ["tip.position"], parameters=["EI"])
        seen = run(torch.tensor([6.0], dtype=torch.float64, requires_grad=True))      # [3]
        seen[2].backward()

    deck: a `Deck`, a `Model`, or the path of a deck. observations: "HISTORY.QUANTITY", whose numbers come one after the other.
    parameters: names of [parameters], or other keys of numbers: the first argument has their n values. inputs: names of m
    inputs of the deck; the function then takes their values [T,m], alone or after the parameters, each for a `control_step`, or
    for one step without it. records: False for what is observed at the end of the run [k]; True for all states [S,k], that at
    t = 0 the first; "control" for the start and the ends of control steps [T+1,k]. carried: derivatives are carried along from step to step, for decks of which `Simulation.adjoint` has none.
    Further options are those of `Simulation`.

    The run is in double precision and on the CPU; its result has the type and the device of the argument. Steps that fail
    raise as those of a `Simulation` do. Derivatives are the first ones only.
    """
    function = RunFunction(deck, observations, parameters, inputs, control_step, records, carried, **options)

    def run(*arguments: Any) -> Any:
        if len(arguments) != bool(function.parameters) + bool(function.inputs):
            raise TypeError("expected " + " and ".join(["the parameters"] * bool(function.parameters) + ["the inputs"] * bool(function.inputs)))
        numbers = arguments[0] if function.parameters else arguments[0].new_zeros(0)
        return _Run.apply(function, numbers, arguments[-1] if function.inputs else None)

    return run


class _Run(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, function: RunFunction, numbers: Any, courses: Any) -> Any:
        ctx.function = function
        ctx.arguments = numbers.detach().cpu().double().numpy(), None if courses is None else courses.detach().cpu().double().numpy()
        ctx.like = numbers, courses
        return as_tensor(function(*ctx.arguments), numbers)

    @staticmethod
    @torch.autograd.function.once_differentiable
    def backward(ctx: Any, weights: Any) -> Any:
        numbers, courses = ctx.like
        by_numbers, by_courses = ctx.function.pull_back(*ctx.arguments, weights.cpu().double().numpy())
        return None, as_tensor(by_numbers, numbers).reshape(numbers.shape), None if courses is None else as_tensor(by_courses, courses)


def as_tensor(values: Any, like: Any) -> Any:
    return torch.as_tensor(values.copy()).to(dtype=like.dtype, device=like.device)
