"""gxrod: geometrically exact rods and rigid bodies in motion.

    r = gxrod.open_results("arm.vtkhdf")        what a run has written
    table = gxrod.read_batch("sweep")           the table of a batch; gxrod.batch("plan.toml") runs it
    sim = gxrod.Simulation(gxrod.Deck("arm.toml").build())
    gxrod.Section.profile("IPE 200", steel)     a cross-section: stiffness, centres, stresses
    gxrod.map(deck, cases, collect)             many runs, a row each
    gxrod.gym.RodEnv("arm.toml", …)             an environment to learn in; gxrod.gym.RodVectorEnv: many at once
    gxrod.torch.torch_run("arm.toml", …)     a run as a function with derivatives, of PyTorch or, by gxrod.jax, of JAX
    gxrod.fatigue.rainflow(stress)              cycles; damage, equivalent loads
    gxrod.importers.read_blade("blade.htc")     a blade of another program, for a deck

NumPy is needed; h5py by results; pandas, xarray, matplotlib, gymnasium, torch and jax by what is named after them.
"""

import importlib as _importlib
import importlib.util as _util
import typing as _typing

from .errors import ConvergenceError, DeckError, Error, EvaluationError, Fault, FileError, UnknownNameError

try:
    from ._version import __version__
except ImportError:  # in the source tree, which CMake has not configured
    __version__ = "unknown"

# Where names are that are imported when they are asked for.
_HOMES = {"open_results": "results", "Results": "results", "batch": "batches", "read_batch": "batches", "map": "mapping"}
_MODULES = ("batches", "fatigue", "gym", "importers", "jax", "mapping", "plot", "program", "results", "torch")
# What needs the compiled part, and where it is.
_COMPILED = {**dict.fromkeys(("Checkpoint", "Deck", "Model", "Section", "Simulation", "Step", "Summary", "schema"), "simulation"), "check_gradient": "gradients", "fatigue": "fatigue"}

if _typing.TYPE_CHECKING:  # the same names, for editors and type checkers
    from . import batches as batches, fatigue as fatigue, gym as gym, importers as importers, jax as jax, mapping as mapping, plot as plot, program as program, results as results, torch as torch
    from .batches import batch as batch, read_batch as read_batch
    from .decks import Deck as Deck, Model as Model, Section as Section, schema as schema
    from .gradients import check_gradient as check_gradient
    from .mapping import map as map
    from .results import Results as Results, open_results as open_results
    from .simulation import Checkpoint as Checkpoint, Simulation as Simulation, Step as Step, Summary as Summary

__all__ = ["ConvergenceError", "DeckError", "Error", "EvaluationError", "Fault", "FileError", "UnknownNameError", *_HOMES, "gym", *(name for name in _COMPILED if name not in _MODULES)]


if not _typing.TYPE_CHECKING:

    def __getattr__(name):
        if name in _HOMES:
            return _keep(name, getattr(_importlib.import_module(f"{__name__}.{_HOMES[name]}"), name))
        if name in _MODULES and name in _COMPILED:
            return _import_compiled(name)
        if name in _MODULES:
            return _importlib.import_module(f"{__name__}.{name}")
        if name in _COMPILED:
            return _keep(name, getattr(_import_compiled(name), name))
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def _keep(name, value):
    globals()[name] = value
    return value


def _import_compiled(name):
    """The module of a name that needs the compiled part."""
    try:
        return _importlib.import_module(f"{__name__}.{_COMPILED[name]}")
    except ImportError as missing:
        raise ImportError(f"gxrod.{name} needs the compiled part of the Python module, gxrod._core, which cannot be imported ({missing}); "
                          "`python3 -m pip install .` in the source tree of gxrod builds it. Results and batches work without it") from missing


def _has_core():
    return _util.find_spec(f"{__name__}._core") is not None


def __dir__():
    names = [*globals(), *_HOMES, *_MODULES, *(_COMPILED if _has_core() else ())]
    return sorted(name for name in set(names) if not name.startswith("_") or name in ("__version__", "__doc__", "__all__"))
