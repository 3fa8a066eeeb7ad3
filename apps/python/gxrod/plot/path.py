"""Paths of equilibria: the load factor over what histories recorded, with critical points and branches."""

from dataclasses import dataclass

import numpy as np
from matplotlib.lines import Line2D

from .style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE

COLUMNS = 2
PANEL_HEIGHT = 3.4
KEYS_HEIGHT = 0.35
BRANCH_COLOURS = (ORANGE, GREEN, PURPLE, "#d1373f", "#8a6d1f", "#2aa0b8")
MARKERS = {"limit": ("^", "limit point"), "bifurcation": ("o", "bifurcation"), "divergence": ("s", "divergence"),
           "touch": ("v", "contact begins"), "release": ("1", "contact ends")}
STILL = 1e-9  # components that change by less of the largest change are not drawn


@dataclass
class Path:
    """The main path of a stage, or a branch."""

    name: str
    rows: np.ndarray  # of the histories; the first one of a branch is where it begins
    is_stable: np.ndarray  # of each row but the last: what follows it


@dataclass
class PathStage:
    """What a stage that goes along a path has found."""

    stage: str
    load_factors: np.ndarray  # of all rows of the histories
    paths: list
    points: list  # pairs of kind and row


def read_paths(results):
    """A PathStage for each stage that goes along a path; of a run that was killed, without points."""
    columns = results.columns
    if "load_factor" not in columns:
        return []
    # Where limit points are followed, those of them; of other stages both are the same.
    loads = columns.get("limit_load_factor", columns["load_factor"])
    pivots = results.solver.negative_pivots
    return [read_stage(stage, loads, columns["branch"], pivots) for stage in results.stages.values() if stage.kind == "path"]


def read_stage(stage, loads, branches, pivots):
    points = [(row["kind"], row["row"]) for row in stage.critical_points]
    table = list(stage.branches)
    own = np.arange(len(loads))[stage.rows]
    paths = []
    for number in np.unique(branches[own]):
        rows = own[branches[own] == number]
        beyond = pivots[rows]
        label = stage.name
        if table:
            branch = table[number]
            label = branch["name"]
            if branch["parent"] >= 0:
                rows = np.concatenate([[points[branch["critical_point"]][1]], rows])
                beyond = np.concatenate([[beyond[0]], beyond])
        paths.append(Path(label, rows, beyond[:-1] <= 0))
    return PathStage(stage.name, loads, paths, points)


def path_curves(panels):
    """Label, values, dimension and unit of each component of these histories that changes."""
    curves = []
    for history, series in panels:
        values = series.values.reshape(len(series.values), -1)
        letters = {1: [""], 3: [" x", " y", " z"], 4: [" w", " x", " y", " z"]}[values.shape[1]]
        spread = np.ptp(values, axis=0)
        for letter, column, change in zip(letters, values.T, spread):
            if change > STILL * spread.max():
                label = f"{history.name}: {series.name.replace('_', ' ')}{letter}"
                curves.append((label, column, series.dimension, series.unit))
    return curves


def section_height(stages, curves):
    return PANEL_HEIGHT * row_count(curves) * len(stages) + KEYS_HEIGHT


def row_count(curves):
    return max(1, -(-len(curves) // COLUMNS))


def draw_paths(figure, stages, curves):
    """Fills a figure or subfigure: for each stage a panel for each curve."""
    columns = min(COLUMNS, len(curves))
    height = section_height(stages, curves)
    figure, keys = figure.subfigures(2, 1, height_ratios=(height - KEYS_HEIGHT, KEYS_HEIGHT))
    grid = figure.subplots(row_count(curves) * len(stages), columns, squeeze=False)
    places = [(stage, curve) for stage in stages for curve in curves + [None] * (-len(curves) % columns)]
    for axes, (stage, curve) in zip(grid.flat, places):
        if curve is None:
            axes.remove()
        else:
            draw_path(axes, stage, len(stages) > 1, *curve)
    handles = list_keys(stages)
    keys.legend(handles=handles, loc="center", ncol=len(handles), handlelength=2.2)


def draw_path(axes, stage, has_stage, label, values, dimension, unit):
    for number, path in enumerate(stage.paths):
        for rows, is_stable in split_by_stability(path):
            axes.plot(*break_turns(values[rows], stage.load_factors[rows], dimension), color=colour_of(number),
                      linestyle="-" if is_stable else (0, (4, 2)))
    for kind, row in stage.points:
        axes.plot(values[row], stage.load_factors[row], MARKERS[kind][0], color=BLACK, markersize=5, zorder=3)
    axes.set_title(stage.stage if has_stage else "")
    axes.set_xlabel(f"{label} ({unit})" if unit else label)
    axes.set_ylabel("load factor λ")


def break_turns(values, loads, dimension):
    """With gaps where a rotation vector passes half a turn, and comes back with the opposite sign."""
    if dimension != "angle":
        return values, loads
    jumps = np.flatnonzero(np.abs(np.diff(values)) > np.pi) + 1
    return np.insert(values, jumps, np.nan), np.insert(loads, jumps, np.nan)


def split_by_stability(path):
    """Stretches of rows that are all stable or all unstable; neighbours share a row."""
    changes = np.flatnonzero(np.diff(path.is_stable)) + 1
    ends = [0, *changes, len(path.is_stable)]
    return [(path.rows[first : last + 1], path.is_stable[first]) for first, last in zip(ends, ends[1:]) if last > first]


def colour_of(number):
    return BLUE if number == 0 else BRANCH_COLOURS[(number - 1) % len(BRANCH_COLOURS)]


def list_keys(stages):
    keys = [Line2D([], [], color=GREY, label="stable"),
            Line2D([], [], color=GREY, linestyle=(0, (4, 2)), label="unstable")]
    kinds = {kind for stage in stages for kind, _ in stage.points}
    keys += [Line2D([], [], color=BLACK, linestyle="", marker=marker, markersize=5, label=words)
             for kind, (marker, words) in MARKERS.items() if kind in kinds]
    if len(stages) == 1 and len(stages[0].paths) > 1:
        keys += [Line2D([], [], color=colour_of(number), label=path.name)
                 for number, path in enumerate(stages[0].paths)]
    return keys
