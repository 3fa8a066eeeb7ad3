#!/usr/bin/python3
"""Runs three motions for a million steps with every integrator, or those of `--only`, and reports how far energy, momentum and rotations drift.

Saves its numbers in tests/data/long_runs.json, draws figures/long_runs.png, and renews the table of long_runs.md. `--pages` renews
picture and table without a run, `--check` reports whether they are those of long_runs.json. A whole run takes about ten
minutes and 2 GB of disk in a temporary folder.
"""

import argparse
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parent
SOURCE = FOLDER.parents[1]
RECORD = SOURCE / "tests" / "data" / "long_runs.json"
PAGE, PICTURE = FOLDER / "long_runs.md", FOLDER / "figures" / "long_runs.png"
sys.path.insert(0, str(SOURCE / "apps" / "python"))
from book.figures import KEYWORD, is_current  # noqa: E402 — after the path to it
from gxrod.plot import style  # noqa: E402

STEPS = 1_000_000
SHORT = 100_000  # steps of a run whose memory is compared with that of the long one
SAMPLES = 400  # of each curve: the largest value of a part of the run
BLOCK = 50_000  # rows read at once
SCHEMES = ("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "radau-5", "gauss-4", "runge-kutta-4")
# Example, time step, keys that are changed.
CASES = {
    "heavy_top": (2e-4, []),
    "dzhanibekov": (1e-3, ["analysis.newton={tolerance = 1e-12}"]),
    "tumbling_rod": (5e-3, ["rod.rod.order=1"]),
}
# The mesh's highest frequency is 174, so an explicit step would have to be half of this one.
EXPLICIT_IS_UNSTABLE = {"tumbling_rod"}


def deck_without_newton(text):
    """runge-kutta-4 takes no [analysis] newton."""
    return re.sub(r"^newton *=.*\n", "", text, flags=re.M)


def largest_in_parts(values):
    """The largest of each of SAMPLES parts of a run."""
    parts = np.array_split(np.asarray(values), SAMPLES)
    return np.array([np.max(part) for part in parts if len(part)])


def read_drift(file):
    """Relative errors of energy and angular momentum, and |ΛᵀΛ − I|, of each step and of the frames."""
    ledger = file["ledger"]
    kinetic, strain, work = (ledger[name][:] for name in ("kinetic_energy", "strain_energy", "external_work"))
    energy = kinetic + strain - work
    scale = np.max(np.abs(kinetic + strain))
    momentum = ledger["angular_momentum"][:]
    conserved = momentum[:, 2:] if np.any(work != 0.0) else momentum  # under gravity about z alone
    size = np.max(np.linalg.norm(conserved, axis=1))
    orthogonality = 0.0
    for name, history in file["histories"].items():
        if name != "time" and "orientation" in history:
            q = history["orientation"]
            for first in range(0, len(q), BLOCK):
                norm = np.sum(np.square(q[first:first + BLOCK]), axis=1)
                # Λ(q) of a quaternion q is |q|² times a rotation, so |ΛᵀΛ − I| = √3 ||q|⁴ − 1|.
                orthogonality = max(orthogonality, float(np.sqrt(3.0) * np.max(np.abs(norm ** 2 - 1.0))))
    return {"energy": np.abs(energy - energy[0]) / scale,
            "signed_energy": float((energy[-1] - energy[0]) / scale),
            "momentum": np.linalg.norm(conserved - conserved[0], axis=1) / size,
            "orthogonality": orthogonality}


def watch(arguments, said):
    """Runs a program; returns the largest memory it had, in MB, and its seconds of processor time. What the kernel tells of
    a child's largest memory counts this Python, as long as it was the child."""
    process = subprocess.Popen(arguments, stdout=said)
    largest = 0.0
    while True:
        ended, _, used = os.wait4(process.pid, os.WNOHANG)
        if ended:
            return largest, used.ru_utime
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
        if "gxrod" in status.splitlines()[0] and (told := re.search(r"VmHWM:\s*(\d+) kB", status)):
            largest = int(told[1]) / 1e3
        time.sleep(0.01)


def arguments_of(example, scheme, folder):
    """The deck, written into a folder, and the changes to it."""
    step, changes = CASES[example]
    text = (SOURCE / "docs" / "examples" / example / f"{example}.toml").read_text()
    text = deck_without_newton(text)
    if "orientation" not in text:
        text = text.replace('quantities = ["position", "velocity"]', 'quantities = ["position", "orientation"]')
    deck = folder / f"{example}.toml"
    deck.write_text(text)
    options = [f"analysis.integrator={scheme}", f"analysis.end_time={STEPS * step!r}", f"analysis.time_step={step!r}",
               "output.every=10000", *(changes if scheme != "runge-kutta-4" else [])]
    return [str(deck), *(part for option in options for part in ("--set", option))]


def predict(program, arguments):
    """Megabytes of the file and of memory, as gxrod check tells."""
    told = subprocess.run([program, "check", *arguments], stdout=subprocess.PIPE, text=True, check=True).stdout
    return (float(re.search(r"^results: at least ([\d.e+]+) MB", told, re.M)[1]),
            float(re.search(r"^memory: about (\d+) MB", told, re.M)[1]))


def run(program, example, scheme, folder):
    step = CASES[example][0]
    arguments = arguments_of(example, scheme, folder)
    predicted, predicted_memory = predict(program, arguments)
    results = folder / "run.vtkhdf"
    command = [program, "run", *arguments, "-o", str(results), "--force", "--quiet"]
    early, _ = watch([*command, "--set", f"analysis.end_time={SHORT * step!r}"], subprocess.DEVNULL)
    started = time.monotonic()
    with open(folder / "summary.json", "w") as said:
        memory, processor_seconds = watch([*command, "--summary", "-"], said)
    seconds = time.monotonic() - started
    summary = json.loads((folder / "summary.json").read_text())
    with h5py.File(results) as file:
        drift = read_drift(file)
    row = {"case": example, "scheme": scheme, "time_step": step, "status": summary["status"], "steps": summary["steps"],
           "newton_iterations": summary["newton_iterations"], "seconds": round(seconds, 1),
           "processor_seconds": round(processor_seconds, 1),
           "megabytes": round(results.stat().st_size / 1e6, 1), "predicted_megabytes": predicted,
           "memory": round(memory, 1), "predicted_memory": predicted_memory, "early_memory": round(early, 1),
           "energy": float(drift["energy"].max()), "energy_at_end": drift["signed_energy"],
           "momentum": float(drift["momentum"].max()), "orthogonality": drift["orthogonality"],
           "energy_curve": [float(f"{value:.3g}") for value in largest_in_parts(drift["energy"])],
           "momentum_curve": [float(f"{value:.3g}") for value in largest_in_parts(drift["momentum"])]}
    if summary["status"] != "complete":
        row["reason"] = summary["reason"]
    results.unlink()
    print(f"{example}, {scheme}: {row['status']}, {row['steps']} steps, {row['seconds']} s, energy {row['energy']:.1e}, "
          f"momentum {row['momentum']:.1e}, orthogonality {row['orthogonality']:.1e}", flush=True)
    return row


def make_table(rows):
    lines = ["| motion | scheme | steps | energy, largest | at the end | momentum, largest | \\|ΛᵀΛ − I\\| | file, MB (predicted) | memory, MB (predicted; of 10⁵ steps) |",
             "|---|---|---|---|---|---|---|---|---|"]
    for row in rows:
        steps = f"{row['steps']:,}".replace(",", "\u202f")
        measured = f"{row['memory']:.1f} ({row['predicted_memory']:.0f}; {row['early_memory']:.1f})"
        memory = measured if row["memory"] > 0.0 else f"not measured ({row['predicted_memory']:.0f})"
        lines.append(f"| {row['case']} | {row['scheme']} | {steps} | {row['energy']:.1e} | {row['energy_at_end']:+.1e} | "
                     f"{row['momentum']:.1e} | {row['orthogonality']:.0e} | {row['megabytes']:.0f} ({row['predicted_megabytes']:.0f}) | "
                     f"{memory} |")
    return "\n".join(lines)


def renew_text(text, rows):
    return re.sub(r"(<!-- table -->\n).*?(\n<!-- end -->)", lambda match: match[1] + make_table(rows) + match[2], text, flags=re.S)


def digest_of(rows):
    return hashlib.sha256(json.dumps(rows, sort_keys=True).encode()).hexdigest()


def find_faults(rows):
    """What of page and picture is not of these rows."""
    text = PAGE.read_text(encoding="utf-8")
    return ([f"{PAGE.name} has a table that is not that of {RECORD.name}"] if renew_text(text, rows) != text else []) + (
        [f"{PICTURE.name} is missing or not drawn from {RECORD.name}"] if not is_current(PICTURE, digest_of(rows)) else [])


def draw(rows):
    figure = style.new_figure(9.6, 7.6)
    axes = figure.subplots(len(CASES), 2, squeeze=False)
    colours = dict(zip(SCHEMES, (style.BLUE, style.GREEN, style.ORANGE, style.PURPLE, style.RED, style.BROWN, style.BLACK)))
    for pair, case in zip(axes, CASES):
        for row in (row for row in rows if row["case"] == case):
            for panel, quantity in zip(pair, ("energy", "momentum")):
                curve = np.array(row[f"{quantity}_curve"])
                at = np.linspace(0.0, row["steps"], len(curve))
                panel.semilogy(at[curve > 0], curve[curve > 0], color=colours[row["scheme"]], label=row["scheme"])
        for panel, quantity in zip(pair, ("energy", "angular momentum")):
            panel.set(title=f"{case}: {quantity}", xlabel="steps", xlim=(0, STEPS))
    axes[0][1].legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0)
    figure.savefig(PICTURE, metadata={KEYWORD: digest_of(rows)})


def run_all(program, schemes, rows):
    """The rows of all schemes: of these ones new, of others as they are."""
    old = {(row["case"], row["scheme"]): row for row in rows}
    with tempfile.TemporaryDirectory() as folder:
        return [run(program, example, scheme, pathlib.Path(folder)) if scheme in schemes else old[example, scheme]
                for example in CASES for scheme in SCHEMES if not (scheme == "runge-kutta-4" and example in EXPLICIT_IS_UNSTABLE)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", nargs="?", default=str(SOURCE / "build" / "release" / "gxrod"), help="gxrod [build/release/gxrod]")
    parser.add_argument("--pages", action="store_true", help="renew picture and table from long_runs.json, without a run")
    parser.add_argument("--check", action="store_true", help="tell whether picture and table are those of long_runs.json")
    parser.add_argument("--only", nargs="+", choices=SCHEMES, default=SCHEMES, help="run these schemes, keep the others' rows [all]")
    arguments = parser.parse_args()
    if not arguments.pages and not arguments.check:
        rows = run_all(arguments.program, arguments.only, json.loads(RECORD.read_text(encoding="utf-8")))
        RECORD.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    rows = json.loads(RECORD.read_text(encoding="utf-8"))
    if arguments.check:
        faults = find_faults(rows)
        print("\n".join(faults), file=sys.stderr, end="\n" if faults else "")
        sys.exit(1 if faults else 0)
    PAGE.write_text(renew_text(PAGE.read_text(encoding="utf-8"), rows), encoding="utf-8")
    draw(rows)


if __name__ == "__main__":
    main()
