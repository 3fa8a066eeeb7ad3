#!/usr/bin/python3
"""Draws times.png and errors.png from times.json and errors.json, which measure.py writes, and peers.json.

Renews, with threads.json, the tables of ../performance.md, too; numbers in its sentences are to be read again.
"""

import json
import pathlib
import re
import sys

import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parents[1] / "apps" / "python"))
from gxrod.plot import style  # noqa: E402 — after the path to it

STEPS = 1000  # of the whole motion
SPAN = 10  # elements between two crossings of a net
COLOURS = {1: style.BLUE, 2: style.GREEN, 3: style.ORANGE, 4: style.PURPLE}
PEER_MARKERS = {"Exudyn 1.13.6": "s", "Exudyn 1.13.6, modified Newton": "D", "OpenSees 3.7.1": "^",
                "PyElastica 1.0": "v", "MuJoCo 3.17": "P", "SHARPy (xbeam)": "X"}
PENDULUM = re.compile(r"run_pendulum/objective/order:(\d)/elements:(\d+)/")
BLOCKS = re.compile(r"solve_eigen_blocks/(\d+)$")


def read(name):
    """A file of data next to this script."""
    return json.loads((FOLDER / name).read_text())


def times_by_order(benchmarks):
    """{order: (elements, seconds of the whole motion)} of gxrod's runs, which are shorter where n is large."""
    found = {}
    for row in benchmarks:
        if match := PENDULUM.match(row["name"]):
            order, elements = map(int, match.groups())
            seconds = 1e-6 * row["us_per_el_it"] * elements * row["it_per_step"] * STEPS
            found.setdefault(order, []).append((elements, seconds))
    return {order: np.array(sorted(rows)).T for order, rows in sorted(found.items())}


def slope(elements, seconds):
    """The exponent of growth with n, from 100 elements on."""
    large = elements >= 100
    return np.polyfit(np.log(elements[large]), np.log(seconds[large]), 1)[0]


def rows_by_code(peers, quantity):
    """{code: rows} of those that have a quantity."""
    codes = {}
    for row in peers["rows"]:
        if quantity in row and "seconds" in row:
            codes.setdefault(row["code"], []).append(row)
    return codes


def scale_to_motion(row):
    """Seconds of the whole motion, of a row that may have made fewer steps of 1 ms."""
    return row["seconds"] * max(1.0, STEPS / row["steps"])


def draw_peers(axes, peers, quantity, point):
    """A mark for each of the peers' rows, joined by code."""
    for code, rows in rows_by_code(peers, quantity).items():
        x, y = np.array([point(row) for row in rows]).T
        axes.plot(x, y, PEER_MARKERS[code] + "--", color=style.GREY, mfc="none", mec=style.BLACK, mew=0.9, lw=0.8, ms=6,
                  label=code)


def finish(figure, axes, name):
    """Puts the legend next to the axes and writes the picture."""
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0, handlelength=2.0)
    figure.savefig(FOLDER / name)


def draw_times(times, peers):
    figure = style.new_figure(8.0, 4.6)
    axes = figure.subplots()
    for order, (elements, seconds) in times_by_order(times["benchmarks"]).items():
        axes.loglog(elements, seconds, "o-", color=COLOURS[order], ms=4,
                    label=f"gxrod, order {order}: $n^{{{slope(elements, seconds):.2f}}}$")
    blocks = {int(match[1]): row["per_node"] for row in times["benchmarks"] if (match := BLOCKS.match(row["name"]))}
    nodes = np.array(sorted(blocks))
    axes.loglog(nodes, 2 * STEPS * nodes * [blocks[n] for n in nodes], ":", color=style.BLACK,
                label="6 × 6 blocks alone, twice a step")
    draw_peers(axes, peers, "seconds", lambda row: (row["elements"], scale_to_motion(row)))
    axes.set(xlabel="elements n", ylabel="seconds for one second of motion",
             title="A pendulum of n elements, Δt = 1 ms")
    finish(figure, axes, "times.png")


def distance(tip, other):
    """Between two positions of the tip."""
    return float(np.hypot(*(np.array(tip) - other)))


def draw_errors(errors, peers):
    figure = style.new_figure(8.0, 4.6)
    axes = figure.subplots()
    reference, exact = errors["reference"]["tip"], np.array(peers["exact_tip"])
    for order in COLOURS:
        rows = [row for row in errors["rows"] if row["order"] == order]
        error = [distance(row["tip"], reference) for row in rows]
        seconds = [row["seconds"] for row in rows]
        axes.loglog(seconds, error, "o-", color=COLOURS[order], ms=4, label=f"gxrod, order {order}")
        for index, offset, side in ((0, (-5, -8), "right"), (-1, (0, -12), "center")):
            axes.annotate(f"{rows[index]['elements']}", (seconds[index], error[index]), xytext=offset, ha=side,
                          textcoords="offset points", fontsize=7.5, color=COLOURS[order])
    draw_peers(axes, peers, "tip", lambda row: (row["seconds"], distance(row["tip"], exact)))
    axes.axhline(distance(reference, exact), color=style.BLACK, ls=":", lw=1.0, label="error of the step, Δt = 1 ms")
    axes.margins(0.08)
    axes.set(xlabel="seconds", ylabel="error of the tip at t = 1 s (m)",
             title="Error and time; the numbers are elements")
    finish(figure, axes, "errors.png")


def cells_of_run(row):
    """What the tables tell of a run."""
    columns = ("assembly", "solve", "update", "us_per_el_it", "times_blocks")
    memory = f"{1e-3 * row['bytes_per_node']:.1f} kB" if "bytes_per_node" in row else ""
    return [*(f"{row[column]:.3g}" for column in columns), memory]


def rows_of_pendulum(benchmarks):
    found = [(*map(int, match.groups()), row) for row in benchmarks if (match := PENDULUM.match(row["name"]))]
    return [[str(order), f"{elements:,}", f"{row['it_per_step']:.2f}", *cells_of_run(row)]
            for order, elements, row in sorted(found, key=lambda each: each[:2])]


def rows_of_nets(benchmarks):
    rows = []
    for row in benchmarks:
        if match := re.match(r"run_net/rods:(\d+)/", row["name"]):
            rods = int(match[1])
            rows.append([f"{rods} × {rods}", f"{2 * rods * (rods - 1) * SPAN:,}", *cells_of_run(row)])
    return rows


def rows_of_solvers(benchmarks):
    """Of the rod of 1000 nodes."""
    names = {row["name"]: row for row in benchmarks if row["name"].endswith("/1000") and "per_node" in row}
    return [[re.sub(r"solve_(rod/)?(.*)/1000", r"\2", name).replace("_", " "), f"{1e6 * row['per_node']:.2f}"]
            for name, row in names.items()]


def rows_of_threads(measured):
    """One thread, two, and how many times faster two are."""
    phases = ("assembly", "solve", "update")
    found = {(row["elements"], row["threads"]): [*(row[phase] for phase in phases), sum(row[phase] for phase in phases)]
             for row in measured}
    rows = []
    for elements in sorted({elements for elements, _ in found}):
        one, two = found[elements, 1], found[elements, 2]
        rows.append([f"{elements:,}", f"{one[-1]:.3g}", f"{two[-1]:.3g}", *(f"{a / b:.2f}" for a, b in zip(one, two))])
    return rows


def renew_table(page, header, rows):
    """The page with these rows below the table's header and the line beneath it."""
    lines = page.splitlines(keepends=True)
    first = next(number for number, line in enumerate(lines) if line.startswith(header)) + 2
    last = next(number for number in range(first, len(lines)) if not lines[number].startswith("|"))
    lines[first:last] = [f"| {' | '.join(row)} |\n".replace("|  |", "| |") for row in rows]
    return "".join(lines)


def renew_tables(benchmarks, threads):
    path = FOLDER.parent / "performance.md"
    page = path.read_text()
    for header, rows in (("| order | elements |", rows_of_pendulum), ("| rods | elements |", rows_of_nets),
                         ("| solver |", rows_of_solvers)):
        page = renew_table(page, header, rows(benchmarks))
    page = renew_table(page, "| elements | one thread |", rows_of_threads(threads))
    path.write_text(page)


def main():
    peers, times = read("peers.json"), read("times.json")
    renew_tables(times["benchmarks"], read("threads.json"))
    draw_times(times, peers)
    draw_errors(read("errors.json"), peers)


if __name__ == "__main__":
    main()
