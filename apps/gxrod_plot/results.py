"""Reads results files of gxrod: /VTKHDF frames, /histories and /ledger, up to the last complete step."""

import time
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

from .errors import FileFault, UsageError
from .found import read_found
from .mechanism import read_ends
from .response import read_response
from .path import read_paths
from .sweep import read_sweep

VERTEX = 1
NO_HISTORIES = ("time", "stage", "load_factor", "limit_load_factor", "branch")  # columns of all of them
# How far, how fast, what drives, what is passed on.
JOINT_QUANTITIES = ("angle", "angle_rate", "slide", "slide_rate", "elongation", "axial_force", "drive", "friction", "force", "moment",
                    "force_a", "moment_a", "gap")
CURVES = {3, 21, 35, 68}  # VTK cell types of rod elements: the two ends first, then the nodes between


@dataclass
class Series:
    """Rows of one quantity over the steps."""

    name: str
    values: np.ndarray  # [S] or [S, k]
    frame: str
    dimension: str


@dataclass
class History:
    """What was recorded at one named point."""

    name: str
    at: str
    quantities: list


class Results:
    """An open results file. Arrays are read when asked for."""

    def __init__(self, file, path):
        self._file = file
        self._path = path
        self._grid = file["VTKHDF"]
        self.title = text_of(file.attrs, "title") or text_of(file.attrs, "deck_name")
        self.deck = text_of(file.attrs, "deck_name")
        self.version = text_of(file.attrs, "gxrod_version")
        self.status = text_of(file.attrs, "status")
        self.reason = text_of(file.attrs, "reason")
        self.units = text_of(file.attrs, "units")
        self.is_static = text_of(file.attrs, "analysis") == "static"
        self.has_paths = "load_factor" in file["histories"]
        self.follows_limits = "limit_load_factor" in file["histories"]
        self.time_label = time_label_of(file, self.has_paths, self.is_static)
        # The times are written last, so their number is that of complete steps.
        self.times = file["histories/time"][()]
        self.frame_times = self._grid["Steps/Values"][()]
        self._points = int(self._grid["NumberOfPoints"][0])
        self.rods, self.bodies = self._read_cells()

    def found(self):
        """What stages have found that take no steps."""
        return read_found(self._path, self._file)

    def responses(self):
        """The answers of stages to forces that swing."""
        stages = self._file.get("stages", {})
        asked = {name: {series.name for series in self.history(name).quantities} for name in self.history_names}
        return [read_response(stages[name], name, asked) for name in stages if "histories" in stages[name]]

    def sweeps(self):
        """Modes that stages have followed over a number of the deck."""
        stages = self._file.get("stages", {})
        return [read_sweep(stages[name], name) for name in stages if "value" in stages[name]]

    @property
    def history_names(self):
        return [name for name in self._file["histories"] if name not in NO_HISTORIES]

    def paths(self):
        """What stages that go along a path have found."""
        return read_paths(self._file, len(self.times))

    def load_factors(self):
        return self._file["histories/load_factor"][: len(self.times)] if self.has_paths else self.times

    def limit_load_factors(self):
        """Of rows where limit points are followed; NaN elsewhere, where the file has the load factor."""
        limits = self._file["histories/limit_load_factor"][: len(self.times)]
        return np.where(limits == self.load_factors(), np.nan, limits)

    def history(self, name):
        group = self._file["histories"][name]
        return History(name, text_of(group.attrs, "at"), [self._series(group, key) for key in list_quantities(group)])

    def ends(self, table):
        """What joins points: of joints, springs or bushings."""
        return read_ends(self._file, table)

    def ledger(self):
        group = self._file["ledger"]
        return {key: self._series(group, key) for key in group if key != "time"}

    def frame(self, index, field="Points"):
        """Values of all points in a frame: Points, or one of PointData."""
        rows = slice(index * self._points, (index + 1) * self._points)
        return self._field(field)[rows]

    def trace(self, node, stride=1, field="Points"):
        """Values of one point in every frame, or in every `stride`-th."""
        return self._field(field)[node : len(self.frame_times) * self._points : stride * self._points]

    def _field(self, name):
        return self._grid[name] if name == "Points" else self._grid["PointData"][name]

    def _series(self, group, key):
        dataset = group[key]
        return Series(key, dataset[: len(self.times)], text_of(dataset.attrs, "frame"),
                      text_of(dataset.attrs, "dimension"))

    def _read_cells(self):
        """Polylines of point numbers, one a rod; and the points of bodies."""
        connectivity = self._grid["Connectivity"][()]
        offsets = self._grid["Offsets"][()]
        rods, bodies = [], []
        for kind, first, last in zip(self._grid["Types"][()], offsets[:-1], offsets[1:]):
            cell = connectivity[first:last]
            if kind == VERTEX:
                bodies.append(int(cell[0]))
            elif kind in CURVES:
                nodes = [cell[0], *cell[2:], cell[1]]
                if rods and rods[-1][-1] == nodes[0]:
                    rods[-1].extend(nodes[1:])
                else:
                    rods.append(nodes)
        return [np.array(rod) for rod in rods], bodies


def list_quantities(group):
    """Of joints and springs in a reader's order, else in the file's."""
    if set(group) <= set(JOINT_QUANTITIES):
        return sorted(group, key=JOINT_QUANTITIES.index)
    return list(group)


def time_label_of(file, has_paths, is_static):
    if has_paths:
        return "time" if "stage" in file["histories"] else "arc length"
    return "load factor" if is_static else "time"


def text_of(attributes, name):
    value = attributes.get(name, "")
    return value.decode() if isinstance(value, bytes) else str(value)


def read_results(path, draw):
    """Calls `draw` with the Results of the file at `path`; again if a job is writing it meanwhile."""
    path = Path(path)
    if not path.exists():
        raise FileFault(f"{path}: there is no such file")
    if path.is_dir():
        raise FileFault(f"{path}: is a folder, not a results file")
    if not path.is_file():
        raise FileFault(f"{path}: is not a regular file")
    attempts = 4
    for attempt in range(1, attempts + 1):
        try:
            with h5py.File(path, "r") as file:
                check_is_results(path, file)
                return draw(Results(file, path))
        except (OSError, RuntimeError, KeyError) as error:
            if attempt == attempts:
                raise FileFault(f"{path}: cannot be read as results of gxrod: {error}") from error
            time.sleep(0.15)


def check_is_results(path, file):
    for name in ("VTKHDF/Steps", "histories/time", "ledger"):
        if "gxrod_version" not in file.attrs or name not in file:
            raise FileFault(f"{path}: is not a results file of gxrod")


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
