"""The compiled part of gxrod; `import gxrod` is how to use it."""

from collections.abc import Sequence
import os
from typing import Annotated, overload

import numpy
import numpy.typing
from numpy.typing import NDArray


version: str = ...

def schema() -> str:
    """The JSON Schema of decks, as text."""

class Section:
    """A section of a model, at the start of a rod."""

    @property
    def name(self) -> str: ...

    @property
    def stiffness(self) -> NDArray[numpy.float64]: ...

    @property
    def mass(self) -> NDArray[numpy.float64]: ...

    @property
    def shear_centre(self) -> NDArray[numpy.float64]: ...

    @property
    def tension_centre(self) -> NDArray[numpy.float64]: ...

    @property
    def has_shape(self) -> bool: ...

    @property
    def constants(self) -> dict: ...

    @property
    def points(self) -> NDArray[numpy.float64]: ...

    @property
    def operators(self) -> NDArray[numpy.float64]: ...

    @property
    def layers(self) -> list[str]: ...

    @property
    def singular(self) -> list[bool]: ...

    def describe(self) -> str: ...

    def draw(self, resultants: Sequence[float] | None) -> str: ...

class Deck:
    """A deck that was read once and is built many times."""

    @overload
    def __init__(self, path: str | os.PathLike) -> None: ...

    @overload
    def __init__(self, text: str, file: str | os.PathLike) -> None: ...

    @property
    def text(self) -> str: ...

    @property
    def file(self) -> str: ...

class Model:
    """A deck that was checked and built."""

    def __init__(self, deck: Deck, overrides: Sequence[str]) -> None: ...

    @property
    def text(self) -> str: ...

    @property
    def notes(self) -> list[str]: ...

    @property
    def nodes(self) -> int: ...

    @property
    def rods(self) -> dict:
        """{name: (nodes, arc lengths, nodes of each element, order)}."""

    @property
    def bodies(self) -> dict:
        """{name: node}."""

    @property
    def sections(self) -> list[Section]:
        """Those of the deck, and the means of rods whose section varies."""

    @property
    def inputs(self) -> list[str]: ...

    @property
    def histories(self) -> list[str]: ...

    def examine(self) -> list[str]: ...

class Checkpoint:
    """
    An accepted state to return to: `sim.save()` makes it, `sim.restore` returns to it; it can be pickled.
    """

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

    @property
    def time(self) -> float:
        """Of the state, on the axis of sim.time."""

class Simulation:
    """A run that is driven from outside."""

    def __init__(self, model: Model, results: str, threads: int, record: Sequence[str], sensitivities: Sequence[str]) -> None: ...

    def step(self) -> bool:
        """False if no step was accepted."""

    def advance(self, until: float | None, most_steps: int) -> int:
        """The number of steps that were accepted."""

    def close(self) -> None: ...

    def interrupt(self) -> None: ...

    def save(self) -> Checkpoint: ...

    def restore(self, checkpoint: Checkpoint) -> None: ...

    def set(self, input: str, value: float) -> None:
        """It counts from the next step on."""

    def input(self, name: str) -> float: ...

    def history(self, history: int, quantity: int) -> list[float]: ...

    def derivative(self, number: int, history: int, quantity: int) -> list[float]: ...

    def gradient(self, sum: Sequence[tuple[int, int, Sequence[float]]], model: Model, numbers: Sequence[str], inputs: Sequence[str]) -> tuple[list[float], list[list[float]]]:
        """By the numbers [n]; by the inputs [S,m]."""

    def quantities(self, history: int) -> list[str]: ...

    def ledger(self) -> dict:
        """{name: number or array [3]}."""

    def times(self) -> numpy.typing.NDArray[numpy.float64]:
        """Of each accepted step [S]."""

    def records(self, history: int, quantity: int) -> numpy.typing.NDArray[numpy.float64]:
        """[S], [S,3] or [S,4]."""

    def ledgers(self) -> dict:
        """{name: array [S] or [S,3]}."""

    def elements(self) -> dict:
        """{name: array [E,3]}, in section axes at the middles."""

    def matrices(self) -> tuple:
        """
        (values, rows, columns, size) of the tangent, the damping matrix and the mass matrix.
        """

    def unknowns(self) -> numpy.typing.NDArray[numpy.int64]:
        """Node and component of each [n,2]."""

    def summary(self) -> str:
        """As JSON."""

    @property
    def time(self) -> float: ...

    @property
    def ended(self) -> bool: ...

    @property
    def reason(self) -> str: ...

    @property
    def last_step(self, /) -> tuple[float, float, int, int]:
        """Its time, time step, Newton iterations and rejected steps."""

    @property
    def part_done(self) -> float: ...

    @property
    def stage(self) -> str: ...

    @property
    def position(self, /) -> numpy.typing.NDArray[numpy.float64]:
        """A read-only view [N,3], global components."""

    @property
    def velocity(self, /) -> numpy.typing.NDArray[numpy.float64]:
        """A read-only view [N,3], global components."""

    @property
    def acceleration(self, /) -> numpy.typing.NDArray[numpy.float64]:
        """A read-only view [N,3], global components."""

    @property
    def angular_velocity(self, /) -> numpy.typing.NDArray[numpy.float64]:
        """A read-only view [N,3], global components."""

    @property
    def angular_acceleration(self, /) -> numpy.typing.NDArray[numpy.float64]:
        """A read-only view [N,3], global components."""

    @property
    def rotation_vector(self, /) -> numpy.typing.NDArray[numpy.float64]:
        """A read-only view [N,3], global components."""

    @property
    def orientation(self, /) -> numpy.typing.NDArray[numpy.float64]:
        """A read-only view [N,4]: w x y z."""

class SNCurve:
    def find_fault(self) -> str: ...

    def endured_cycles(self, range: float) -> float: ...

def make_curve(lines: Sequence[Sequence[float]], limit: float, factor: float) -> SNCurve: ...

def list_eurocode_lines(category: float) -> tuple[list[list[float]], float]: ...

def rainflow(values: Sequence[float]) -> list[list[float]]:
    """Rows of range, mean and count."""

def compute_damage(cycles: Sequence[Sequence[float]], curve: SNCurve, ultimate: float) -> float: ...

def compute_equivalent_range(cycles: Sequence[Sequence[float]], slope: float, number: float) -> float: ...

class Group:
    """Simulations of one deck that threads advance side by side."""

    def __init__(self, members: Sequence[Simulation], inputs: Sequence[str], observed: Sequence[tuple[int, int]], threads: int) -> None: ...

    def advance(self, inputs: Annotated[NDArray[numpy.float64], dict(order='C', device='cpu', writable=False)], until: Annotated[NDArray[numpy.float64], dict(order='C', device='cpu', writable=False)]) -> list[str]:
        """
        Advances member i to until[i], unless that is NaN: why its step failed, or "".
        """

    def reset(self, members: Sequence[int]) -> None: ...

    def observe(self, members: Sequence[int]) -> None: ...

    def copy(self, seen: Annotated[NDArray[numpy.float64], dict(order='C', device='cpu')], times: Annotated[NDArray[numpy.float64], dict(order='C', device='cpu')]) -> None:
        """Copies the observations [n,width] and the times [n] into arrays."""

    def ended(self) -> list[bool]: ...

    @property
    def width(self) -> int: ...
