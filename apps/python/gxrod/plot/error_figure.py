"""Errors over a mesh or a step between logarithmic axes, with the orders at the lines; the same as tables."""

import numpy as np
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from .compare import colour_of
from .style import BLACK, GREY, new_figure

COLUMNS = 2
PANEL = (5.6, 4.2)  # inches
MOST_TICKS = 12
MARKERS = "osD^vP"


def draw_errors(panels, request):
    columns = min(COLUMNS, len(panels))
    rows = -(-len(panels) // columns)
    figure = new_figure(*(request.size or (columns * PANEL[0], rows * PANEL[1])))
    grid = figure.subplots(rows, columns, squeeze=False)
    for axes, panel in zip(grid.flat, panels):
        draw_panel_of_errors(axes, panel)
    for axes in grid.flat[len(panels):]:
        axes.remove()
    if request.title:
        figure.suptitle(request.title, fontsize=14, fontweight="bold", x=0.012, ha="left", color=BLACK)
    return figure


def draw_panel_of_errors(axes, panel):
    axes.set_xscale("log")
    axes.set_yscale("log")
    for i, line in enumerate(panel.lines):
        seen = line.errors > 0
        colour = colour_of(i, len(panel.lines))
        axes.plot(line.x[seen], line.errors[seen], color=colour, marker=MARKERS[i % len(MARKERS)], markersize=4, label=line.name)
        if (last := line.last_order) is not None:
            middle = np.exp(0.5 * np.log(line.x[last - 1] * line.x[last])), np.sqrt(line.errors[last - 1] * line.errors[last])
            axes.annotate(f"{line.orders[last]:.2f}", middle, xytext=(5, 4), textcoords="offset points", color=colour, fontsize=8)
    label_values(axes, sorted({x for line in panel.lines for x in line.x}))
    axes.set_title(panel.title)
    axes.set_xlabel(panel.across)
    axes.set_ylabel(panel.upwards)
    axes.margins(x=0.08, y=0.12)
    draw_triangles(axes, panel)
    axes.text(0.0, -0.19, f"against {panel.reference}; at the lines: their orders", transform=axes.transAxes, fontsize=8, color=GREY)
    if len(panel.lines) > 1 or panel.lines[0].name:
        axes.legend(loc="best")


def label_values(axes, values):
    """Ticks at the numbers of the runs themselves, if they are few."""
    if len(values) > MOST_TICKS:
        return
    axes.xaxis.set_major_locator(FixedLocator(values))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.12g}"))


def draw_triangles(axes, panel):
    """A triangle of the whole order nearest to a line's, below its finest pair; one for each order."""
    drawn = set()
    for line in panel.lines:
        last = line.last_order
        if last is None or is_crowded(panel, line, last) or (order := max(round(line.orders[last]), 1)) in drawn or len(drawn) == 3:
            continue
        drawn.add(order)
        (x0, x1), y1 = line.x[last - 1 : last + 1], line.errors[last]
        low, high = y1 / 2.5, y1 / 2.5 * abs_ratio(x0, x1) ** order
        # The level leg is at the finer end, so that the slope goes as the errors do.
        axes.plot([x0, x1, x0, x0], [high, low, low, high], color=GREY, linewidth=0.9)
        axes.text(x0, np.sqrt(low * high), f" {order} ", ha="right" if x0 < x1 else "left", va="center", fontsize=8, color=GREY)
        axes.text(np.sqrt(x0 * x1), low, "1", ha="center", va="top", fontsize=8, color=GREY)


def is_crowded(panel, line, last):
    """Whether another line passes just below the finest pair of this one."""
    for other in panel.lines:
        for i in (last - 1, last):
            below = other.errors[other.x == line.x[i]]
            if other is not line and len(below) and line.errors[last] / 30.0 < below[0] < line.errors[i]:
                return True
    return False


def abs_ratio(a, b):
    return max(a / b, b / a)


def describe_errors(panels):
    """A table for each panel, for a terminal."""
    texts = []
    for panel in panels:
        texts.append(f"{panel.upwards}, against {panel.reference}")
        for line in panel.lines:
            rows = [(panel.across, "value", "error", "order")]
            rows += [(f"{x:.12g}", f"{value:.10g}", f"{error:.3e}", say_order(order))
                     for x, value, error, order in zip(line.x, line.values, line.errors, line.orders)]
            widths = [max(len(row[i]) for row in rows) for i in range(4)]
            texts += [line.name] if line.name else []
            texts += ["  " + "  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in rows]
    return "\n".join(texts)


def say_order(order):
    return f"{order:.2f}" if np.isfinite(order) else "-"


LATEX = {"\\": r"\textbackslash{}", "_": r"\_", "%": r"\%", "&": r"\&", "#": r"\#", "$": r"\$", "{": r"\{", "}": r"\}", "~": r"\textasciitilde{}",
         "^": r"\textasciicircum{}", "−": "$-$", "λ": r"$\lambda$", "²": "$^2$", "·": r"$\cdot$", "<": "$<$", ">": "$>$"}


def escape_latex(text):
    return "".join(LATEX.get(letter, letter) for letter in text)


def write_latex(panels):
    """A table of LaTeX for each panel, with the lines of booktabs: errors and orders of all lines over the key."""
    tables = ["% \\usepackage{booktabs}"]
    for panel in panels:
        values = sorted({x for line in panel.lines for x in line.x}, reverse=panel.lines[0].x[0] > panel.lines[0].x[-1])
        tables += [f"% {panel.title}; {panel.upwards}, against {panel.reference}",
                   f"\\begin{{tabular}}{{r{'rr' * len(panel.lines)}}}", "\\toprule"]
        if any(line.name for line in panel.lines):
            tables.append(" & ".join(["", *(f"\\multicolumn{{2}}{{c}}{{{escape_latex(line.name)}}}" for line in panel.lines)]) + r" \\")
        tables += [" & ".join([escape_latex(panel.across), *(["error", "order"] * len(panel.lines))]) + r" \\", "\\midrule"]
        tables += [" & ".join([f"${in_latex(f'{x:.12g}')}$", *(cell for line in panel.lines for cell in cells_at(line, x))]) + r" \\" for x in values]
        tables += ["\\bottomrule", "\\end{tabular}", ""]
    return "\n".join(tables)


def cells_at(line, x):
    found = np.flatnonzero(line.x == x)
    if not len(found):
        return "", ""
    order = line.orders[found[0]]
    return f"${in_latex(f'{line.errors[found[0]]:.2e}')}$", f"${order:.2f}$" if np.isfinite(order) else "--"


def in_latex(number):
    """A number as text, 1e-05, with its power of ten as LaTeX sets it."""
    mantissa, _, power = number.partition("e")
    if not power:
        return number
    return f"10^{{{int(power)}}}" if mantissa == "1" else f"{mantissa}\\cdot10^{{{int(power)}}}"
