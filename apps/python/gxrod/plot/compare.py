"""Several results in one figure, and one quantity against another: a colour for each file, or for each curve."""

from dataclasses import dataclass, replace
from pathlib import Path

import matplotlib
import numpy as np

from .columns import read_columns
from .errors import FileFault, UsageError
from .style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, colour_keys, draw_panel, new_figure

COLUMNS = 3
PANEL = (4.1, 2.5)  # inches
ALONE = (8.4, 5.6)  # of a figure of one panel
TITLE_HEIGHT = 0.4
KEYS_HEIGHT = 0.3
COLOURS = (BLUE, ORANGE, GREEN, PURPLE, BLACK, GREY)
ENERGIES = ("kinetic_energy", "strain_energy", "external_work", "dissipated_energy", "energy_error")


@dataclass
class Run:
    """What is drawn of one file."""

    name: str
    time_label: str
    across: object  # Column
    upwards: list  # of Columns


def read_run(results, request, name):
    if len(results.times) == 0:
        raise FileFault(f"{name}: holds no complete step yet")
    across = read_columns(results, request.x or "time")
    if len(across) != 1:
        raise UsageError(f"--x {request.x}: give one component, as {request.x}/x")
    upwards = [column for wanted in names_upwards(results, request) for column in read_columns(results, wanted)]
    if results.has_paths:
        across, upwards = (split_branches(columns, results) for columns in (across, upwards))
    return Run(name, results.time_label, across[0], upwards)


def split_branches(columns, results):
    """The columns with a gap before each branch of a path, which then starts where it leaves another one."""
    starts = [(path.rows[1], path.rows[0]) for stage in results.paths() for path in stage.paths if len(path.rows) > 1 and path.rows[1] != path.rows[0] + 1]
    at = [start for start, _ in sorted(starts) for _ in range(2)]
    split = []
    for column in columns:
        values = np.asarray(column.values, dtype=float)
        added = [value for _, origin in sorted(starts) for value in (np.nan, values[min(origin, len(values) - 1)])]
        split.append(replace(column, values=np.insert(values, at, added)))
    return split


def names_upwards(results, request):
    """Names of columns: those of --y; of --history or all histories; or energies."""
    if request.y:
        return request.y
    if request.x:
        return ["time"]
    if request.what == "ledger":
        return [f"ledger/{name}" for name in ENERGIES]
    wanted = request.history or results.history_names
    names = []
    for name in wanted:
        if "/" in name or name not in results.history_names:
            names.append(name)
        else:
            names += [f"{name}/{series.name}" for series in results.history(name).quantities]
    return names


def short_names(paths):
    """Their stems, or the paths as given if two stems are equal."""
    stems = [Path(path).stem for path in paths]
    return stems if len(set(stems)) == len(stems) else [str(path) for path in paths]


def colour_of(i, count):
    return COLOURS[i] if count <= len(COLOURS) else matplotlib.colormaps["viridis"](0.92 * i / (count - 1))


def draw_runs(runs, request):
    """A panel for each quantity, a curve in it for each file; with --x or --y of one file all in one panel."""
    panels = {}
    for run in runs:
        for column in run.upwards:
            # Curves of the same kind of one file share a panel.
            key = column.dimension if len(runs) == 1 else column.label
            panels.setdefault(key, []).append((run, column))
    if not panels:
        raise UsageError("the files have no histories; --what ledger draws their energies")
    columns = min(COLUMNS, len(panels))
    rows = -(-len(panels) // columns)
    width, height = ALONE if len(panels) == 1 else (columns * PANEL[0], rows * PANEL[1])
    above = [(TITLE_HEIGHT, lambda part: draw_title(part, request.title))] if request.title else []
    if len(runs) > 1:
        colours = {run.name: colour_of(i, len(runs)) for i, run in enumerate(runs)}
        above.append((KEYS_HEIGHT, lambda part: colour_keys(part, colours)))
    heading = sum(part_height for part_height, _ in above)
    figure = new_figure(*(request.size or (width, height + heading)))
    left = max(figure.get_figheight() - heading, 0.3 * figure.get_figheight())
    parts = list(figure.subfigures(len(above) + 1, 1, height_ratios=[*(h for h, _ in above), left], squeeze=False).flat)
    for part, (_, draw) in zip(parts, above):
        draw(part)
    grid = parts[-1].subplots(rows, columns, squeeze=False)
    for axes, curves in zip(grid.flat, panels.values()):
        draw_curves_of(axes, curves, runs)
    for axes in grid.flat[len(panels):]:
        axes.remove()
    return figure


def draw_title(figure, title):
    figure.text(0.012, 0.5, title, fontsize=14, fontweight="bold", va="center", color=BLACK)


def draw_curves_of(axes, curves, runs):
    is_by_run = len(runs) > 1
    drawn = []
    for i, (run, column) in enumerate(curves):
        colour = colour_of(runs.index(run), len(runs)) if is_by_run else colour_of(i, len(curves))
        drawn.append((run.across.values, column.values, colour, column.label))
    across, column = curves[0][0].across, curves[0][1]
    is_alone = is_by_run or len(curves) == 1
    draw_panel(axes, drawn, column.label if is_alone else "", with_unit(across), with_unit(column) if is_alone else column.unit,
               has_legend=not is_by_run and len(curves) > 1)


def with_unit(column):
    return f"{column.label} ({column.unit})" if column.unit not in ("", column.label) else column.label
