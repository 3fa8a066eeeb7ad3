"""Panels of histories: one for each quantity of each point."""

import numpy as np

from .style import AXIS_COLOURS, BLACK, draw_curves

COLUMNS = 3


def history_panels(histories):
    """Pairs of a point and one of its quantities, in the order of drawing."""
    return [(history, series) for history in histories for series in history.quantities]


def row_count(panels):
    return -(-len(panels) // COLUMNS)


def draw_histories(figure, results, panels):
    """Fills a figure or subfigure with the panels, COLUMNS in a row."""
    columns = min(COLUMNS, len(panels))
    grid = figure.subplots(row_count(panels), columns, squeeze=False)
    for axes, (history, series) in zip(grid.flat, panels):
        draw_series(axes, results.times, history, series)
    for axes in grid.flat[len(panels):]:
        axes.remove()
    # The lowest panel of each column, also where the last row is not full.
    for column in range(columns):
        last = (len(panels) - 1 - column) // columns
        grid[last, column].set_xlabel(results.time_label)


def draw_series(axes, times, history, series):
    values = series.values.reshape(len(series.values), -1)
    if series.name == "rotation_vector":
        times, values = break_at_jumps(times, values)
    letters = "wxyz" if values.shape[1] == 4 else "xyz"
    colours = {"w": BLACK, **AXIS_COLOURS}
    curves = {letter: (column, colours[letter]) for letter, column in zip(letters, values.T)}
    if values.shape[1] == 1:
        curves = {words(series.name): (values[:, 0], BLACK)}
    frame = describe_frame(series)
    label = series.dimension if series.dimension != "1" else ""
    draw_curves(axes, times, curves, f"{history.name}: {words(series.name)}{frame}", label)


def describe_frame(series):
    """What a title says about the axes of the components; nothing for the global ones."""
    if series.frame == "material":
        return "" if "material" in series.name else ", material"
    return f", {series.frame}" if series.frame.startswith("axes of ") else ""


def break_at_jumps(times, values):
    """Splits the curves of a rotation vector where it jumps from one end of a diameter to the other."""
    jumps = np.flatnonzero(np.linalg.norm(np.diff(values, axis=0), axis=1) > np.pi) + 1
    return np.insert(times, jumps, np.nan), np.insert(values, jumps, np.nan, axis=0)


def words(name):
    return name.replace("_", " ")
