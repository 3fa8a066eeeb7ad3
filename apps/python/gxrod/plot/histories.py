"""Panels of histories: one for each quantity of each point."""

import numpy as np

from ..results.records import component_labels
from .style import AXIS_COLOURS, BLACK, ORANGE, PURPLE, draw_curves

COLUMNS = 3
JOINT_AXES = "joint axes of A"
EXTRA_COLOURS = (ORANGE, PURPLE)  # of stresses, which have six components


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
    width = values.shape[1]
    names = ("axis", "across 1", "across 2") if series.frame == JOINT_AXES else component_labels(series.name, width) if width > 1 else ()
    colours = [*([BLACK] if width in (4, 6) else []), *AXIS_COLOURS.values(), *EXTRA_COLOURS]
    curves = {name: (column, colour) for name, column, colour in zip(names, values.T, colours)}
    if values.shape[1] == 1:
        curves = {words(series.name): (values[:, 0], BLACK)}
    frame = describe_frame(series)
    draw_curves(axes, times, curves, f"{history.name}: {words(series.name)}{frame}", series.unit)


def describe_frame(series):
    """What a title says about the axes of the components; nothing for the global ones."""
    if series.frame == "material":
        return "" if "material" in series.name else ", material"
    if series.frame == JOINT_AXES:
        return ", joint axes"
    if series.frame == "bushing":
        return ", bushing axes"
    return f", {series.frame}" if series.frame.startswith("axes of ") else ""


def break_at_jumps(times, values):
    """Splits the curves of a rotation vector where it jumps from one end of a diameter to the other."""
    jumps = np.flatnonzero(np.linalg.norm(np.diff(values, axis=0), axis=1) > np.pi) + 1
    return np.insert(times, jumps, np.nan), np.insert(values, jumps, np.nan, axis=0)


def words(name):
    """A quantity as a reader says it; "force_a" of a joint is a force, whose axes the title names."""
    return name.removesuffix("_a").replace("_", " ")
