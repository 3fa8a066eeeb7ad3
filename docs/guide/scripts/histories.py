"""Draws histories of a results file: histories.py RESULTS.vtkhdf -o PICTURE.png [--history NAME/QUANTITY …]"""

import argparse

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def list_histories(file):
    """NAME/QUANTITY of all histories."""
    groups = file["histories"]
    return [f"{name}/{quantity}" for name in groups if name != "time" for quantity in groups[name]]


def draw_history(axes, file, history):
    time = file["histories/time"][()]
    dataset = file["histories"][history]
    values = dataset[: len(time)]
    letters = "wxyz" if values.shape[1] == 4 else "xyz"
    for column, letter in zip(values.T, letters):
        axes.plot(time, column, lw=1, label=letter)
    axes.set_title(f"{history.replace('/', ': ')} ({dataset.attrs['frame']})", loc="left", fontsize="medium")
    axes.set_ylabel(dataset.attrs["dimension"])
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=4, frameon=False)
    axes.margins(x=0)
    axes.grid(alpha=0.3)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--history", nargs="+", help="NAME/QUANTITY (all)")
    arguments = parser.parse_args()

    with h5py.File(arguments.results) as file:
        histories = arguments.history or list_histories(file)
        figure, rows = plt.subplots(
            len(histories), figsize=(9, 2.4 * len(histories)), sharex=True, squeeze=False, layout="constrained")
        for axes, history in zip(rows[:, 0], histories):
            draw_history(axes, file, history)
        rows[-1, 0].set_xlabel("load factor" if file.attrs["analysis"] == "static" else "time")
    figure.savefig(arguments.output, dpi=120)
    print("drawn:", *histories)


if __name__ == "__main__":
    main()
