#!/usr/bin/python3
"""Draws curves of the validation book that other programs have computed, or that were read off, with those of gxrod, and prints how far these are apart."""

import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parent
SOURCE = FOLDER.parents[1]
sys.path.insert(0, str(SOURCE / "apps" / "python"))
from gxrod.plot import style  # noqa: E402 — after the path to it

# Laid with the tension that the chain has at rest: drawn longer, and shortened by as much.
LAID = ("seabed.friction=0.5", "rod.chain.catenary.length=760.6388", 'actuation=[{ on = "chain", stretch = -8.398e-4, factor = 1 }]')


def run(program, name, *changes):
    """{history: tension in kN} of an example, with its times."""
    with tempfile.TemporaryDirectory() as folder:
        results = pathlib.Path(folder, "run.vtkhdf")
        changed = [word for change in changes for word in ("--set", change)]
        subprocess.run([program, "run", SOURCE / "docs" / "examples" / name / f"{name}.toml", "-o", results, "--quiet", *changed], check=True)
        with h5py.File(results) as file:
            histories = file["histories"]
            return {key: histories[key]["effective_tension"][:].ravel() / 1e3 for key in histories if isinstance(histories[key], h5py.Group) and "effective_tension" in histories[key]} | {
                "t": histories["time"][:]}


def read(name):
    return np.genfromtxt(FOLDER / "curves" / f"{name}.csv", delimiter=",", names=True, skip_header=1, deletechars="")


def apart(what, found, times, other):
    """Root of the mean square, and the largest difference."""
    error = np.interp(times, found["t"], found[what]) - other
    return f"{np.sqrt(np.mean(error**2)):.2f}, {np.abs(error).max():.2f}"


def panel(axes, title, curves):
    for label, times, values, look in curves:
        axes.plot(times, values, label=label, **look)
    axes.set(title=title, xlabel="time, s", ylabel="tension, kN")


OURS, THEIRS, DOTS = {"color": style.BLUE, "lw": 1.4}, {"color": style.ORANGE, "lw": 1.4, "ls": "--"}, {"color": style.GREY, "marker": ".", "ms": 2.5, "ls": ""}
LAID_LOOK = {"color": style.GREEN, "lw": 1.2}


def save(name, panels):
    figure = style.new_figure(4.4 * len(panels), 3.6)
    for i, (title, curves) in enumerate(panels, 1):
        axes = figure.add_subplot(1, len(panels), i)
        panel(axes, title, curves)
        if i == len(panels):
            axes.legend(fontsize=7.5, loc="best")
    figure.savefig(FOLDER / "figures" / f"{name}_curves.png")


def part(found, what, start, end):
    inside = (found["t"] >= start) & (found["t"] <= end)
    return found["t"][inside], found[what][inside]


def draw_chain(program):
    data, smooth, laid = read("heaving_chain"), run(program, "heaving_chain"), run(program, "heaving_chain", *LAID)
    panels = []
    for what in ("fairlead", "anchor"):
        theirs, file = data[f"moordyn_{what}"], data[f"file_{what}"]
        print(f"heaving_chain {what}: MoorDyn {apart(what, smooth, data['t'], theirs)}; file {apart(what, smooth, data['t'], file)}; laid, file {apart(what, laid, data['t'], file)}")
        panels.append((what, [("gxrod", *part(smooth, what, 20, 30), OURS), ("MoorDyn, refined", data["t"], theirs, THEIRS),
                              ("gxrod, with friction", *part(laid, what, 20, 30), LAID_LOOK), ("file of MoorDyn's test", data["t"], file, DOTS)]))
    save("heaving_chain", panels)


def draw_jumpers(program, name, cases):
    data, found = read("jumper"), run(program, name)
    panels = []
    for case, what in cases.items():
        times, tension = (data[key][data["case"] == case] for key in ("t", "tension"))
        inside = times <= found["t"][-1]
        print(f"{name} {what}: {apart(what, found, times[inside], tension[inside])}")
        panels.append((what, [("gxrod", *part(found, what, times[0], times[-1]), OURS), ("read off the paper", times, tension, DOTS)]))
    save(name, panels)


def draw_riser(program):
    data, found = read("lazy_wave_riser"), run(program, "lazy_wave_riser")
    panels = []
    for what in ("vessel", "hog", "anchor", "tether"):
        print(f"lazy_wave_riser {what}: 5 m {apart(what, found, data['t'], data[what + '_5m'])}; 2.5 m {apart(what, found, data['t'], data[what + '_2.5m'])}")
        if what in ("vessel", "tether"):
            panels.append((what, [("gxrod", *part(found, what, 14, 24), OURS), ("MoorDyn, 2.5 m", data["t"], data[what + "_2.5m"], THEIRS)]))
    save("lazy_wave_riser", panels)


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else str(SOURCE / "build" / "release" / "gxrod")
    draw_chain(program)
    draw_jumpers(program, "flexible_jumper", {1: "surge", 2: "sway", 3: "heave"})
    draw_jumpers(program, "jumper_in_waves", {4: "along", 5: "oblique", 6: "across"})
    draw_riser(program)


if __name__ == "__main__":
    main()
