"""Runs a deck with one kind of analysis and judges it: another way to the same numbers agrees, or a clear word is said.

A verdict is one of: "works"; "warned" (numbers differ, and gxrod says why they may); "refused" (exit code 2 or 4 and clear
words); "failed" (exit code 3 and clear words); "broken" (anything else)."""

import dataclasses
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys

import h5py
import numpy as np

import kinds

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "random"))
from toml_text import toml_text  # noqa: E402  pylint: disable=wrong-import-position

LONGEST = 60  # seconds of processor time of one run
UNCLEAR = re.compile(r"Sanitizer|Assertion|terminate called|internal error|report it|\bnan\b|\binf\b| , |by 0\.00e\+00|\(\)",
                     re.IGNORECASE)
GRADIENT = """
import json, sys, warnings
sys.path.insert(0, sys.argv[1])
import gxrod
with warnings.catch_warnings(record=True) as said:
    warnings.simplefilter("always")
    try:
        row, = gxrod.check_gradient(sys.argv[2], ["P"], "tip.displacement")
        others = [str(one.message) for one in said if "other steps" in str(one.message)]
        found = [list(map(float, row["derivative"])), list(map(float, row["difference"]))]
        sim = gxrod.Simulation(gxrod.Deck(sys.argv[2]))
        sim.run()
        try:
            found.append([float(sim.adjoint({"tip.displacement": axis}, ["P"])[0]) for axis in ([1, 0, 0], [0, 1, 0], [0, 0, 1])])
        except gxrod.Error as error:
            found.append(str(error))
        print(json.dumps(others[0] if others else found))
    except gxrod.Error as error:
        print(json.dumps(str(error)))
"""


@dataclasses.dataclass
class Verdict:
    kind: str
    words: str = ""


@dataclasses.dataclass
class Outcome:
    code: int
    words: str
    file: pathlib.Path

    @property
    def is_done(self):
        return self.code == 0

    def warnings(self):
        return self.words if "warning" in self.words else ""


class Mismatch(Exception):
    """Another way gives other numbers."""


class Ended(Exception):
    """A run that is needed for the comparison was refused or failed."""

    def __init__(self, outcome):
        super().__init__(outcome.words)
        self.outcome = outcome


def limit_time():
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST + 5))


def verdict_of_refusal(outcome):
    words = outcome.words.strip()
    if outcome.code == -signal.SIGXCPU:
        return Verdict("broken", f"not done in {LONGEST} s of processor time")
    kind = {2: "refused", 3: "failed", 4: "refused"}.get(outcome.code)
    if kind is None or not words or UNCLEAR.search(words):
        return Verdict("broken", f"exit code {outcome.code}: {words or 'no word'}")
    return Verdict(kind, words)


def require_close(one, other, tolerance, what):
    one, other = np.asarray(one), np.asarray(other)
    if one.shape != other.shape:
        raise Mismatch(f"{what}: {one.shape[0]} and {other.shape[0]} numbers")
    if not np.all(np.isfinite(one)) or not np.all(np.isfinite(other)):
        raise Mismatch(f"{what}: not finite")
    scale = max(np.max(np.abs(other), initial=0), 1e-3)
    error = np.max(np.abs(one - other), initial=0) / scale
    if error > tolerance:
        shown = (", ".join(f"{number:.6g}" for number in numbers.ravel()[:9]) for numbers in (one, other))
        raise Mismatch(f"{what}: {error:.1e} apart, ({next(shown)}) and ({next(shown)})")


def end_values(file):
    """Displacements and rotations at the end of a run, and stresses, which are some thousands."""
    with h5py.File(file) as results:
        histories = results["histories"]
        rows = [histories["tip/displacement"], histories["tip/rotation_vector"], histories["middle/displacement"]]
        values = np.concatenate([row[-1] for row in rows])
        if "edge" in histories:
            stresses = (histories["edge/stress"][-1], histories["edge/principal_stress"][-1], histories["root/von_mises"][-1:])
            values = np.concatenate([values, np.concatenate(stresses) / 1e4])
        return values


class Judge:
    """Judges cells of one deck, in one folder."""

    def __init__(self, program, folder, deck, features, module=None):
        self.program = program
        self.folder = pathlib.Path(folder)
        self.deck = deck
        self.follows_load = any(feature.follows_load for feature in features)
        self.kinked = any(feature.kinked for feature in features)
        self.by_steps = any(feature.by_steps for feature in features)
        self.same = 1e-4 if self.by_steps else 1e-6  # of ways to one equilibrium
        self.timed = any(feature.timed for feature in features)
        self.sudden = any(feature.sudden for feature in features)
        self.damped = any(feature.damped for feature in features)
        self.has_waves = "wave" in deck
        self.module = module  # Python and the folder of the package
        self.known = {}
        self.used = []  # the runs of the check at hand

    def call(self, *arguments):
        done = subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True, text=True,
                              errors="replace", preexec_fn=limit_time, check=False)
        return done

    def write(self, name, *tables, deck=None):
        (self.folder / f"{name}.toml").write_text(toml_text(kinds.with_analysis(deck or self.deck, *tables)))

    def run(self, *tables, deck=None, arguments=()):
        """An analysis, run once even if several comparisons need it."""
        key = json.dumps([tables, deck, arguments])
        if key not in self.known:
            name = f"run{len(self.known)}"
            self.write(name, *tables, deck=deck)
            done = self.call("run", f"{name}.toml", "-o", f"{name}.vtkhdf", "--force", *arguments)
            self.known[key] = Outcome(done.returncode, done.stderr, self.folder / f"{name}.vtkhdf")
        self.used.append(self.known[key])
        return self.known[key]

    def values(self, *tables, deck=None):
        outcome = self.run(*tables, deck=deck)
        if not outcome.is_done:
            raise Ended(outcome)
        return end_values(outcome.file)

    def judge(self, check, *arguments):
        """The verdict of one of the checks below."""
        first = None
        self.used = []
        try:
            first = check(*arguments)
        except Ended as ended:
            return verdict_of_refusal(ended.outcome)
        except Mismatch as mismatch:
            told = "\n".join(outcome.warnings() for outcome in self.used)
            return Verdict("warned" if told.strip() else "broken", str(mismatch))
        except (KeyError, OSError) as error:
            return Verdict("broken", f"{type(error).__name__}: {error}")
        return Verdict("works", first or "")

    def require_convergence(self, values, what):
        """Values with steps of h, h/2 and h/4, or with h, h/2 and a reference: errors fall or are small."""
        coarse, fine, reference = values
        scale = max(np.max(np.abs(reference)), 1e-3)
        before, after = (np.max(np.abs(one - reference)) / scale for one in (coarse, fine))
        least = 1e-1 if self.sudden else 2e-2 if self.kinked else 5e-3
        ratio = 0.85 if self.kinked else 0.65
        if not np.isfinite(after) or after > max(least, ratio * before):
            raise Mismatch(f"{what}: errors of {before:.1e} and, with half the step, {after:.1e}")

    # Kinds of analysis

    def static(self):
        end = self.values(kinds.static(10))
        if self.follows_load:
            self.require_convergence((end, self.values(kinds.static(20)), self.values(kinds.static(40))), "static steps")
            return
        require_close(end, self.values(kinds.static(5)), self.same, "10 and 5 load steps")
        path = self.run(kinds.path())
        if path.is_done:
            require_close(end, end_values(path.file), self.same, "static and path")

    def path(self):
        end = self.values(kinds.path())
        with h5py.File(self.run(kinds.path()).file) as results:
            reached = results["histories/time"][-1] if "load_factor" not in results["histories"] else results["histories/load_factor"][-1]
        if abs(reached - 1) > 1e-9:
            raise Mismatch(f"the path ends at t = {reached:.6g} of 1")
        static = self.values(kinds.static(40 if self.follows_load or self.by_steps else 10))
        require_close(end, static, 5e-2 if self.follows_load else self.same, "path and static")

    def quasi_static(self):
        if self.follows_load or self.has_waves or (self.damped and self.timed):
            ends = [self.values(kinds.quasi_static(steps)) for steps in (20, 40, 80)]
            self.require_convergence(ends, "quasi-static steps")
            return
        # What is damped creeps to its equilibrium.
        end = self.values(kinds.quasi_static(20, end_time=3.0 if self.damped else 1.0))
        static = self.run(kinds.static(10))
        if static.is_done:
            require_close(end, end_values(static.file), 1e-4 if self.damped else self.same, "quasi-static and static")
        half, quarter = (self.values(kinds.quasi_static(steps, end_time=0.3)) for steps in (10, 20))
        require_close(half, quarter, 2e-2, "quasi-static to 0.3 in 10 and 20 steps")

    def motion(self, scheme):
        deck = kinds.smooth(self.deck)
        first = kinds.EXPLICIT_STEPS if scheme == "runge-kutta-4" else kinds.STEPS
        coarse, fine = (self.values(kinds.motion(scheme, steps), deck=deck) for steps in (first, 2 * first))
        reference = self.reference_motion(deck)
        self.require_convergence((coarse, fine, reference), f"{scheme} and a fine reference")

    def reference_motion(self, deck):
        for scheme, steps in (("radau-5", 4 * kinds.STEPS), ("sdirk-4", 4 * kinds.STEPS), ("newmark-simplified", 16 * kinds.STEPS)):
            outcome = self.run(kinds.motion(scheme, steps), deck=deck)
            if outcome.is_done:
                return end_values(outcome.file)
        raise Ended(outcome)

    def accuracy(self):
        table = {"kind": "dynamic", "end_time": kinds.END, "accuracy": 1e-3}
        deck = kinds.smooth(self.deck)
        end = self.values(table, deck=deck)
        reference = self.reference_motion(deck)
        if self.kinked and np.max(np.abs(end - reference)) < 2e-2:
            return
        require_close(end, reference, 1e-2, "accuracy = 1e-3 and a fine reference")

    # Shapes

    def shapes(self, *tables):
        """The numbers of the last stage of shapes."""
        outcome = self.run(*tables)
        if not outcome.is_done:
            raise Ended(outcome)
        with h5py.File(outcome.file) as results:
            stages = results["stages"]
            name = f"stage{len(tables) - 1}" if len(tables) > 1 else list(stages)[-1]
            return {key: item[()] for key, item in stages[name].items() if isinstance(item, h5py.Dataset)}

    def modes(self):
        found = self.shapes(kinds.static(10), kinds.modes())["omega"][:4]
        again = self.shapes(kinds.static(20), kinds.modes())["omega"][:4]
        require_close(found, again, 3e-2 if self.follows_load else 1e-5, "modes after 10 and 20 load steps")
        if not self.damped:
            values = self.run(kinds.static(10), kinds.modes("eigenvalues"))
            if values.is_done:
                omega = self.shapes(kinds.static(10), kinds.modes("eigenvalues"))["omega"]
                require_close(np.sort(omega[omega > 0])[:4], np.sort(found), 1e-5, "eigenvalues and modes")

    def eigenvalues(self):
        """What rings after a small blow is a sum of motions of these eigenvalues."""
        # What slips rings with all that can still be resolved.
        found = self.shapes(kinds.static(10), kinds.modes("eigenvalues", 24 if self.kinked else 12))
        ringing = self.deck["load"] + [{"at": "beam.end", "stages": "stage1", "force": [
            "0", "1e-3*(t < 0.2 ? sin(5*pi*t)^2 : 0)", "2e-3*(t < 0.2 ? sin(5*pi*t)^2 : 0)"]}]
        # What slips or yields does so while it rings for the first times.
        long = 6.2 if self.kinked else 2.2
        ring = {"kind": "dynamic", "end_time": long, "steps": round(100 * long), "integrator": "radau-5", "newton": {"tolerance": 1e-11}}
        outcome = self.run(kinds.static(10), ring, deck=self.deck | {"load": ringing})
        if not outcome.is_done:
            return f"no motion to compare with: {outcome.words.strip()[:200]}"
        with h5py.File(outcome.file) as results:
            tip = results["histories/tip/displacement"][-200:]
        time = np.linspace(0.01, 2.0, 200)
        growth, omega = found["growth"], found["omega"]
        columns = [np.ones_like(time)]
        for real, imaginary in zip(growth, omega):
            columns += [np.exp(real * time) * np.cos(imaginary * time), np.exp(real * time) * np.sin(imaginary * time)]
        basis = np.stack(columns, axis=1)
        basis /= np.maximum(np.linalg.norm(basis, axis=0), 1e-30)
        worst = 0.0
        moving = tip - tip.mean(axis=0)
        largest = np.max(np.linalg.norm(moving, axis=0))
        if largest < 1e-9:
            return "nothing rings"
        for component in range(3):
            if np.linalg.norm(moving[:, component]) < 0.05 * largest:
                continue
            factors = np.linalg.lstsq(basis, tip[:, component], rcond=1e-10)[0]
            left = np.linalg.norm(basis @ factors - tip[:, component]) / np.linalg.norm(moving[:, component])
            worst = max(worst, left)
        if worst > 0.05:
            if self.timed:
                return "not compared: loads and moves start again with each stage"
            raise Mismatch(f"a motion after a small blow has {worst:.1%} that the eigenvalues do not explain")

    def response(self):
        """A force that swings infinitely slowly is a static one."""
        steps = 80 if self.by_steps else 10
        found = self.run(kinds.static(steps), kinds.response())
        if not found.is_done:
            raise Ended(found)
        with h5py.File(found.file) as results:
            amplitude = response_of_tip(results)
        size = 1e-4

        def pushed(factor):
            load = {"at": "beam.end", "force": [0, 0, factor * size]}
            return self.values(kinds.static(steps), deck=self.deck | {"load": self.deck["load"] + [load]})[:3]
        difference = (pushed(1.0) - pushed(-1.0)) / (2 * size)
        if self.follows_load:
            return "not compared: the state depends on the way to it"
        require_close(amplitude, difference, 1e-3, "response at frequency 0 and differences of statics")
        return None

    def buckling(self):
        """All that pushes, doubled, buckles at half of the factor."""
        first = self.shapes(kinds.modes("buckling", 2))["factor"]
        if np.any(np.abs(first) > 1e9):
            raise Mismatch(f"a factor of {np.max(np.abs(first)):.1e}")
        if self.sudden or self.has_waves:
            return "not compared: P does not multiply all that acts"
        outcome = self.run(kinds.modes("buckling", 2), deck=kinds.scaled(self.deck, 2.0))
        if not outcome.is_done:
            raise Ended(outcome)
        with h5py.File(outcome.file) as results:
            stages = results["stages"]
            second = stages[list(stages)[-1]]["factor"][()]
        require_close(2 * second, first, 1e-4, "factors of doubled loads, doubled, and of loads")
        return None

    def steady(self):
        """A motion that starts from a steady state stays at its distance from the axis."""
        deck = kinds.with_steady_frame(self.deck)
        steady = {"kind": "steady", "steps": 10, "newton": kinds.NEWTON}
        outcome = self.run(steady, deck=deck)
        if not outcome.is_done:
            raise Ended(outcome)
        if self.deck["support"] != [{"at": "beam.start", "fix": "all"}]:
            return "not compared: supports of another kind"
        motion = self.run(steady, kinds.motion("sdirk-4"), deck=deck | {"support": kinds.turning_support()})
        if not motion.is_done:
            return f"no motion to compare with: {motion.words.strip()[:200]}"
        with h5py.File(motion.file) as results:
            where = results["histories/tip/position"][-kinds.STEPS - 1:]
        distance = np.stack([where[:, 0], np.hypot(where[:, 1], where[:, 2])], axis=1)
        require_close(distance, np.broadcast_to(distance[0], distance.shape), 1e-3, "distances from the axis along a motion")
        return None

    # Stages and services

    def stages(self):
        """Statics, a motion, and statics again: the last equilibrium is the first one."""
        first = self.values(kinds.static(10))
        tables = kinds.static(10), kinds.motion("newmark-simplified"), kinds.static(4)
        last = self.values(*tables)
        if not self.follows_load and not self.has_waves and not self.timed:
            require_close(last, first, self.same, "statics before and after a motion")

    def same_bits(self, one, other, what):
        for run in (one, other):
            if not run.is_done:
                raise Ended(run)
        with h5py.File(one.file) as first, h5py.File(other.file) as second:
            for name in ("histories/tip/displacement", "histories/tip/rotation_vector", "histories/middle/moment"):
                if first[name][()].tobytes() != second[name][()].tobytes():
                    raise Mismatch(f"{what}: {name} differs")

    def threads(self):
        table = kinds.motion("newmark-simplified")
        self.same_bits(self.run(table), self.run(table, arguments=("--threads", "2")), "one and two threads")

    def resume(self):
        half = kinds.motion("newmark-simplified", 10, end_time=0.1)
        whole = self.run(kinds.motion("newmark-simplified", 20, end_time=0.2))
        if not whole.is_done:
            raise Ended(whole)
        self.write("half", half)
        done = self.call("run", "half.toml", "-o", "half.vtkhdf", "--force", "--quiet")
        if done.returncode == 0:
            done = self.call("resume", "half.vtkhdf", "--set", "analysis.end_time=0.2", "--set", "analysis.steps=20")
        self.same_bits(whole, Outcome(done.returncode, done.stderr, self.folder / "half.vtkhdf"), "run and resumed run")

    def pages(self):
        """Report, export, check and a batch of two cases."""
        table = kinds.motion("newmark-simplified")
        outcome = self.run(table)
        if not outcome.is_done:
            raise Ended(outcome)
        self.write("deck", table)
        for words in (("check", "deck.toml"), ("report", outcome.file.name, "-o", "page.html", "--force"),
                      ("export", outcome.file.name, "--csv", "csv", "--series", "series"),
                      ("batch", "deck.toml", outcome.file.with_suffix(".toml").name, "-o", "batch", "--force")):
            done = self.call(*words)
            if done.returncode != 0:
                raise Mismatch(f"gxrod {words[0]}: exit code {done.returncode}: {done.stderr.strip()[:300]}")

    def verify(self, *tables):
        """gxrod verify has nothing to blame on itself."""
        tables = tables or (kinds.motion("newmark-simplified"),)
        outcome = self.run(*tables)
        if not outcome.is_done:
            raise Ended(outcome)
        self.write("deck", *tables)
        done = self.call("verify", "deck.toml")
        if done.returncode == 5 and not UNCLEAR.search(done.stdout + done.stderr):
            self.used.append(Outcome(5, "warning: " + done.stdout, outcome.file))
        if done.returncode != 0:
            raise Mismatch(f"gxrod verify: exit code {done.returncode}: {(done.stdout + done.stderr).strip()[-400:]}")

    def gradient(self, *tables):
        """The derivative by all loads against differences of whole runs, and by multipliers where these are there."""
        if self.module is None:
            return "not asked: --python and --package give the Python module"
        outcome = self.run(*tables)
        if not outcome.is_done:
            raise Ended(outcome)
        python, package = self.module
        done = subprocess.run([python, "-c", GRADIENT, package, outcome.file.with_suffix(".toml").name], cwd=self.folder,
                              capture_output=True, text=True, preexec_fn=limit_time, check=False)
        if done.returncode != 0:
            raise Mismatch(f"Python ends with {done.returncode}: {done.stderr.strip()[-300:]}")
        found = json.loads(done.stdout)
        if isinstance(found, str):
            raise Ended(Outcome(2, found, outcome.file))
        require_close(found[0], found[1], 2e-2 if self.kinked else 1e-5, "derivative and difference")
        if not isinstance(found[2], str):
            require_close(found[0], found[2], 1e-7, "derivative carried along and by multipliers")
        elif "yet" not in found[2] and "depend" not in found[2] and "gradients" not in found[2]:
            raise Mismatch(f"by multipliers: {found[2]}")
        return None


def response_of_tip(results):
    """Complex amplitude of the tip's displacement at the first frequency, its real part."""
    found = []
    results["stages"].visititems(lambda name, item: found.append(item) if name.endswith("tip/displacement") else None)
    values = np.asarray(found[0][()]).reshape(-1, 3, 2) if found[0].ndim == 3 else np.asarray(found[0][()])
    return values[0, :, 0] if values.ndim == 3 else values[0].real
