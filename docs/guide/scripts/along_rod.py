"""Draws a quantity along a rod, the range over all frames and one frame: along_rod.py RESULTS.vtkhdf ROD moment z -o PICTURE.png"""

import argparse

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def read_along(path, rod, quantity):
    """Times [F], arc lengths [e] of the middles of a rod's elements, and a quantity there [F, e, 3]."""
    with h5py.File(path) as file:
        grid, rods = file["VTKHDF"], file["rods"]
        names = list(rods["name"].asstr()[()])
        if rod not in names:
            raise SystemExit(f"no rod {rod}; there are {', '.join(names)}")
        of_rod = grid["CellData/rod"][()] == names.index(rod)
        times = grid["Steps/Values"][()]
        cells = grid["NumberOfCells"][0]
        values = grid["CellData"][quantity][: len(times) * cells].reshape(len(times), cells, 3)
        label = "load factor" if file.attrs["analysis"] == "static" else "time"
        return times, grid["CellData/arc_length"][()][of_rod], values[:, of_rod], label


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results")
    parser.add_argument("rod")
    parser.add_argument("quantity", choices=["force", "moment", "strain", "curvature"])
    parser.add_argument("component", choices=["x", "y", "z"])
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--time", type=float, help="the nearest frame is drawn; the last one if it is left out")
    arguments = parser.parse_args()

    times, arc_length, values, label = read_along(arguments.results, arguments.rod, arguments.quantity)
    values = values[..., "xyz".index(arguments.component)]
    frame = len(times) - 1 if arguments.time is None else np.abs(times - arguments.time).argmin()

    figure, axes = plt.subplots(figsize=(9, 4))
    axes.fill_between(arc_length, values.min(axis=0), values.max(axis=0), alpha=0.25, label="range over all frames")
    axes.plot(arc_length, values[frame], "o-", ms=3, label=f"{label} {times[frame]:.4g}")
    axes.set(xlabel=f"arc length along {arguments.rod}", ylabel=f"{arguments.quantity} {arguments.component}")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(arguments.output, dpi=120, bbox_inches="tight")
    place = np.abs(values).max(axis=0).argmax()
    moment = np.abs(values[:, place]).argmax()
    print(f"largest {values[moment, place]:.6g}, at arc length {arc_length[place]:.6g} and {label} {times[moment]:.6g}")


if __name__ == "__main__":
    main()
