"""Figures 2, 3 and 4 of the rubin2007 study, from the CSV files of `gxrod verify rubin2007 --figures DIR`."""

import csv
import math

import numpy as np
from matplotlib.ticker import FuncFormatter, NullFormatter

from .errors import FileFault
from .style import AXIS_COLOURS, BLACK, BLUE, BROWN, GREEN, GREY, ORANGE, PURPLE, RED, legend_above, new_figure

SCHEMES = {
    "S": ("(S) simplified Newmark", BLUE, "o"),
    "I": ("(I) Ibrahimbegovic", ORANGE, "s"),
    "RK4": ("Runge–Kutta 4", GREEN, "^"),
    "SDIRK4": ("SDIRK 4", PURPLE, "D"),
    "RADAU5": ("Radau 5", RED, "v"),
    "GAUSS4": ("Gauss 4", BROWN, "P"),
}
ERRORS = {
    "error_orientation": "orientation error $E_Λ$",
    "error_momentum": "momentum error $E_H$",
    "error_energy": "energy error $E_T$",
}


def draw_figures(folder, extension, save):
    """Draws folder/fig2, fig3 and fig4; `save` writes a figure to a path. Returns the paths."""
    written = []
    for name, draw in (("fig2", draw_exact_rotation), ("fig3", draw_errors), ("fig4", draw_maxima)):
        figure = draw(folder / f"{name}.csv")
        path = folder / f"{name}.{extension}"
        save(figure, path)
        written.append(path)
    return written


def read_table(path, columns):
    """Columns of a CSV file: arrays of numbers, nan where a cell is empty; text in the column `scheme`."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    except OSError as error:
        raise FileFault(f"{path}: cannot be read: {error.strerror}; "
                        "`gxrod verify rubin2007 --figures DIR` writes it") from error
    missing = [column for column in columns if not rows or column not in rows[0]]
    if missing:
        raise FileFault(f"{path}: has no column {', '.join(missing)}")
    try:
        return {column: np.array([row[column] for row in rows]) if column == "scheme"
                else np.array([float(row[column]) if row[column] else math.nan for row in rows])
                for column in columns}
    except (TypeError, ValueError) as error:
        raise FileFault(f"{path}: contains something that is not a number: {error}") from error


def draw_exact_rotation(path):
    """Fig. 2: rotation angle and components of the rotation vector of the exact solution."""
    table = read_table(path, ("tau", "angle", "phi_1", "phi_2", "phi_3"))
    figure = new_figure(7.2, 4.2)
    axes = figure.add_subplot()
    vectors = np.column_stack([table["phi_1"], table["phi_2"], table["phi_3"]])
    # Where the angle passes π the vector changes its side.
    jumps = np.flatnonzero(np.linalg.norm(np.diff(vectors, axis=0), axis=1) > math.pi) + 1
    tau = np.insert(table["tau"], jumps, math.nan)
    broken = np.insert(vectors, jumps, math.nan, axis=0)
    for index, colour in enumerate(AXIS_COLOURS.values()):
        axes.plot(tau, broken[:, index], color=colour, label=f"$φ_{index + 1}$")
    axes.plot(table["tau"], table["angle"], color=BLACK, linewidth=1.8, label="$Φ$")
    axes.set_ylim(-1.06 * math.pi, 1.06 * math.pi)
    axes.set_yticks(math.pi * np.linspace(-1.0, 1.0, 5), ["−π", "−π/2", "0", "π/2", "π"])
    axes.set_xlim(0.0, 1.0)
    axes.set_xlabel("time $τ = Ωt/2π$")
    axes.set_ylabel("rad")
    axes.set_title("Exact rotation vector")
    legend_above(axes, 4)
    return figure


def draw_errors(path):
    """Fig. 3: errors over the cycle at one number of steps."""
    table = read_table(path, ("scheme", "steps", "tau", *ERRORS))
    figure = new_figure(7.2, 8.4)
    panels = figure.subplots(len(ERRORS), 1, sharex=True)
    for axes, (column, label) in zip(panels, ERRORS.items()):
        for scheme, (name, colour, _) in SCHEMES.items():
            chosen = (table["scheme"] == scheme) & (table[column] > 0.0)
            axes.semilogy(table["tau"][chosen], table[column][chosen], color=colour, label=name)
        axes.set_ylabel(label)
        axes.set_ylim(bottom=lowest_decade(table[column]))
    panels[0].set_title(f"N = {table['steps'][0]:.0f} steps")
    legend_above(panels[0], len(SCHEMES))
    panels[-1].set_xlim(0.0, 1.0)
    panels[-1].set_xlabel("time $τ = Ωt/2π$")
    return figure


def lowest_decade(values):
    """Lower end of a log axis. A cycle starts with errors near rounding, which would squeeze the rest."""
    positive = values[values > 0.0]
    return 10.0 ** math.floor(math.log10(np.quantile(positive, 0.02))) if len(positive) else None


def draw_maxima(path):
    """Fig. 4: greatest step rotation and errors against the number of steps."""
    columns = {"max_theta_deg": r"max $|θ|$ of a step, degrees"}
    columns |= {column: f"max {label}" for column, label in ERRORS.items()}
    table = read_table(path, ("scheme", "steps", *columns))
    figure = new_figure(9.6, 7.4)
    panels = figure.subplots(2, 2, sharex=True)
    for axes, (column, label) in zip(panels.flat, columns.items()):
        for scheme, (name, colour, marker) in SCHEMES.items():
            chosen = (table["scheme"] == scheme) & (table[column] > 0.0)
            axes.loglog(table["steps"][chosen], table[column][chosen], color=colour, marker=marker,
                        markersize=4.5, label=name)
        axes.set_ylabel(label)
    steps = np.unique(table["steps"])
    for axes in panels.flat[1:]:
        draw_slopes(axes, steps)
    for axes in panels[1]:
        show_steps(axes, steps)
        axes.set_xlabel("steps per cycle $N$")
    panels[0, 0].legend(loc="upper right")
    return figure


def show_steps(axes, steps):
    axes.set_xticks(steps)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.0f}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.tick_params(axis="x", which="minor", length=0)


def draw_slopes(axes, steps):
    """Short grey lines that fall with the second and fourth power, at the left lower edge."""
    if len(steps) < 2:
        return
    low, high = axes.get_ylim()
    axes.set_ylim(low, high)
    first = steps[0]
    ends = np.array([first, first * 2.0])
    for power, height in ((2, 0.16), (4, 0.32)):
        start = 10.0 ** (math.log10(low) + height * math.log10(high / low))
        axes.loglog(ends, start * (ends / first) ** -float(power), color=GREY, linewidth=1.0)
        axes.annotate(f"order {power}", (first, start), xytext=(0, 4), textcoords="offset points",
                      fontsize=7.5, color=GREY)
