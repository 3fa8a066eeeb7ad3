#!/usr/bin/env python3
"""Counts the instructions of an element and a Newton iteration, and compares them with those recorded.

Times depend on the machine and on what else it does; counts of one compiler's program hardly do. Valgrind's callgrind
counts two runs of pendulum.toml, or of sections.toml, that differ in their number of steps: the difference is free of
what it takes to start, to read the deck and to open the results.

    count_instructions.py build/release/gxrod            compares; exit code 1 if a count is off by more than 3 %
    count_instructions.py build/release/gxrod --record   records what it counts; to be done when a count falls, too

Exit code 77 means that nothing could be compared: no valgrind, or a program by another compiler than the recorded one.
"""

import argparse
import dataclasses
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
RECORD = FOLDER / "instruction_counts.json"
ORDERS = (1, 2, 3, 4)
SECTIONS = ("damped", "offset")  # of sections.toml
ELEMENTS = 128
STEPS = (2, 6)
TIME_STEP = 1e-3
TOLERANCE = 0.03
SKIPPED = 77

# One thread, and the same variants of functions on every machine: gxrod's own, and memcpy, sin and their like in the
# C library, which would choose by the processor.
ENVIRONMENT = {
    "GXROD_INSTRUCTION_SET": "baseline",
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX,-AVX2,-AVX512F,-AVX512VL,-FMA,-FMA4,-ERMS,-FSRM,-AVX_Fast_Unaligned_Load",
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
}

# Phases by the functions that they consist of, with all that these call. Output is none of them: when rows are
# written to the file depends on the clock.
PHASES = {
    "forces": ("gxrod::System::compute_residual(",),
    "tangent": ("gxrod::System::compute_tangent(",),
    "solve": ("gxrod::factorize(", "gxrod::solve_increment("),
    "ledger": ("gxrod::Ledger::add_step(", "gxrod::Ledger::row("),
}
WHOLE_STEPS = ("gxrod::solve_equilibrium(",)
# "update" is what else it takes to solve the steps.
COLUMNS = ("forces", "tangent", "solve", "update", "ledger", "total")

PIECES = ("{lambda", ".part", ".cold")
FUNCTION = re.compile(r"c?fn=\((\d+)\)(?: (.*))?$")


class Unmeasurable(Exception):
    """Why nothing can be counted or compared."""


@dataclasses.dataclass(frozen=True)
class Case:
    """One rod that is counted: of pendulum.toml, or with a section of sections.toml."""

    order: int
    section: str = ""

    @property
    def name(self):
        """As in the record."""
        return f"{self.order} {self.section}".strip()

    @property
    def deck(self):
        """What is run."""
        return FOLDER / ("sections.toml" if self.section else "pendulum.toml")

    @property
    def overrides(self):
        """What is set in the deck."""
        section = (f"rod.rod.section={self.section}",) if self.section else ()
        return (f"rod.rod.order={self.order}", f"rod.rod.elements={ELEMENTS}", *section)


CASES = [Case(order, section) for section in ("", *SECTIONS) for order in ORDERS]


@dataclasses.dataclass
class Run:
    """One counted run: instructions by function, callees included, and its Newton iterations."""

    functions: dict
    iterations: int

    def count(self, beginnings):
        """The instructions of the functions whose names begin so, each once: what they call is in their own."""
        return sum(self.count_function(beginning) for beginning in beginnings)

    def count_function(self, beginning):
        """Of a function, without the pieces of it that compilers make functions of."""
        found = [count for name, count in self.functions.items()
                 if name.startswith(beginning) and not any(piece in name for piece in PIECES)]
        if not found:
            raise LookupError(f"No function {beginning}…): PHASES of {pathlib.Path(__file__).name} names what a run "
                              "consists of")
        return sum(found)


def read_profile(path):
    """What callgrind wrote: instructions by function, callees included."""
    names, functions, current = {}, {}, ""
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            if found := FUNCTION.match(line):
                number, name = found.groups()
                if name:
                    names[number] = name
                if line.startswith("fn="):
                    current = number
            elif current and line[0] in "+-*0123456789":
                functions[current] = functions.get(current, 0) + int(line.split()[1])
    return {names[number]: count for number, count in functions.items()}


def count_run(program, case, steps, folder):
    """Runs the case's deck under callgrind."""
    profile, summary = folder / "profile", folder / "summary.json"
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", program, "run", case.deck,
               "--output", folder / "results.vtkhdf", "--force", "--quiet", "--summary", summary]
    for override in (*case.overrides, f"analysis.end_time={steps * TIME_STEP}"):
        command += ["--set", override]
    done = subprocess.run([str(word) for word in command], env={**os.environ, **ENVIRONMENT}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"The run under valgrind failed:\n{done.stdout}")
    return Run(read_profile(profile), json.loads(summary.read_text())["newton_iterations"])


def count_case(program, case, folder):
    """Instructions per element and iteration by phase, and iterations per step, of one case."""
    short, long = (count_run(program, case, steps, folder) for steps in STEPS)
    iterations = long.iterations - short.iterations

    def per_element(functions):
        return round((long.count(functions) - short.count(functions)) / (ELEMENTS * iterations))

    row = {name: per_element(functions) for name, functions in PHASES.items()}
    whole = per_element(WHOLE_STEPS)
    row["update"] = whole - row["forces"] - row["tangent"] - row["solve"]
    row["total"] = whole + row["ledger"]
    return {"iterations": iterations / (STEPS[1] - STEPS[0]), **{name: row[name] for name in COLUMNS}}


def find_compiler(program):
    """What compiled a program, as it says itself."""
    found = re.search(rb"GCC: \([^)]*\) ([\d.]+)", pathlib.Path(program).read_bytes())
    return f"g++ {found[1].decode()}" if found else "a compiler other than g++"


def print_table(counts, recorded):
    """Each count, and by how much it differs from the recorded one."""
    print(f"Instructions per element and Newton iteration, {ELEMENTS} elements\n")
    print(f"{'order':<9} {'it/step':>8}" + "".join(f"{name:>16}" for name in COLUMNS))
    for case, row in counts.items():
        cells = [f"{row[name]:>8}" + (f" {row[name] / recorded[case][name] - 1:>+7.1%}" if case in recorded else "")
                 for name in COLUMNS]
        print(f"{case:<9} {row['iterations']:>8.2f}" + "".join(f"{cell:>16}" for cell in cells))
    print()


def find_differences(counts, recorded):
    """A sentence for each count that is not what was recorded."""
    sentences = []
    for case, row in counts.items():
        for name in ("iterations", *COLUMNS):
            now, before = row[name], recorded.get(case, {}).get(name)
            if before is None:
                sentences.append(f"Order {case}, {name}: {now}; no count is recorded.")
            elif abs(now - before) > TOLERANCE * before:
                sentences.append(f"Order {case}, {name}: {now} instead of {before}, {now / before - 1:+.1%}.")
    return sentences


def compare(counts, compiler):
    """Prints what differs from the record; the exit code."""
    record = json.loads(RECORD.read_text())
    same_compiler = record["compiler"] == compiler
    print_table(counts, record["counts"] if same_compiler else {})
    if not same_compiler:
        raise Unmeasurable(f"recorded are counts of {record['compiler']}; this program is by {compiler}")
    differences = find_differences(counts, record["counts"])
    if not differences:
        print(f"All within {TOLERANCE:.0%} of the record.")
        return 0
    print("\n".join(differences))
    print(f"More than {TOLERANCE:.0%} off the record. What grew without a good reason is to be made fast again. "
          "What fell, or grew for a\ngood reason, is to be recorded with its change, or a later loss would go unseen:\n\n"
          "    tests/benchmarks/count_instructions.py build/release/gxrod --record")
    return 1


def record(counts, compiler):
    """Keeps the counts next to this script."""
    rows = ",\n".join(f'    "{case}": {json.dumps(row)}' for case, row in counts.items())
    RECORD.write_text(f'{{\n  "compiler": "{compiler}",\n  "counts": {{\n{rows}\n  }}\n}}\n')
    print_table(counts, {})
    print(f"Recorded in {RECORD.name}.")
    return 0


def main():
    """Counts, and compares or records."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="gxrod of a Release build")
    parser.add_argument("--record", action="store_true", help="record the counts instead of comparing them")
    arguments = parser.parse_args()
    try:
        if not shutil.which("valgrind"):
            raise Unmeasurable("there is no valgrind; cmake/install-packages test installs it")
        with tempfile.TemporaryDirectory() as folder:
            counts = {case.name: count_case(arguments.program, case, pathlib.Path(folder)) for case in CASES}
        keep = record if arguments.record else compare
        return keep(counts, find_compiler(arguments.program))
    except Unmeasurable as reason:
        print(f"Nothing compared: {reason}.")
        return SKIPPED


if __name__ == "__main__":
    sys.exit(main())
