"""Runs a random deck and judges what became of it.

A verdict is one of four kinds. "sound": done, the results are consistent, and the energy balances, or balances better
with shorter steps. "warned": done and consistent, and gxrod said that the energy does not balance, or that the
structure jumps. "refused" and "failed": exit code 2 or 3 with a message that has what it needs. Anything else is a
"finding"."""

import dataclasses
import json
import math
import re
import resource
import signal
import subprocess

import h5py
import numpy as np

import decks
import soundness
from finer import find_false_claim
from soundness import text

WARNING = "the energy does not balance"
JUMP = "the structure jumps"
BALANCED = 1e-3  # relative; above, shorter steps must help
TOLERABLE = 0.1  # above, gxrod must warn
LONGEST = 60  # seconds of processor time
MOST_RUNS = 100  # that a study may be worth, of the deck as it is
REPEATABLE = 0.3  # seconds of a run that is repeated with shorter steps
CRASH = re.compile(r"Sanitizer|runtime error|Assertion|terminate called|internal error", re.IGNORECASE)
FAILURE = re.compile(
    r"gxrod: (the initial accelerations cannot be found|the step from (t = |load factor )\S+ failed, even with "
    r"(Δt = |one of )\S+): .+\. Try .+\nResults up to t = \S+ are in deck\.vtkhdf")
REFUSAL = re.compile(r"deck\.toml(:\d+:\d+: [\w\[\].-]+: \S|: error: .+; a static analysis needs supports)")


@dataclasses.dataclass
class Verdict:
    index: int
    kind: str
    reason: str = ""
    imbalance: float = 0.0
    seconds: float = 0.0
    message: str = ""


def processor_time():
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def limit_time():
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST + 5))


class Judge:
    """Runs decks of one seed by one program in one folder."""

    def __init__(self, program, seed, folder):
        self.program = program
        self.seed = seed
        self.folder = folder
        self.seconds = 0.0  # of the last run's processor time

    def run(self, *arguments):
        before = processor_time()
        done = subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True, text=True,
                              errors="replace", preexec_fn=limit_time, check=False)
        self.seconds = processor_time() - before
        return done

    def run_deck(self, *settings):
        changes = [word for setting in settings for word in ("--set", setting)]
        return self.run("run", "deck.toml", "--force", "--quiet", "--summary", "summary.json", *changes)

    def read_summary(self):
        return json.loads((self.folder / "summary.json").read_text())

    def write_deck(self, index):
        for file in self.folder.iterdir():
            file.unlink()
        decks.write_deck(self.seed, index, self.folder)

    def judge(self, index):
        self.write_deck(index)
        return self.judge_run(index, self.run_deck())

    def examine(self, index):
        """What gxrod verify makes of a deck: it may call results wrong, but has nothing to blame on itself."""
        self.write_deck(index)
        done = self.run("verify", "deck.toml", "--json", "--seed", str(index))
        seconds = self.seconds
        verdict = self.judge_unended(index) if done.returncode == -signal.SIGXCPU else judge_study(index, done)
        verdict.seconds = seconds
        if verdict.kind == "sound":
            if claim := find_false_claim(self, json.loads(done.stdout)):
                verdict = Verdict(index, "finding", claim, seconds=seconds)
            for name in ("deck.vtkhdf", "summary.json"):
                (self.folder / name).unlink(missing_ok=True)
        if left := sorted(file.name for file in self.folder.iterdir() if file.suffix in (".vtkhdf", ".html")):
            return Verdict(index, "finding", f"leaves {', '.join(left)}")
        return verdict

    def judge_unended(self, index):
        """A study may be long where its runs are."""
        self.run_deck()
        (self.folder / "deck.vtkhdf").unlink(missing_ok=True)
        kind = "warned" if self.seconds > LONGEST / MOST_RUNS else "finding"
        return Verdict(index, kind, f"not done in {LONGEST} s of processor time")

    def judge_run(self, index, done):
        message = done.stderr.strip()
        seconds = self.seconds
        if done.returncode == -signal.SIGXCPU:
            kind = "sound" if soundness.has_gone_on(self.folder / "deck.vtkhdf") else "finding"
            return Verdict(index, kind, f"not done in {LONGEST} s of processor time", seconds=seconds)
        if done.returncode not in (0, 2, 3) or CRASH.search(message):
            return Verdict(index, "finding", f"exit code {done.returncode}", message=message)
        checked = self.run("check", "deck.toml")
        faults = find_disagreement(done, checked)
        if done.returncode == 2:
            verdict = judge_refusal(index, message)
        else:
            summary = self.read_summary()
            faults += soundness.find_faults(self.folder / "deck.vtkhdf", summary)
            verdict = (judge_failure(index, message) if done.returncode == 3 else
                       self.judge_balance(index, message, seconds))
            verdict.seconds = seconds
        if faults:
            return Verdict(index, "finding", "; ".join(faults), message=message)
        return verdict

    def judge_balance(self, index, message, seconds):
        error = soundness.read_imbalance(self.folder / "deck.vtkhdf")
        jumps = soundness.find_jumps(self.folder / "deck.vtkhdf")
        has_warned = (WARNING if jumps is None else JUMP) in message
        must_warn = error > TOLERABLE if jumps is None else jumps
        if not has_warned and soundness.has_no_energy(self.folder / "deck.vtkhdf", decks.make_plan(self.seed, index)):
            return Verdict(index, "sound", "no energy but round-off", error)
        if has_warned != must_warn:
            return Verdict(index, "finding", "the warning of the energy is not what the ledger says", error)
        if error <= BALANCED:
            return Verdict(index, "sound", "energy balances", error)
        if not has_warned and soundness.hardly_moves(self.folder / "deck.vtkhdf"):
            return Verdict(index, "sound", "energy balances as far as so small a motion has digits", error)
        kind = "warned" if has_warned else "sound"
        if seconds > REPEATABLE:
            return Verdict(index, kind, "energy does not balance; too long to repeat with shorter steps", error)
        return self.judge_finer(index, error, kind)

    def judge_finer(self, index, error, kind):
        """With shorter steps: the error of every scheme falls once they are short compared with every vibration, but as it
        likes where a load jumps within a step; in statics once they are shorter than those that were cut."""
        plan = decks.make_plan(self.seed, index)
        is_static = plan.scales.is_static
        for finer in (4, 16, 64, 256) if plan.jumps or is_static else (4, 16):
            done = self.run_deck(*shorter_steps(decks.make_deck(self.seed, index)[0], finer))
            if done.returncode != 0:
                return Verdict(index, kind, "energy does not balance; shorter steps fail", error)
            if soundness.read_imbalance(self.folder / "deck.vtkhdf") < 0.5 * error:
                return Verdict(index, kind, "energy balances better with shorter steps", error)
        if is_static and plan.jumps:
            return Verdict(index, kind, "energy does not balance; a load jumps, in any steps", error)
        if is_static and soundness.loses_energy_at_once(self.folder / "deck.vtkhdf"):
            return Verdict(index, kind, "energy does not balance; the structure jumps, in any steps", error)
        if not self.resolves_vibrations():
            return Verdict(index, kind, "energy does not balance; vibrations or turns shorter than any steps tried", error)
        reason = "energy does not balance better with shorter steps"
        return Verdict(index, kind if kind == "warned" else "finding", reason, error)

    def resolves_vibrations(self):
        """Whether the steps of the last run are short compared with the shortest period of the model and the fastest turn, both
        of which do not exist in statics, and none was cut."""
        with h5py.File(self.folder / "deck.vtkhdf") as file:
            step = file["solver/time_step"][:].max()
            if text(file.attrs["analysis"]) == "dynamic" and file["solver/rejected_steps"][:].any():
                return False
            fastest = np.linalg.norm(file["VTKHDF/PointData/angular_velocity"][:], axis=-1).max()
        highest = re.search(r"highest ([\d.e+-]+)", self.run("check", "deck.toml").stdout)
        if highest:
            fastest = max(fastest, 2 * math.pi * float(highest.group(1)))
        return fastest * step < 0.3

    def report_faults(self):
        """What is wrong with the page made of the last results."""
        done = self.run("report", "deck.vtkhdf", "-o", "page.html")
        page = self.folder / "page.html"
        if done.returncode != 0 or "</html>" not in page.read_text(encoding="utf-8", errors="replace"):
            return [f"no report: exit code {done.returncode}, {done.stderr.strip()}"]
        return []


def number_of(value):
    """That of the expressions that Draw.with_expressions writes."""
    return eval(value, {"__builtins__": {}}) if isinstance(value, str) else value  # pylint: disable=eval-used


def shorter_steps(deck, finer):
    analysis = deck["analysis"]
    if "adaptive" in analysis:
        step = number_of(analysis["end_time"]) / finer
        return [f"analysis.adaptive.max_step={step / 10!r}", "analysis.adaptive.min_step=0"]
    if "time_step" in analysis:
        return [f"analysis.time_step={number_of(analysis['time_step']) / finer!r}"]
    return [f"analysis.steps={int(number_of(analysis.get('steps', 10))) * finer}"]


def find_disagreement(done, checked):
    """gxrod check must find what gxrod run finds before its first step, and nothing else."""
    starts = "initial accelerations" not in done.stderr
    expected = done.returncode if done.returncode == 2 or not starts else 0
    if checked.returncode != expected:
        return [f"check ends with {checked.returncode}, run with {done.returncode}: {checked.stderr.strip()}"]
    return []


def judge_study(index, done):
    message = done.stderr.strip()
    if done.returncode == 2:
        return judge_refusal(index, message)
    if done.returncode not in (0, 3) or CRASH.search(message):
        said = json.loads(done.stdout)["judgement"] if done.returncode == 5 else []
        return Verdict(index, "finding", f"exit code {done.returncode}", message="\n".join([message, *said]))
    study = json.loads(done.stdout)
    errors = [series["relative_error"] for series in study["series"]]
    is_accurate = all(error is not None and error <= study["tolerance"] for error in errors)
    if study["accurate"] != is_accurate or done.returncode == 3 and is_accurate:
        return Verdict(index, "finding", "accurate or not, against its errors", message=message)
    if done.returncode == 3:
        return Verdict(index, "failed", "does not reach its end", message=study["judgement"][0])
    if any(error is None for error in errors):
        return Verdict(index, "warned", "errors are not known")
    return Verdict(index, "sound", "right to 1 %") if is_accurate else Verdict(index, "warned", "not right to 1 %")


def judge_refusal(index, message):
    lines = [line for line in message.splitlines() if ": warning: " not in line]
    if not lines or not all(REFUSAL.match(line) for line in lines):
        return Verdict(index, "finding", "a refusal without place, key or reason", message=message)
    return Verdict(index, "refused", message_class(lines[0]), message=message)


def judge_failure(index, message):
    if not FAILURE.search(message):
        return Verdict(index, "finding", "a failure without time, place or advice", message=message)
    return Verdict(index, "failed", message_class(FAILURE.search(message).group(0)), message=message)


def message_class(message):
    """The message without its numbers, names and places."""
    text = message.split(". Try ")[0].replace("deck.toml", "")
    text = re.sub(r"^: error: ", "", re.sub(r"^:\d+:\d+: ", "", text))
    text = re.sub(r" (at|through) [^.:;]*?\([^)]*\)", "", text)
    text = re.sub(r"(the part with .*?|rods? [\w, ]+?) can ", "… can ", text)
    text = re.sub(r"\b[rbs]\d+([.@][\w.]+)?( node \d+)?( \(\w+\))?", "…", text)
    text = re.sub(r"[-+]?\d[\d.]*(e[-+]?\d+)?", "…", text)
    return re.sub(r"(… ?,? ?(and )?)+", "… ", text).strip()
