"""Columns of tables; pandas and xarray, which only some methods need."""

import numpy as np


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
        raise ImportError("tables of gxrod as DataFrames need pandas: python3 -m pip install pandas") from missing
    return pandas


def import_xarray():
    try:
        import xarray
    except ImportError as missing:
        raise ImportError("results of gxrod as Datasets need xarray: python3 -m pip install xarray") from missing
    return xarray
