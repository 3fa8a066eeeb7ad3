"""What pictures take from results files of gxrod: frames, histories and the ledger, up to the last complete step."""

from dataclasses import dataclass

import numpy as np

from ..errors import Error
from ..results import open_results, read_cells
from .errors import FileFault, PlotError, UsageError
from .found import read_found
from .mechanism import read_ends
from .path import read_paths
from .response import read_response
from .sweep import read_sweep
from .units import read_units, unit_of

# How far, how fast, what drives, what is passed on.
JOINT_QUANTITIES = ("angle", "angle_rate", "slide", "slide_rate", "elongation", "axial_force", "drive", "friction", "force", "moment",
                    "force_a", "moment_a", "gap")


@dataclass
class Series:
    """Rows of one quantity over the steps."""

    name: str
    values: np.ndarray  # [S] or [S, k]
    frame: str
    dimension: str
    unit: str  # by the deck's label, else the dimension


@dataclass
class History:
    """What was recorded at one named point."""

    name: str
    at: str
    quantities: list


class Results:
    """What pictures take from an opened file: gxrod.results.Results in arrays and polylines."""

    def __init__(self, results):
        self.results = results
        self.title = results.title
        self.deck = results.deck_name
        self.version = results.version
        self.status = results.status
        self.reason = results.reason
        self.units = results.units
        self._names = read_units(results.units)
        self.is_static = results.analysis == "static"
        self.has_paths = "load_factor" in results.columns
        self.follows_limits = "limit_load_factor" in results.columns
        self.time_label = results.time_name.replace("_", " ")
        self.times = results.time
        self.frame_times = results.frames.time
        cells = read_cells(results)
        self.rods, self.bodies = cells.polylines(), cells.body_nodes()

    def found(self):
        """What stages have found that take no steps."""
        return read_found(self.results)

    def responses(self):
        """The answers of stages to forces that swing."""
        asked = {name: set(history) for name, history in self.results.histories.items()}
        return [read_response(stage, asked) for stage in self.results.stages.values() if stage.kind == "response"]

    def sweeps(self):
        """Modes that stages have followed over a number of the deck."""
        return [read_sweep(stage, self.results.units) for stage in self.results.stages.values() if "values" in stage]

    @property
    def history_names(self):
        return list(self.results.histories)

    def paths(self):
        """What stages that go along a path have found."""
        return read_paths(self.results)

    def load_factors(self):
        return self.results.load_factor

    def limit_load_factors(self):
        """Of rows where limit points are followed; NaN elsewhere, where the file has the load factor."""
        limits = self.results.columns["limit_load_factor"]
        return np.where(limits == self.load_factors(), np.nan, limits)

    def history(self, name):
        history = self.results[name]
        return History(name, history.at, [self._series(history, key) for key in list_quantities(history)])

    def ends(self, table):
        """What joins points: of joints, sleeves, springs or bushings."""
        return read_ends(getattr(self.results, table))

    def outlines(self):
        """What bodies look like."""
        return list(self.results.outlines.values())

    def ledger(self):
        return {key: self._series(self.results.ledger, key) for key in self.results.ledger}

    def unit_of(self, dimension):
        """By the deck's label, "N·m" for "force·length"; the dimension itself where it does not say."""
        return unit_of(dimension, self._names)

    def _series(self, record, key):
        quantity = record.describe(key)
        return Series(key, record[key], quantity.frame, quantity.dimension, self.unit_of(quantity.dimension))

    def frame(self, index, field="position"):
        """Values of all points in a frame."""
        return self.results.frames[index][field]

    def trace(self, node, stride=1, field="position"):
        """Values of one point in every frame, or in every `stride`-th."""
        return self.results.frames[::stride].of_node(node, field)


def list_quantities(group):
    """Of joints and springs in a reader's order, else in the file's."""
    if set(group) <= set(JOINT_QUANTITIES):
        return sorted(group, key=JOINT_QUANTITIES.index)
    return list(group)


def read_results(path, draw):
    """Calls `draw` with the Results of the file at `path`."""
    try:
        return draw(Results(open_results(path)))
    except PlotError:
        raise
    except Error as error:
        raise FileFault(str(error)) from error


def choose_histories(results, wanted):
    """The histories named in `wanted`, as NAME or NAME/QUANTITY; all if it is empty."""
    histories = []
    for name in wanted or results.history_names:
        point, _, quantity = name.partition("/")
        if point not in results.history_names:
            raise UsageError(f"there is no history {point!r}; {listing(results.history_names)}")
        history = results.history(point)
        if quantity:
            names = [series.name for series in history.quantities]
            if quantity not in names:
                raise UsageError(f"history {point!r} has no {quantity!r}; {listing(names)}")
            history.quantities = [series for series in history.quantities if series.name == quantity]
        histories.append(history)
    return histories


def listing(names):
    return "the file has " + ", ".join(names) if names else "the file has none"
