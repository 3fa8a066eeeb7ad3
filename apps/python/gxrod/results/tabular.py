"""Columns of tables; pandas and xarray, which only some methods need."""

import numpy as np

from ..installing import pip_install


def as_objects(values):
    """A column [n] of anything, also of lists."""
    column = np.empty(len(values), dtype=object)
    for row, value in enumerate(values):
        column[row] = value
    return column


def import_pandas():
    try:
        import pandas
    except ImportError as missing:
        raise ImportError(f"tables of gxrod as DataFrames need pandas: {pip_install('pandas')}") from missing
    return pandas


def import_xarray():
    try:
        import xarray
    except ImportError as missing:
        raise ImportError(f"results of gxrod as Datasets need xarray: {pip_install('xarray')}") from missing
    return xarray
