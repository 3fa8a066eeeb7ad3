#!/usr/bin/python3
"""Runs twelve motions by every integrator with many step lengths, and reports which scheme takes the least time for an error.

Saves its numbers in tests/data/work_precision.json, draws figures/work_precision.png, and renews the tables of work_precision.md.
`--pages` renews picture and tables without a run, `--check` reports whether they are those of work_precision.json; `--motion`
and `--scheme` measure some again. A whole run takes about a quarter of an hour.
"""

import argparse
import hashlib
import json
import os
import pathlib
import re
import resource
import statistics
import subprocess
import sys
import tempfile

import h5py
import numpy as np
from matplotlib.ticker import FuncFormatter
from PIL import Image
from PIL.PngImagePlugin import PngInfo

FOLDER = pathlib.Path(__file__).resolve().parent
SOURCE = FOLDER.parents[1]
RECORD = SOURCE / "tests" / "data" / "work_precision.json"
PAGE, PICTURE = FOLDER / "work_precision.md", FOLDER / "figures" / "work_precision.png"
sys.path.insert(0, str(SOURCE / "apps" / "python"))
from book.figures import KEYWORD, is_current  # noqa: E402 — after the path to it
from gxrod.plot import style  # noqa: E402

# Scheme: colour and marker. A further scheme is an entry here and, if it estimates errors, in CONTROLLED.
SCHEMES = {
    "newmark-simplified": (style.BLUE, "o"),
    "newmark-ibrahimbegovic": (style.ORANGE, "s"),
    "generalized-alpha": (style.GREEN, "^"),
    "sdirk-4": (style.PURPLE, "D"),
    "radau-5": (style.BLACK, "v"),
    "gauss-4": (style.GREY, "*"),
    "runge-kutta-4": (style.BROWN, "P"),
}
CONTROLLED = ("radau-5", "sdirk-4", "generalized-alpha", "newmark-simplified")
ACCURACIES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
WANTED = (1e-2, 1e-4, 1e-6)  # errors of the table
REPEATS = 3
LONGEST = 1.0  # seconds of a run after which steps are not halved again
SMALLEST = 2e-7  # an error after which they are not either
HALVINGS = 14
LIMIT = 10  # seconds of a run after which it is ended, and steps are not halved again
LEAST_DRAWN = 1e-8
# Example, changes, what is compared at the end, the size that errors are relative to, end time, fewest steps, steps of the reference.
# A quaternion is compared by its angle, in rad, and so is an angle.
MOTIONS = {
    "free flight": ("free_flight_smooth", ["rod.flyer.elements=8"],
                    ["loaded_end/position", "free_end/position"], 10.0, 10.0, 25, 3200),
    "free flight, 100 times stiffer": ("free_flight_smooth", ["rod.flyer.elements=8", "parameters.stiffer=100"],
                                       ["loaded_end/position", "free_end/position"], 10.0, 10.0, 25, 6400),
    "right angle": ("right_angle", ["rod.leg.elements=2", "rod.beam.elements=2", "rod.leg.order=3", "rod.beam.order=3"],
                    ["elbow/position", "tip/position"], 20.0, 10.0, 25, 3200),
    "rubber pendulum": ("rubber_pendulum", ["rod.rod.elements=8"], ["tip/position"], 1.0, 1.0, 25, 6400),
    "spin-up of a stiff beam": ("spin_up", [], ["tip/displacement"], 10.0, 16.0, 50, 6400),
    "stiff rod, turning": ("stiff_rod", [], ["middle/quaternion"], 1.0, 5.0, 25, 3200),
    "heavy top": ("heavy_top", [], ["top/centre_of_mass"], 1.0, 1.0, 50, 8000),
    "triple pendulum": ("triple_pendulum", [], ["tip/position", "wrist/angle"], 3.0, 2.0, 25, 6400),
    "slider-crank, flexible rod": ("flexible_slider_crank", [], ["middle/position"], 1.6e-3, 0.1, 50, 6400),
    "heaving cable in water": ("heaving_cable", ["rod.cable.elements=8"], ["middle/position"], 2.0, 24.0, 25, 3200),
    "chain on the ground": ("heaving_chain", ["rod.chain.elements=38"], ["touchdown/position"], 2.0, 15.0, 50, 3200),
    "wheels that friction stops": ("friction_brake", [], ["dry/angle", "damped/angle", "heavy/angle"], 1.0, 14.0, 25, 12800),
}
# A point that the example has no history of.
POINTS = {"chain on the ground": '[[history]]\nname = "touchdown"\nat = "chain@0.5"\nquantities = ["position"]\n'}
ANALYSIS_KEYS = "end_time|time_step|steps|integrator|newton|adaptive|accuracy|spectral_radius|beta|gamma"


def write_deck(motion, analysis, folder, end_time):
    """The example's deck with its motion integrated in another way."""
    name = MOTIONS[motion][0]
    text = (SOURCE / "docs" / "examples" / name / f"{name}.toml").read_text(encoding="utf-8")
    tables = re.split(r"^(?=\[)", text, flags=re.M)
    at = next(number for number, table in enumerate(tables) if re.search(r'^kind *= *"dynamic"', table, re.M))
    kept = re.sub(rf"^({ANALYSIS_KEYS})\b.*\n", "", tables[at], flags=re.M).rstrip()
    tables[at] = "\n".join([kept, f"end_time = {end_time!r}", *analysis]) + "\n\n"
    deck = folder / "run.toml"
    deck.write_text("".join(tables) + POINTS.get(motion, ""), encoding="utf-8")
    return deck


class TooLong(Exception):
    """A run that takes more than LIMIT."""


def set_limit():
    resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT))


def run(program, motion, analysis, folder, end_time=None, limit=set_limit):
    """Seconds of processor time, the compared values at the end, steps and iterations of a run; None if it failed."""
    results = folder / "run.vtkhdf"
    deck = write_deck(motion, analysis, folder, end_time or MOTIONS[motion][4])
    changes = [word for change in ("output.every=1000000", *MOTIONS[motion][1]) for word in ("--set", change)]
    command = [program, "run", deck, "-o", results, "--force", "--quiet", *changes]
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL, preexec_fn=limit)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if used.ru_utime + used.ru_stime >= LIMIT and limit:
        raise TooLong
    if process.returncode != 0:
        return None
    with h5py.File(results) as file:
        values = {point: np.atleast_1d(file[f"histories/{point}"][-1]).tolist() for point in MOTIONS[motion][2]}
        solver = file["solver"]
        steps, iterations = len(solver["newton_iterations"]) - 1, int(np.sum(solver["newton_iterations"][:]))
    if not all(np.all(np.isfinite(value)) for value in values.values()):
        return None
    return used.ru_utime + used.ru_stime, values, steps, iterations


def distance(motion, values, others):
    """The largest of the compared values' differences, relative."""
    found = []
    for point, value in values.items():
        a, b = np.array(value), np.array(others[point])
        if point.endswith("quaternion"):
            found.append(2.0 * min(np.linalg.norm(a - b), np.linalg.norm(a + b)))
        else:
            found.append(np.linalg.norm(a - b) / (1.0 if point.endswith("angle") else MOTIONS[motion][3]))
    return float(max(found))


def equal_steps(scheme, steps, *more):
    return [f'integrator = "{scheme}"', f"steps = {steps}", *more]


def find_reference(program, motion, folder):
    """Values at the end by radau-5 in many steps, and how far gauss-4 is from them."""
    steps, tight = MOTIONS[motion][6], "newton = { tolerance = 1e-11 }"
    _, values, _, _ = run(program, motion, equal_steps("radau-5", steps, tight), folder, limit=None)
    other = run(program, motion, equal_steps("gauss-4", steps, tight), folder, limit=None)
    return values, distance(motion, values, other[1])


def measure(program, motion, scheme, analysis, idle, reference, folder):
    """A row: the median of a few runs, without what a run of one step takes."""
    first = run(program, motion, analysis, folder)
    if first is None:
        return None
    seconds = [first[0], *(run(program, motion, analysis, folder)[0] for _ in range(REPEATS - 1))]
    _, values, steps, iterations = first
    spent = max(statistics.median(seconds) - idle, 1e-4)
    row = {"scheme": scheme, "steps": steps, "iterations": iterations,
           "error": float(f"{distance(motion, values, reference):.3g}"), "seconds": float(f"{spent:.3g}")}
    print(f"{motion}, {scheme}, {steps} steps: error {row['error']:.1e}, {row['seconds']:.3f} s", flush=True)
    return row


def list_runs(motion, scheme):
    """(analysis, steps, accuracy) of a scheme's runs."""
    for halving in range(HALVINGS):
        steps = MOTIONS[motion][5] * 2 ** halving
        yield equal_steps(scheme, steps), steps, None
    if scheme in CONTROLLED:
        for accuracy in ACCURACIES:
            yield [f'integrator = "{scheme}"', f"accuracy = {accuracy!r}"], None, accuracy


def measure_scheme(program, motion, scheme, idle, reference, folder):
    """Rows of ever more steps, then of steps by their error."""
    rows, ended = [], set()
    for analysis, steps, accuracy in list_runs(motion, scheme):
        is_controlled = accuracy is not None
        if is_controlled in ended:
            continue
        try:
            row = measure(program, motion, scheme, analysis, idle, reference, folder)
        except TooLong:
            ended.add(is_controlled)
            continue
        if row is None:
            print(f"{motion}, {', '.join(analysis)}: failed", flush=True)
            continue
        rows.append({**row, "accuracy": accuracy})
        is_cut = steps is not None and row["steps"] > 1.1 * steps  # which costs more than more steps
        if row["error"] < SMALLEST or (row["seconds"] > LONGEST and not is_cut):
            ended.add(is_controlled)
    return rows


def find_idle_seconds(program, motion, folder):
    """Of a run of one very short step."""
    return statistics.median(run(program, motion, equal_steps("newmark-simplified", 1), folder, 1e-7)[0] for _ in range(REPEATS + 2))


def measure_motion(program, motion, schemes, folder):
    """{floor, rows} of a motion."""
    reference, floor = find_reference(program, motion, folder)
    print(f"{motion}: radau-5 and gauss-4 agree to {floor:.1e}", flush=True)
    idle = find_idle_seconds(program, motion, folder)
    rows = []
    for scheme in schemes:
        rows += measure_scheme(program, motion, scheme, idle, reference, folder)
    return {"agreement": float(f"{floor:.2g}"), "rows": rows}


def save(motions):
    """A line for each row."""
    text = json.dumps(motions, indent=1)
    RECORD.write_text(re.sub(r"\n {4,}|\n {3}\}", lambda match: "}" if match[0].endswith("}") else " ", text) + "\n", encoding="utf-8")


def measure_all(program, motions, schemes):
    """Renews what is asked for, and keeps the rest of the record."""
    kept = json.loads(RECORD.read_text(encoding="utf-8")) if RECORD.exists() else {}
    with tempfile.TemporaryDirectory() as folder:
        for motion in motions:
            found = measure_motion(program, motion, schemes, pathlib.Path(folder))
            others = [row for row in kept.get(motion, {"rows": []})["rows"] if row["scheme"] not in schemes]
            found["rows"] = sorted(others + found["rows"], key=lambda row: list(SCHEMES).index(row["scheme"]))
            kept[motion] = found
            save({motion: kept[motion] for motion in MOTIONS if motion in kept})


def curve_of(rows, scheme, is_controlled):
    """Seconds and errors of a scheme's runs, from few steps to many."""
    found = [row for row in rows if row["scheme"] == scheme and (row["accuracy"] is not None) == is_controlled]
    return (np.array([row[key] for row in found]) for key in ("seconds", "error"))


def find_seconds(seconds, errors, wanted):
    """What an error takes, at the least: of runs from which on more steps have no larger one; between two by a power of the error."""
    if len(errors) == 0 or errors[-1] > wanted:
        return None
    good = len(errors) - 1
    while good > 0 and errors[good - 1] <= wanted:
        good -= 1
    least = float(np.min(seconds[good:]))
    if good == 0:
        return least
    part = np.log(wanted / errors[good - 1]) / np.log(errors[good] / errors[good - 1])
    return min(least, float(np.exp(np.log(seconds[good - 1]) + part * np.log(seconds[good] / seconds[good - 1]))))


def seconds_of(motion, wanted):
    """{(scheme, is_controlled): seconds} of those that reach an error; none of one that the reference does not show."""
    if wanted < 2.0 * motion["agreement"]:
        return {}
    rows = motion["rows"]
    found = {(scheme, is_controlled): find_seconds(*curve_of(rows, scheme, is_controlled), wanted)
             for scheme in SCHEMES for is_controlled in (False, True)}
    return {key: value for key, value in found.items() if value is not None}


def name_of(key):
    return f"{key[0]} by error" if key[1] else key[0]


def make_summary(motions):
    lines = ["| motion | " + " | ".join(f"{wanted:.0e}" for wanted in WANTED) + " |", "|---" * (len(WANTED) + 1) + "|"]
    for motion, found in motions.items():
        cells = []
        for wanted in WANTED:
            seconds = seconds_of(found, wanted)
            best = sorted(seconds, key=seconds.get)[:2]
            cells.append(", ".join(f"{name_of(key)} {seconds[key] / seconds[best[0]]:.2g}" if number else f"**{name_of(key)}** {1e3 * seconds[key]:.0f} ms"
                                   for number, key in enumerate(best)) or "none")
        lines.append(f"| {motion} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def make_ratios(motions, wanted):
    """Seconds over those of the fastest."""
    keys = [(scheme, False) for scheme in SCHEMES] + [(scheme, True) for scheme in SCHEMES if scheme in CONTROLLED]
    lines = ["| motion | " + " | ".join(name_of(key) for key in keys) + " |", "|---" * (len(keys) + 1) + "|"]
    for motion, found in motions.items():
        seconds = seconds_of(found, wanted)
        least = min(seconds.values(), default=1.0)
        lines.append(f"| {motion} | " + " | ".join(f"{seconds[key] / least:.2g}" if key in seconds else "" for key in keys) + " |")
    return "\n".join(lines)


def renew_text(text, motions):
    tables = {"summary": make_summary(motions), **{f"ratios {wanted:.0e}": make_ratios(motions, wanted) for wanted in WANTED}}
    for name, table in tables.items():
        text = re.sub(rf"(<!-- {name} -->\n).*?(\n<!-- end -->)", lambda match, table=table: match[1] + table + match[2], text, flags=re.S)
    return text


def digest_of(motions):
    return hashlib.sha256(json.dumps(motions, sort_keys=True).encode()).hexdigest()


def find_faults(motions):
    """What of page and picture is not of these numbers."""
    text = PAGE.read_text(encoding="utf-8")
    return ([f"{PAGE.name} has tables that are not those of {RECORD.name}"] if renew_text(text, motions) != text else []) + (
        [f"{PICTURE.name} is missing or not drawn from {RECORD.name}"] if not is_current(PICTURE, digest_of(motions)) else [])


def draw_motion(axes, motion, found):
    for scheme, (colour, marker) in SCHEMES.items():
        for is_controlled, look in ((False, {"ls": "-"}), (True, {"ls": "--", "mfc": "white"})):
            seconds, errors = curve_of(found["rows"], scheme, is_controlled)
            axes.plot(seconds, np.maximum(errors, LEAST_DRAWN), marker=marker, color=colour, ms=4.0, lw=1.1, clip_on=True, **look)
    axes.set(title=motion, xscale="log", yscale="log", ylim=(LEAST_DRAWN, 2.0), xlim=(2e-3, 3.0))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.set_yticks([1e-8, 1e-6, 1e-4, 1e-2, 1.0])


def draw(motions):
    figure = style.new_figure(9.6, 11.4)
    panels = figure.subplots(4, 3)
    for axes, (motion, found) in zip(panels.flat, motions.items()):
        draw_motion(axes, motion, found)
    for axes in panels[-1]:
        axes.set_xlabel("seconds of processor time")
    for axes in panels[:, 0]:
        axes.set_ylabel("error at the end")
    keys = [style.plt.Line2D([], [], color=colour, marker=marker, ms=5.0, label=scheme) for scheme, (colour, marker) in SCHEMES.items()]
    keys.append(style.plt.Line2D([], [], color=style.BLACK, ls="--", marker="v", mfc="white", ms=5.0, label="steps by their error"))
    figure.legend(handles=keys, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=4, handlelength=2.4)
    figure.savefig(PICTURE, dpi=110, bbox_inches="tight")
    style.plt.close(figure)
    reduce_colours(PICTURE, digest_of(motions))


def reduce_colours(path, digest):
    """To 64, and notes what it was drawn from."""
    information = PngInfo()
    information.add_text(KEYWORD, digest)
    with Image.open(path) as picture:
        picture.convert("RGB").quantize(64, dither=Image.Dither.NONE).save(path, optimize=True, pnginfo=information)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", nargs="?", default=str(SOURCE / "build" / "release" / "gxrod"), help="gxrod [build/release/gxrod]")
    parser.add_argument("--motion", action="append", choices=MOTIONS, help="measure this one again [all]")
    parser.add_argument("--scheme", action="append", choices=SCHEMES, help="measure this one again [all]")
    parser.add_argument("--pages", action="store_true", help="renew picture and tables from work_precision.json, without a run")
    parser.add_argument("--check", action="store_true", help="report whether picture and tables are those of work_precision.json")
    arguments = parser.parse_args()
    if not arguments.pages and not arguments.check:
        measure_all(arguments.program, arguments.motion or MOTIONS, arguments.scheme or list(SCHEMES))
    motions = json.loads(RECORD.read_text(encoding="utf-8"))
    if arguments.check:
        faults = find_faults(motions)
        print("\n".join(faults), file=sys.stderr, end="\n" if faults else "")
        sys.exit(1 if faults else 0)
    PAGE.write_text(renew_text(PAGE.read_text(encoding="utf-8"), motions), encoding="utf-8")
    draw(motions)


if __name__ == "__main__":
    main()
