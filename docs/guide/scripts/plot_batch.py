"""Draws columns of a batch: plot_batch.py DIR -o PICTURE.png --x KEY --y NAME … [--by KEY] [--points] [--log x y]"""

import argparse
import csv
import json
import pathlib

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def to_array(texts):
    """Numbers if all texts are numbers or nothing, which is NaN; else the texts."""
    try:
        return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        return np.array(texts)


def read_columns(folder):
    """All columns of index.csv by their names, what batch.json says they hold, and its title."""
    with open(folder / "index.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    columns = {name: to_array([row[name] for row in rows]) for name in (rows[0] if rows else {})}
    record = json.loads((folder / "batch.json").read_text(encoding="utf-8"))
    meanings = {column["name"]: column["description"] for column in record["columns"]}
    return columns, meanings, record["title"]


def draw_lines(axes, x, y, groups, is_log):
    """A line for each group; between two logarithmic axes also its slope at the end, the order of a scheme."""
    for group in dict.fromkeys(groups):
        name = f"{group:g}" if isinstance(group, float) else group
        of_group = groups == group
        order = np.argsort(x[of_group], kind="stable")
        line_x, line_y = x[of_group][order], y[of_group][order]
        axes.plot(line_x, line_y, "o-", ms=4, label=name)
        if is_log and len(line_x) > 1:
            slope = np.diff(np.log(np.abs(line_y[-2:])))[0] / np.diff(np.log(line_x[-2:]))[0]
            print(f"{axes.get_ylabel()}{', ' if name else ''}{name}: slope {slope:.3f}")


def draw_points(figure, axes, x, y, groups, label):
    """A point for each case; where it belongs to a number, coloured by it."""
    coloured = np.issubdtype(groups.dtype, np.number)
    points = axes.scatter(x, y, s=12, c=groups if coloured else None)
    if coloured:
        figure.colorbar(points, ax=axes, label=label)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="of a batch")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--x", required=True, help="a column of numbers")
    parser.add_argument("--y", required=True, nargs="+", help="columns of numbers, a diagram each")
    parser.add_argument("--by", help="a column: a line for each of its values, or with --points a colour")
    parser.add_argument("--points", action="store_true", help="points instead of lines, as for samples")
    parser.add_argument("--log", nargs="+", choices=["x", "y"], default=[], help="axes that are logarithmic")
    arguments = parser.parse_args()

    columns, meanings, title = read_columns(arguments.folder)
    for name in (arguments.x, *arguments.y, *([arguments.by] if arguments.by else [])):
        if name not in columns:
            parser.error(f"no column {name}; there are {', '.join(columns)}")
    done = columns["status"] == "done"
    groups = columns[arguments.by] if arguments.by else np.full(len(done), "")

    figure, rows = plt.subplots(len(arguments.y), squeeze=False, sharex=True, layout="constrained",
                                figsize=(9, 1 + 3 * len(arguments.y)))
    for axes, name in zip(rows[:, 0], arguments.y):
        axes.set_ylabel(name)
        axes.set_title(meanings.get(name, ""), loc="left", fontsize="medium")
        axes.set_xscale("log" if "x" in arguments.log else "linear")
        axes.set_yscale("log" if "y" in arguments.log else "linear")
        x, y = columns[arguments.x], columns[name]
        if arguments.points:
            draw_points(figure, axes, x[done], y[done], groups[done], arguments.by)
        else:
            draw_lines(axes, x[done], y[done], groups[done], len(set(arguments.log)) == 2)
        if not done.all():
            # What such a case collected is of the steps that it did.
            axes.plot(x[~done], y[~done], "rx", label="not done")
        axes.grid(alpha=0.3)
    handles, labels = rows[0, 0].get_legend_handles_labels()
    if any(labels):
        rows[0, 0].legend(handles, labels, title=arguments.by if not arguments.points else None, fontsize="small")
    rows[-1, 0].set_xlabel(arguments.x)
    figure.suptitle(title)
    figure.savefig(arguments.output, dpi=120)
    print(f"{done.sum()} cases drawn, {len(done) - done.sum()} not done")


if __name__ == "__main__":
    main()
