"""Draws the rods of a results file at times evenly spaced: deflected_shapes.py RESULTS.vtkhdf -o PICTURE.png"""

import argparse

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def read_shapes(path):
    """Times [F], positions [F, N, 3], and the nodes of each element from its start to its end."""
    with h5py.File(path) as file:
        grid = file["VTKHDF"]
        times = grid["Steps/Values"][()]
        nodes = grid["NumberOfPoints"][0]
        shapes = grid["Points"][: len(times) * nodes].reshape(len(times), nodes, 3)
        cells = np.split(grid["Connectivity"][()], grid["Offsets"][1:-1])
        label = "load factor" if file.attrs["analysis"] == "static" else "time"
    # The two ends of an element come first; a cell of one node is a body.
    elements = [[cell[0], *cell[2:], cell[1]] for cell in cells if len(cell) > 1]
    return times, shapes, elements, label


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--shapes", type=int, default=10, help="how many")
    parser.add_argument("--plane", default="xy", choices=["xy", "xz", "yz"])
    arguments = parser.parse_args()

    times, shapes, elements, label = read_shapes(arguments.results)
    across, up = ("xyz".index(letter) for letter in arguments.plane)
    colours = matplotlib.colormaps["viridis"]
    scale = plt.Normalize(times[0], times[-1])

    figure, axes = plt.subplots(figsize=(9, 5))
    chosen = np.unique(np.linspace(0, len(times) - 1, arguments.shapes).round().astype(int))
    for frame in chosen:
        for element in elements:
            line = shapes[frame, element]
            axes.plot(line[:, across], line[:, up], color=colours(scale(times[frame])), lw=2, solid_capstyle="round")
    axes.set(xlabel=arguments.plane[0], ylabel=arguments.plane[1], aspect="equal")
    axes.grid(alpha=0.3)
    figure.colorbar(plt.cm.ScalarMappable(scale, colours), ax=axes, label=label, fraction=0.04)
    figure.savefig(arguments.output, dpi=120, bbox_inches="tight")
    print(len(chosen), "shapes, at", label, ", ".join(f"{time:.4g}" for time in times[chosen]))


if __name__ == "__main__":
    main()
