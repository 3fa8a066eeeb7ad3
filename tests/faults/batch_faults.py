"""Batches whose first process, or one of its workers, is killed."""

import csv
import os
import pathlib
import shutil
import signal
import time

import results
from bench import Trial, describe_end
from decks import DECKS

PLAN = """deck = "rod.toml"
[vary]
"section.s.material.E" = { from = 1e7, to = 2e7, count = 24 }
[collect]
lowest = { history = "tip", quantity = "position", component = "z", take = "min" }
"""


def read_table(folder):
    """Rows by case, without the seconds, which differ from run to run."""
    with open(folder / "index.csv", newline="", encoding="utf-8") as file:
        return {row["case"]: {key: value for key, value in row.items() if key != "seconds"}
                for row in csv.DictReader(file) if row.get("warning") is not None}


class Batch:
    """A plan, and its undisturbed batch to compare with."""

    def __init__(self, bench):
        self.bench = bench
        (bench.folder / "rod.toml").write_text(DECKS["rod"].text)
        (bench.folder / "plan.toml").write_text(PLAN)
        begin = time.monotonic()
        done = bench.run("batch", "plan.toml", "-o", "undisturbed", "--quiet", "-j", "2", "--force")
        self.seconds = time.monotonic() - begin
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        self.folder = bench.folder / "undisturbed"
        self.table = read_table(self.folder)

    def start(self):
        shutil.rmtree(self.bench.folder / "plan", ignore_errors=True)
        return self.bench.start("batch", "plan.toml", "--quiet", "-j", "2")

    def compare(self, before):
        """What of the batch differs from the undisturbed one, or of a row that was there before."""
        folder = self.bench.folder / "plan"
        table = read_table(folder)
        for case, row in before.items():
            if table.get(case) != row:
                return f"the row of case {case} was lost"
        if table != self.table:
            return "the table differs"
        for path in sorted((self.folder / "cases").iterdir()):
            if results.list_differences(folder / "cases" / path.name, results.read_contents(path)):
                return f"{path.name} differs"
        return ""


def find_batch(bench):
    if bench.batch is None:
        bench.batch = Batch(bench)
    return bench.batch


def kill_batch(bench, _, random):
    """The first process is killed at any moment; the same command resumes."""
    batch = find_batch(bench)
    process = batch.start()
    time.sleep(random.uniform(0.0, batch.seconds))
    process.kill()
    process.communicate()
    table = bench.folder / "plan" / "index.csv"
    before = read_table(table.parent) if table.exists() else {}
    trial = Trial(describe_end(process.returncode), "resumed" if before else "started again")
    done = bench.run("batch", "plan.toml", "--quiet", "-j", "2")
    trial.lost = done.stderr if done.returncode != 0 else batch.compare(before)
    return trial


def kill_worker(bench, _, random):
    """A worker is killed at any moment; the batch runs its case again by itself."""
    batch = find_batch(bench)
    process = batch.start()
    time.sleep(random.uniform(0.0, batch.seconds))
    children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children")
    try:
        workers = [int(word) for word in children.read_text().split()]
        if workers:
            os.kill(random.choice(workers), signal.SIGKILL)
    except (FileNotFoundError, ProcessLookupError):
        workers = []
    errors = process.communicate(timeout=300)[1]
    trial = Trial(describe_end(process.returncode), "run again by itself" if workers else "had ended", message=errors)
    trial.lost = f"{trial.end}: {errors}" if process.returncode != 0 else batch.compare({})
    return trial


BATCH_FAULTS = {"kill_batch": kill_batch, "kill_worker": kill_worker}
