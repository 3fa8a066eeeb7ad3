#!/usr/bin/python3
"""Measures what plot.py draws, in some minutes: measure.py BUILD, the folder of a Release build with benchmarks.

times.json is what tests/benchmarks tells of runs of many sizes; errors.json are seconds and the position of the tip of
the same pendulum, run by gxrod, with elements of all orders; threads.json are microseconds an element and iteration
of that pendulum by one thread and by two.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile

import h5py

FOLDER = pathlib.Path(__file__).resolve().parent
DECK = FOLDER.parents[1] / "tests" / "benchmarks" / "pendulum.toml"
BENCHMARKS = "run_pendulum/objective|run_roll_up|run_net|solve_eigen_blocks|solve_rod.*/1000$"
ELEMENTS = {1: (10, 20, 40, 80, 160, 320, 640), 2: (5, 10, 20, 40, 80), 3: (4, 8, 16, 32), 4: (3, 6, 12, 24)}
REFERENCE = (4, 80)  # order and elements, the same steps
REPEATS = 3
SHARED = {1000: 300, 10_000: 30, 100_000: 5, 1_000_000: 2}  # steps of 1 ms, by elements
PHASES = ("assembly", "solve", "update")


def measure_times(build):
    """Google Benchmark's JSON, without what nobody needs."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "times.json"
        subprocess.run([build / "tests/benchmarks/gxrod_benchmarks", f"--benchmark_filter={BENCHMARKS}",
                        f"--benchmark_out={out}"], check=True)
        found = json.loads(out.read_text())
    context = {key: found["context"][key] for key in ("date", "mhz_per_cpu", "load_avg")}
    return {"context": context, "benchmarks": [shorten(row) for row in found["benchmarks"]]}


def shorten(row):
    """A benchmark's name and numbers, these to 5 digits."""
    unneeded = ("family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads")
    numbers = {key: float(f"{value:.5g}") for key, value in row.items()
               if isinstance(value, (int, float)) and key not in unneeded}
    return {"name": row["name"], "time_unit": row["time_unit"], **numbers}


def run_pendulum(program, order, elements, folder):
    """A run's tip at the end, its seconds (the fewest of a few runs), steps and iterations."""
    results, summary = folder / "pendulum.vtkhdf", folder / "summary.json"
    command = [program, "run", DECK, "--output", results, "--force", "--quiet", "--summary", summary,
               "--set", f"rod.rod.order={order}", "--set", f"rod.rod.elements={elements}"]
    seconds = []
    for _ in range(REPEATS):
        subprocess.run(command, check=True)
        told = json.loads(summary.read_text())
        seconds.append(told["wall_seconds"]["total"])
    with h5py.File(results) as file:
        tip = file["histories/tip/position"][-1]
    print(f"order {order}, {elements} elements: {min(seconds):.3g} s, tip {tip}")
    return {"order": order, "elements": elements, "seconds": min(seconds), "steps": told["steps"],
            "iterations": told["newton_iterations"], "tip": list(tip[:2])}


def measure_errors(build):
    """Runs of all orders and sizes, and the reference."""
    with tempfile.TemporaryDirectory() as folder:
        run = [run_pendulum(build / "gxrod", order, elements, pathlib.Path(folder))
               for order, sizes in [*((order, sizes) for order, sizes in ELEMENTS.items()),
                                    (REFERENCE[0], REFERENCE[1:])]
               for elements in sizes]
    return {"reference": run[-1], "rows": run[:-1]}


def time_phases(program, elements, threads, folder):
    """Microseconds an element and iteration of each phase of the first steps."""
    summary = folder / "summary.json"
    subprocess.run([program, "run", DECK, "--output", folder / "pendulum.vtkhdf", "--force", "--quiet",
                    "--summary", summary, "--threads", str(threads), "--set", f"rod.rod.elements={elements}",
                    "--set", f"analysis.end_time={1e-3 * SHARED[elements]}"], check=True)
    told = json.loads(summary.read_text())
    return [1e6 * told["wall_seconds"][phase] / (elements * told["newton_iterations"]) for phase in PHASES]


def measure_threads(build):
    """Medians of runs that alternate between one thread and two."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for elements in SHARED:
            runs = {1: [], 2: []}
            for _ in range(REPEATS + 2):
                for threads, found in runs.items():
                    found.append(time_phases(build / "gxrod", elements, threads, pathlib.Path(folder)))
            for threads, found in runs.items():
                medians = [float(f"{statistics.median(phase):.4g}") for phase in zip(*found)]
                print(f"{elements} elements, {threads} threads: {medians}")
                rows.append({"elements": elements, "threads": threads, **dict(zip(PHASES, medians))})
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    build = parser.parse_args().build.resolve()
    for name, measured in (("threads", measure_threads(build)), ("errors", measure_errors(build)),
                           ("times", measure_times(build))):
        (FOLDER / f"{name}.json").write_text(json.dumps(measured, indent=1) + "\n")


if __name__ == "__main__":
    main()
