"""Colours and panels that all pictures share."""

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap

BLUE, ORANGE, GREEN, PURPLE, GREY, BLACK = "#0066b3", "#e0641b", "#12946a", "#a0479c", "#8a8f98", "#22262b"
RED, BROWN = "#c2272d", "#7a5230"
AXIS_COLOURS = {"x": "#d1373f", "y": GREEN, "z": BLUE}
# Dark to bright with time, without the pale end, which is invisible on paper.
TIME_COLOURS = ListedColormap(matplotlib.colormaps["plasma"](np.linspace(0.0, 0.88, 256)), "time")
MOST_POINTS = 20000  # of a drawn curve
TITLE_LETTER, LEGEND_LETTER, LEGEND_HANDLE, PANEL_SIDES = 0.075, 0.062, 0.26, 0.65  # widths, inches

SETTINGS = {
    "font.size": 9.0,
    "axes.titlesize": 9.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.labelsize": 9.0,
    "axes.labelcolor": BLACK,
    "axes.edgecolor": GREY,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.formatter.useoffset": False,
    "axes.formatter.limits": (-3, 4),
    "axes.formatter.use_mathtext": True,
    "grid.color": "#e4e6ea",
    "grid.linewidth": 0.7,
    "xtick.color": "#4a4f57",
    "ytick.color": "#4a4f57",
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
    "legend.fontsize": 8.0,
    "legend.frameon": False,
    "legend.handlelength": 1.0,
    "legend.columnspacing": 0.9,
    "legend.handletextpad": 0.5,
    "lines.linewidth": 1.3,
    "savefig.dpi": 160,
    "svg.hashsalt": "gxrod",
}


def new_figure(width, height):
    plt.rcParams.update(SETTINGS)
    return plt.figure(figsize=(width, height), layout="constrained")


def legend_above(axes, columns):
    """Puts the legend at the right end of the title's line."""
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 0.99), ncol=columns, borderaxespad=0.0, borderpad=0.2)


def draw_curves(axes, times, curves, title, label):
    """Draws named curves {name: (values, colour)} over time, with title, legend and y label."""
    for name, (values, colour) in curves.items():
        axes.plot(*thin(times, values), color=colour, label=name)
    axes.set_title(title)
    axes.set_ylabel(label)
    axes.margins(x=0.01)
    axes.ticklabel_format(axis="x", scilimits=(-3, 6))
    if len(curves) > 1 and fits_above(axes, title, curves):
        legend_above(axes, len(curves))
    elif len(curves) > 1:
        axes.legend(loc="best", ncol=len(curves))


def fits_above(axes, title, names):
    """Whether a title and the legend of these names fit side by side above a panel."""
    columns = axes.get_subplotspec().get_gridspec().ncols
    width = axes.figure.bbox.width / axes.figure.dpi / columns - PANEL_SIDES
    return TITLE_LETTER * len(title) + sum(LEGEND_LETTER * len(name) + LEGEND_HANDLE for name in names) < width


def draw_panel(axes, curves, title, across, label, has_legend):
    """Draws curves (x, y, colour, name); x need not grow, so all points are drawn."""
    for x, y, colour, name in curves:
        count = min(len(x), len(y))
        axes.plot(x[:count], y[:count], color=colour, label=name)
    axes.set_title(title)
    axes.set_xlabel(across)
    axes.set_ylabel(label)
    axes.margins(x=0.02)
    axes.ticklabel_format(scilimits=(-3, 4))
    if has_legend:
        axes.legend(loc="best")


def colour_keys(figure, colours):
    """Fills a figure or subfigure with names and their colours."""
    handles = [plt.Line2D([], [], color=colour, linewidth=2.0, label=name) for name, colour in colours.items()]
    figure.legend(handles=handles, loc="center right", ncol=len(handles), borderaxespad=0.4)


def thin(times, values):
    """Leaves out what cannot be seen: of many points, the least and the greatest of each stretch."""
    stretch = -(-len(values) // (MOST_POINTS // 2))
    if stretch < 2:
        return times, values
    count = len(values) // stretch
    blocks = values[: count * stretch].reshape(count, stretch)
    first = np.arange(count) * stretch
    kept = np.unique(np.concatenate([first + blocks.argmin(axis=1), first + blocks.argmax(axis=1),
                                     [0, len(values) - 1]]))
    return times[kept], values[kept]
