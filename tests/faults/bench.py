"""Runs gxrod under faults, and finds out afterwards whether anything was lost."""

import collections
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import time

import results

SHIMS = ("file", "clock", "memory")
# What gxrod resume says of a file whose run was stopped before it wrote a state to resume from.
NOTHING_TO_RESUME = r"cannot be resumed: (it has no state|it is not an HDF5 file|it is not a results file)"


@dataclasses.dataclass
class Trial:
    """One fault and what became of it. `lost` is empty unless something was."""
    end: str          # how the disturbed run ended: "killed", "exit 4" …
    recovery: str     # "resumed", "started again", "had ended"
    time: float = -1  # from which it resumed
    lost: str = ""
    message: str = ""


class Bench:
    """A folder in which decks are run, and whole runs of them to compare with."""

    def __init__(self, folder, gxrod, shims):
        self.folder = pathlib.Path(folder)
        self.program = pathlib.Path(gxrod)
        self.shims = pathlib.Path(shims)
        self.wholes = {}
        self.needs = {}  # of memory, by deck
        self.durations = {}
        self.batch = None
        self.bases = {}  # files to change bits of, by deck
        self.plot = str(self.program.parent / "gxrod-plot")
        self.plotted = 1.0  # how many of the files that are read are drawn, too, which takes long

    def environment(self, **faults):
        """The environment with libraries that bring about faults: FAULT="kill", CLOCK_TICK=5000 …"""
        chosen = {name: str(value) for name, value in faults.items() if value}
        starts = {"file": "FAULT", "clock": "CLOCK", "memory": "MEMORY"}
        libraries = [str(self.shims / f"lib{shim}_shim.so") for shim in SHIMS
                     if any(name.startswith(starts[shim]) for name in chosen)]
        if libraries:
            chosen["LD_PRELOAD"] = " ".join(libraries)
            chosen["ASAN_OPTIONS"] = "verify_asan_link_order=0"
        return {**os.environ, **chosen}

    def start(self, *arguments, environment=None, **options):
        return subprocess.Popen([str(self.program), *map(str, arguments)], cwd=self.folder, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment, **options)

    def run(self, *arguments, environment=None, timeout=300, **options):
        return subprocess.run([self.program, *map(str, arguments)], cwd=self.folder, text=True, timeout=timeout,
                              capture_output=True, check=False, env=environment, **options)

    def arguments(self, deck, is_long=False, name=None):
        """Those of `gxrod run` that start a deck again."""
        for file, text in ((f"{deck.name}.toml", deck.text), *deck.files):
            (self.folder / file).write_text(text)
        changes = [word for change in (deck.long if is_long else ()) for word in ("--set", change)]
        return ["run", f"{deck.name}.toml", "-o", name or self.path(deck).name, "--force", "--threads", deck.threads,
                *changes]

    def path(self, deck):
        return self.folder / f"{deck.name}.vtkhdf"

    def whole(self, deck, is_long=False):
        """The undisturbed run: its file and its contents."""
        key = (deck.name, is_long)
        if key not in self.wholes:
            path = self.folder / f"whole_{deck.name}{'_long' if is_long else ''}.vtkhdf"
            done = self.run(*self.arguments(deck, is_long, path.name), "--quiet")
            if done.returncode != 0:
                raise RuntimeError(f"{deck.name} does not run undisturbed: {done.stderr}")
            self.wholes[key] = (path, results.read_contents(path))
        return self.wholes[key]

    def seconds(self, deck):
        """How long the undisturbed long run takes."""
        if deck.name not in self.durations:
            self.whole(deck, is_long=True)
            begin = time.monotonic()
            self.run(*self.arguments(deck, is_long=True), "--quiet")
            self.durations[deck.name] = time.monotonic() - begin
        return self.durations[deck.name]

    def count_calls(self, deck, log, **faults):
        """How many calls an undisturbed run makes that could go wrong."""
        self.path(deck).unlink(missing_ok=True)
        counted = self.folder / "calls"
        done = self.run(*self.arguments(deck), "--quiet", environment=self.environment(**{log: counted}, **faults))
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        return int(counted.read_text())

    def recover(self, deck, trial, is_long=False, refusal=NOTHING_TO_RESUME):
        """Looks at what a fault left, and resumes."""
        path = self.path(deck)
        steps = results.count_steps(path) if path.exists() else None
        if steps is not None:
            trial.lost = trial.lost or results.find_fault(path, self.whole(deck, is_long)[0])
        return self.go_on(deck, trial, is_long, refusal)

    def go_on(self, deck, trial, is_long=False, refusal=NOTHING_TO_RESUME):
        """Goes on after a fault, as a user would, and compares with the undisturbed run. A file that cannot be
        resumed, with such a refusal, is started again."""
        whole = self.whole(deck, is_long)[1]
        path = self.path(deck)
        if path.exists():
            done = self.run("resume", path.name, "--threads", deck.threads)
        if path.exists() and done.returncode == 0:
            trial.recovery = "had ended" if "is at its end" in done.stdout else "resumed"
            going_on = re.search(r"continues from t = (\S+)", done.stdout)
            trial.time = float(going_on.group(1)) if going_on else float("inf")
        elif path.exists() and not re.search(refusal, done.stderr):
            trial.lost = trial.lost or f"cannot be resumed: {done.returncode} {done.stderr}"
            return trial
        else:
            trial.recovery = "started again"
            done = self.run(*self.arguments(deck, is_long), "--quiet")
            if done.returncode != 0:
                trial.lost = trial.lost or f"cannot be started again: {done.stderr}"
                return trial
        differences = results.list_differences(path, whole)
        if differences:
            trial.lost = trial.lost or f"differs in {', '.join(differences[:5])}"
        return trial


def describe_end(code):
    return f"signal {-code}" if code < 0 else f"exit {code}"


def find_steps_back(trials):
    """Of faults at one place after the other: where less was kept than after an earlier one."""
    latest = -1.0
    for number, trial in enumerate(trials):
        if trial.end == "exit 0":
            continue  # the fault was made good
        if trial.time < latest:
            return f"after fault {number + 1} the run continues from t = {trial.time}, after an earlier one from {latest}"
        latest = max(latest, trial.time)
    return ""


def write_record(path, name, trials, seed):
    """Adds the counts of a fault to those that the file has."""
    path = pathlib.Path(path)
    record = json.loads(path.read_text()) if path.exists() else {}
    recoveries = collections.Counter(trial.recovery for trial in trials if trial.recovery)
    record[name] = {"tried": len(trials), "lost": sum(bool(trial.lost) for trial in trials), "seed": seed,
                    "recovered": dict(sorted(recoveries.items())),
                    "ends": dict(sorted(collections.Counter(trial.end for trial in trials).items()))}
    path.write_text(json.dumps(record, indent=1) + "\n")
