"""Draws the frequency spectrum of a history: spectrum.py RESULTS.vtkhdf tip/displacement z -o PICTURE.png"""

import argparse

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def resample(time, values):
    """Onto equal steps, the shortest of those taken: the transform needs them, and adaptive steps are not equal."""
    steps = np.diff(time)
    if np.ptp(steps) < 1e-9 * steps.max():
        return steps.mean(), values
    equal = np.linspace(time[0], time[-1], int(np.ceil((time[-1] - time[0]) / steps.min())) + 1)
    return equal[1] - equal[0], np.interp(equal, time, values)


def compute_spectrum(step, values):
    """Frequencies (cycles per unit of time) and amplitudes: a sine of amplitude a is a peak of height a."""
    window = np.hanning(len(values))
    padded = 8 * len(values)  # lines between those that the length gives: a smooth curve
    amplitudes = 2 * np.abs(np.fft.rfft(window * (values - values.mean()), padded)) / window.sum()
    return np.fft.rfftfreq(padded, step), amplitudes


def find_peak(frequencies, amplitudes):
    """The dominant frequency: vertex of the parabola through the logarithms at the largest line and its neighbours."""
    largest = np.clip(np.argmax(amplitudes), 1, len(amplitudes) - 2)
    left, middle, right = np.log(amplitudes[largest - 1 : largest + 2])
    return frequencies[largest] + 0.5 * (left - right) / (left - 2 * middle + right) * frequencies[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results")
    parser.add_argument("history", help="NAME/QUANTITY")
    parser.add_argument("component", choices=["w", "x", "y", "z"])
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--after", type=float, default=0.0, help="leave out what was before this time")
    parser.add_argument("--highest", type=float, help="highest frequency to draw")
    arguments = parser.parse_args()

    with h5py.File(arguments.results) as file:
        if file.attrs["analysis"] == "static":
            parser.error("a static analysis has no frequencies")
        histories = file["sampled" if "sampled" in file else "histories"]  # at equal times, if the deck asks for them
        time = histories["time"][()]
        dataset = histories[arguments.history]
        values = dataset[: len(time)][:, "wxyz"[-dataset.shape[1] :].index(arguments.component)]
        dimension = dataset.attrs["dimension"]
    wanted = (time >= arguments.after) & np.isfinite(values)  # NaN: not recorded
    step, values = resample(time[wanted], values[wanted])
    frequencies, amplitudes = compute_spectrum(step, values)
    peak = find_peak(frequencies, amplitudes)

    figure, axes = plt.subplots(figsize=(9, 4), layout="constrained")
    axes.semilogy(frequencies[1:], amplitudes[1:], lw=1)
    axes.axvline(peak, color="C3", lw=1, ls="--", label=f"{peak:.4g}")
    axes.set(xlabel="frequency (cycles per unit of time)", ylabel=f"amplitude ({dimension})",
             title=f"{arguments.history.replace('/', ': ')}, {arguments.component}",
             xlim=(0, arguments.highest or frequencies[-1]), ylim=(amplitudes.max() * 1e-5, amplitudes.max() * 3))
    axes.legend(title="dominant frequency")
    axes.grid(alpha=0.3)
    figure.savefig(arguments.output, dpi=120)
    print(f"dominant frequency {peak:.6g}, angular {2 * np.pi * peak:.6g}; resolution {1 / (step * len(values)):.3g}")


if __name__ == "__main__":
    main()
