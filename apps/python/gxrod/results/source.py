"""A results file on the disk: opened for each reading, so that a run may write it meanwhile."""

import time
from pathlib import Path

import numpy as np

from ..errors import Error, FileError
from ..installing import pip_install
from ..plot.units import read_units, unit_of

# What h5py raises, and what follows where a damaged file has other things than expected.
UNREADABLE = (OSError, RuntimeError, LookupError, ValueError, TypeError, AttributeError, MemoryError)
ATTEMPTS, PAUSE = 4, 0.15  # seconds: a program that reads at the very moment of writing can fail


def import_h5py():
    try:
        import h5py
    except ImportError as missing:
        raise ImportError("reading results of gxrod needs h5py: python3 -m pip install h5py, or on Debian apt install "
                          "python3-h5py") from missing
    except ValueError as other:  # "numpy.dtype size changed"
        raise ImportError(f"h5py was compiled for another NumPy: {pip_install('h5py')}") from other
    return h5py


def plain(value):
    """An attribute as text, number or array."""
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, np.generic):
        return plain(value.item())
    if isinstance(value, np.ndarray) and value.shape == (1,):
        return plain(value[0])
    return value


def read_column(dataset):
    """A whole dataset; texts as an array of str."""
    values = dataset[()]
    if dataset.dtype.kind == "O":
        return np.array([plain(text) for text in values], dtype=object)
    return values


class Source:
    """What all parts of a file's results share: how far it goes, and how to read more of it.

    Steps and frames are those that the file had when it was opened or `refresh` was called; those that a run has added
    since are not seen. So all arrays fit together.
    """

    def __init__(self, path):
        self.path = Path(path)
        self.refresh()

    def refresh(self):
        """Sees what the file has now."""
        self.cache = {}
        self._open(self._look)

    def _look(self, file):
        for name in ("VTKHDF/Steps", "histories/time", "ledger"):
            if "gxrod_version" not in file.attrs or name not in file:
                raise FileError(f"{self.path}: is not a results file of gxrod")
        self.attributes = {name: plain(value) for name, value in file.attrs.items()}
        # The times are written last, so their number is that of complete steps, and of frames.
        self.times = file["histories/time"][()]
        self.frame_times = file["VTKHDF/Steps/Values"][()]
        self.sample_times = file["sampled/time"][()] if "sampled" in file else None
        self.points, self.cells = (int(file["VTKHDF"][name][0]) for name in ("NumberOfPoints", "NumberOfCells"))
        self.columns = [name for name, entry in file["histories"].items() if hasattr(entry, "shape") and name != "time"]
        self.units = read_units(self.attributes.get("units", ""))
        self.time_dimension = plain(file["histories/time"].attrs.get("dimension", "time"))

    @property
    def is_static(self):
        return self.attributes.get("analysis") == "static"

    @property
    def time_name(self):
        """What steps go along: "time", "load_factor" or "arc_length"."""
        if "load_factor" in self.columns:
            return "time" if "stage" in self.columns else "arc_length"
        return "load_factor" if self.is_static else "time"

    @property
    def time_unit(self):
        return self.unit(self.time_dimension) if self.time_name == "time" else ""

    def unit(self, dimension):
        """As "m/s²", where the deck's label names units, else ""; angles are in rad."""
        unit = unit_of(dimension, self.units)
        return "" if unit == dimension.replace("angle", "rad") and dimension not in ("angle",) else unit

    def read(self, function):
        """function(file) of the open file."""
        def read_same(file):
            times = file["histories/time"]
            count = len(self.times)
            if len(times) < count or (count and times[count - 1] != self.times[-1]):
                raise FileError(f"{self.path}: another run has replaced it since it was opened; refresh() takes the new results")
            return function(file)

        return self._open(read_same)

    def once(self, key, function):
        """function(file), read once."""
        if key not in self.cache:
            self.cache[key] = self.read(function)
        return self.cache[key]

    def _open(self, function):
        h5py = import_h5py()
        check_is_file(self.path)
        for attempt in range(1, ATTEMPTS + 1):
            try:
                with h5py.File(self.path, "r") as file:
                    return function(file)
            except Error:
                raise
            except UNREADABLE as error:
                if attempt == ATTEMPTS:
                    raise FileError(f"{self.path}: cannot be read as results of gxrod: {error}") from error
                time.sleep(PAUSE)


def check_is_file(path):
    if not path.exists():
        raise FileError(f"{path}: there is no such file")
    if path.is_dir():
        raise FileError(f"{path}: is a folder, not a results file")
    if not path.is_file():
        raise FileError(f"{path}: is not a regular file")
