"""Short parts of the campaign: each fault a few times. Nothing may be lost."""

import os
import pathlib
import random
import tempfile
import unittest

import h5py

from bench import Bench, Trial
from catalogue import FAULTS, run_fault
from decks import DECKS, LARGE
from memory_faults import judge_memory_error, run_limited
from table import read_record, write_table
from writing_faults import may_mount

SANITIZED = os.environ["GXROD_SANITIZED"] == "1"
# Trials of each. Sanitizers slow every run, and want memory of their own; other tests kill and interrupt runs under them.
COUNTS = {"kill": 3, "sigterm": 2, "ctrl_c_twice": 2, "file_size_limit": 3, "small_disk": 2, "kill_resumed": 2,
          "kill_in_write": 12, "torn_write": 3, "disk_full": 9, "disk_full_once": 3, "io_error": 3,
          "read_only": 1, "removed": 1, "moved": 1, "locked": 1, "clock_jumps": 1, "short_writes": 2,
          "truncated": 3, "flipped": 6, "memory_limit": 0, "allocation": 20, "kill_batch": 1, "kill_worker": 1}
SANITIZED_COUNTS = {**dict.fromkeys(FAULTS, 0), "kill_in_write": 3, "disk_full": 3, "short_writes": 1, "truncated": 1}
QUICK = [DECKS[name] for name in ("rod", "deflated", "body")]


class Faults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.bench = Bench(folder.name, os.environ["GXROD"], os.environ["GXROD_SHIMS"])
        cls.bench.plotted = 0.25

    def check(self, name):
        count = (SANITIZED_COUNTS if SANITIZED else COUNTS)[name]
        if count == 0:
            self.skipTest("tests/faults/campaign tries it")
        if name == "small_disk" and not may_mount():
            self.skipTest("this machine does not let its users have disks of their own")
        trials = run_fault(name, self.bench, QUICK, count, random.Random(name))
        self.assertGreaterEqual(len(trials), count)
        self.assertEqual([trial.lost for trial in trials if trial.lost], [])
        return trials

    def test_every_fault_is_tried(self):
        self.assertEqual(COUNTS.keys(), FAULTS.keys())

    def test_a_kill_in_writing_comes_before_and_after_there_is_a_state_to_resume_from(self):
        trials = self.check("kill_in_write")
        self.assertEqual({trial.end for trial in trials}, {"signal 9"})
        if not SANITIZED:
            self.assertEqual({trial.recovery for trial in trials}, {"started again", "resumed"})

    def test_a_full_disk_is_reported_with_how_to_resume(self):
        trials = self.check("disk_full")
        resumed = [trial for trial in trials if trial.recovery == "resumed"]
        self.assertGreater(len(resumed), 0)
        for trial in resumed:
            name = trial.message.split(":")[1].strip()
            self.assertRegex(trial.message, rf"^gxrod: {name}: cannot write: No space left on device\n"
                                            rf"{name} holds what was computed up to t = \S+\. To resume: gxrod resume {name}$")

    def test_a_failed_allocation_is_reported(self):
        trials = self.check("allocation")
        self.assertGreater(sum("out of memory" in trial.message for trial in trials), 12)


    def test_too_little_memory_is_reported(self):
        if SANITIZED:
            self.skipTest("sanitizers have memory of their own")
        deck = LARGE
        ends = set()
        for megabytes in (70, 85, 100, 115):
            done = run_limited(self.bench, deck, megabytes << 20)
            self.assertEqual(judge_memory_error(done), "", megabytes)
            ends.add(done.returncode)
        self.assertIn(1, ends)
        self.assertEqual(self.bench.recover(deck, Trial("", "")).lost, "")


def add_test(name):
    def test(self):
        self.check(name)

    setattr(Faults, f"test_{name}", test)


for fault in FAULTS.keys() - {"kill_in_write", "disk_full", "allocation"}:
    add_test(fault)


class Page(unittest.TestCase):
    def test_the_table_of_reliability_is_that_of_the_campaign(self):
        docs = pathlib.Path(os.environ["GXROD_SOURCE"]) / "docs"
        record = read_record(docs / "reliability" / "campaign.json")
        self.assertEqual(record.keys(), FAULTS.keys())
        self.assertIn(write_table(record), (docs / "reliability.md").read_text(encoding="utf-8"))


class Judgement(unittest.TestCase):
    """The campaign sees a loss where there is one."""

    def test_a_step_that_differs_is_a_loss(self):
        with tempfile.TemporaryDirectory() as folder:
            bench = Bench(folder, os.environ["GXROD"], os.environ["GXROD_SHIMS"])
            deck = DECKS["body"]
            for name in ("histories/spin/position", "ledger/kinetic_energy", "VTKHDF/PointData/velocity"):
                bench.run(*bench.arguments(deck))
                with h5py.File(bench.path(deck), "r+") as file:
                    file[name][3] += 1e-300 if name.startswith("hist") else 1.0
                trial = bench.recover(deck, run_nothing())
                self.assertEqual(trial.lost, f"{name} differs")

    def test_a_missing_row_is_a_loss(self):
        with tempfile.TemporaryDirectory() as folder:
            bench = Bench(folder, os.environ["GXROD"], os.environ["GXROD_SHIMS"])
            deck = DECKS["body"]
            bench.run(*bench.arguments(deck))
            with h5py.File(bench.path(deck), "r+") as file:
                file["ledger/strain_energy"].resize(600, axis=0)
            self.assertEqual(bench.recover(deck, run_nothing()).lost,
                             "ledger/strain_energy has 600 rows, 601 are promised")


def run_nothing():
    return Trial("", "")


if __name__ == "__main__":
    unittest.main()
