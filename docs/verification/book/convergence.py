"""Errors against unknowns or steps, a line for each refinement or scheme, with its slope in the legend."""

import numpy as np
from gxrod.plot import style
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from .cases import refinements_of

COLOURS = (style.BLUE, style.ORANGE, style.GREEN, style.PURPLE, style.BLACK, style.GREY, style.RED,
           style.BROWN)
MARKERS = "os^Dv*Ph"
ROUND_OFF = 1e-12  # errors below it have no order
SCHEME_NAMES = {"S": "(S) newmark-simplified", "I": "(I) newmark-ibrahimbegovic", "RK4": "Runge–Kutta 4",
                "SDIRK4": "sdirk-4", "RADAU5": "radau-5", "GAUSS4": "gauss-4"}


def group(rows, key):
    """{value of a key: rows}, in the order in which they come."""
    groups = {}
    for row in rows:
        groups.setdefault(row[key], []).append(row)
    return groups


def horizontal(rows, is_static):
    """What a refinement varies: steps, or in statics the unknowns if they change."""
    has_more_unknowns = len({row["unknowns"] for row in rows}) > 1
    return "unknowns" if is_static and has_more_unknowns or len({row["steps"] for row in rows}) == 1 else "steps"


def draw_line(axes, index, x, errors, label):
    axes.loglog(x, errors, MARKERS[index % 6] + "-", color=COLOURS[index % 6], ms=4.5, lw=1.2, label=label)


def draw_floor(axes, rows, floors):
    """A dotted line where the reference itself ends, if runs come near it."""
    errors = [row["error"] for row in rows if row["error"] > 0.0]
    floor = max(floors)
    if floor and min(errors) < 10.0 * floor < 10.0 * max(errors):
        axes.axhline(floor, color=style.GREY, ls=":", lw=1.0)
        axes.annotate("no order is asked below", (0.01, floor), xycoords=("axes fraction", "data"), xytext=(0, 2),
                      textcoords="offset points", fontsize=7.5, color=style.GREY)


def label_of(name, rows):
    orders = [row["order"] for row in rows if row["order"] is not None]
    return f"{name}: {orders[-1]:.2f}" if orders and orders[-1] > 0.5 else name


def finish(axes, label, error="error"):
    axes.set(xlabel=label, ylabel=error)
    axes.margins(0.08)
    low, high = axes.get_ylim()
    if high < ROUND_OFF:
        axes.set_ylim(1e-17, 1e-9)
    elif high / low < 100.0:
        axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.0e}".replace("e-0", "e-")))
        axes.yaxis.set_minor_locator(NullLocator())


def place_legend(axes, title):
    legend = axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0, handlelength=2.0, title=title,
                         title_fontsize=8.0)
    legend.get_title().set_ha("left")
    legend._legend_box.align = "left"  # pylint: disable=protected-access


def mark_values(axes, rows, key):
    """The numbers themselves as ticks, where they are not too near to each other: powers of ten are too few."""
    values = sorted({row[key] for row in rows})
    apart, marked = (values[-1] / values[0]) ** 0.07, values[:1]
    for value in values[1:]:
        if value > apart * marked[-1]:
            marked.append(value)
    axes.set_xticks(marked, [f"{value}" for value in marked])
    axes.xaxis.set_minor_locator(NullLocator())


def draw_refinements(name, case):
    is_static = case["kind"] in ("statics", "objectivity", "vibrations", "stability")
    groups, panels = group(case["rows"], "refinement"), {}
    for index, (refinement, rows) in enumerate(groups.items()):
        panels.setdefault(horizontal(rows, is_static), []).append((index, refinement, rows))
    figure = style.new_figure(7.2, 3.1 if len(panels) == 1 else 5.6)
    known = refinements_of(name)
    for axes, (key, lines) in zip(np.atleast_1d(figure.subplots(len(panels), 1)), panels.items()):
        drawn = [row for _, _, rows in lines for row in rows]
        for index, refinement, rows in lines:
            rows = [row for row in rows if row["error"] > 0.0]
            draw_line(axes, index, [row[key] for row in rows], [row["error"] for row in rows],
                      label_of(refinement, rows))
        draw_floor(axes, drawn, [known[refinement].get("floor", 0.0) for _, refinement, _ in lines])
        finish(axes, key)
        mark_values(axes, drawn, key)
        place_legend(axes, "refinement: order of the last pair")
    return figure


def slope(x, y):
    """Of the last pair."""
    return np.log(y[-2] / y[-1]) / np.log(x[-1] / x[-2])


def draw_schemes(axes, rows, key, names=None):
    """A line for each scheme over the steps."""
    for index, (scheme, runs) in enumerate(group(rows, "scheme").items()):
        runs = [row for row in runs if row.get(key)]
        steps, errors = [row["steps"] for row in runs], [row[key] for row in runs]
        draw_line(axes, index, steps, errors, f"{(names or {}).get(scheme, scheme)}: {slope(steps, errors):.2f}")
    mark_values(axes, rows, "steps")


def draw_rubin2007(_, case):
    figure = style.new_figure(10.5, 3.6)
    quantities = {"error_orientation": "$E_Λ$", "error_momentum": "$E_H$", "error_energy": "$E_T$"}
    for axes, (key, label) in zip(figure.subplots(1, 3), quantities.items()):
        draw_schemes(axes, case["rows"], key, SCHEME_NAMES)
        axes.legend(loc="lower left", handlelength=2.0)
        finish(axes, "steps N of the cycle", f"largest {label}")
        axes.set_ylim(bottom=axes.get_ylim()[0] / 50.0)  # room for the legend
    return figure


def draw_rod_schemes(_, case):
    figure = style.new_figure(11.5, 6.6)
    for axes, (motion, rows) in zip(figure.subplots(2, 2).flat, group(case["rows"], "case").items()):
        draw_schemes(axes, rows, "rotation_error")
        place_legend(axes, "order of the last pair")
        axes.set_title(motion)
        finish(axes, "steps", "error of rotation, rad")
    return figure


DRAWN = {"rubin2007": draw_rubin2007, "rod_schemes": draw_rod_schemes}


def save_convergence(path, name, case, metadata):
    figure = DRAWN.get(name, draw_refinements)(name, case)
    figure.savefig(path, metadata=metadata, dpi=110)
    style.plt.close(figure)
