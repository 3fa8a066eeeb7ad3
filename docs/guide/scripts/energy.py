"""Draws where the energy goes, and how well it balances: energy.py RESULTS.vtkhdf -o PICTURE.png"""

import argparse

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results")
    parser.add_argument("-o", "--output", required=True)
    arguments = parser.parse_args()

    with h5py.File(arguments.results) as file:
        label = "load factor" if file.attrs["analysis"] == "static" else "time"
        time = file["ledger/time"][()]
        names = ("kinetic_energy", "strain_energy", "external_work", "dissipated_energy", "numerical_dissipation",
                 "energy_error")
        kinetic, strain, work, dissipated, by_scheme, error = (file["ledger"][name][: len(time)] for name in names)

    figure, (energies, balance) = plt.subplots(
        2, figsize=(9, 6), sharex=True, height_ratios=[3, 1], layout="constrained")
    energies.plot(time, kinetic, label="kinetic energy")
    energies.plot(time, strain, label="strain energy")
    energies.plot(time, kinetic + strain, "k", lw=1, label="kinetic + strain")
    energies.plot(time, work, "k:", label="external work")
    if dissipated.any():
        energies.plot(time, dissipated, label="dissipated energy")
    if by_scheme.any():
        energies.plot(time, by_scheme, label="dissipated by the scheme")
    energies.set_ylabel("energy")
    energies.legend(loc="best", fontsize="small")
    largest = np.max(kinetic + strain)
    balance.plot(time, error / largest, "C3")
    balance.set(xlabel=label, ylabel="error / largest energy")
    for axes in (energies, balance):
        axes.margins(x=0)
        axes.grid(alpha=0.3)
    figure.savefig(arguments.output, dpi=120)
    print(f"largest energy {largest:.6g}, largest error {np.max(abs(error)) / largest:.2g} of it")


if __name__ == "__main__":
    main()
