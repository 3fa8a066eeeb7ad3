"""Random decks: that they use all of the deck's schema, that they are the same again, that the judge sees what is
wrong, and a short campaign."""

import dataclasses
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import decks  # noqa: E402  pylint: disable=wrong-import-position
import schema_coverage  # noqa: E402  pylint: disable=wrong-import-position
import soundness  # noqa: E402  pylint: disable=wrong-import-position
from verdict import Judge, judge_failure, judge_refusal, judge_study  # noqa: E402  pylint: disable=wrong-import-position

GXROD = pathlib.Path(os.environ["GXROD"])
SHORT = 8 if os.environ.get("GXROD_SANITIZED") == "1" else 30
SEED = 7

BEAM = """[section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 2
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, 1, 0]
[analysis]
kind = "static"
steps = 2
[[history]]
name = "tip"
at = "r.end"
quantities = ["position", "displacement", "quaternion", "rotation_vector"]
"""


class Decks(unittest.TestCase):
    def test_use_every_key_and_choice_of_the_schema(self):
        schema = json.loads(subprocess.run([GXROD, "schema"], capture_output=True, text=True, check=True).stdout)
        unused = set(schema_coverage.list_items(schema, schema))
        self.assertGreater(len(unused), 300)
        for index in range(4000):
            unused -= set(schema_coverage.list_used(decks.make_deck(SEED, index)[0], schema, schema))
            if not unused:
                break
        self.assertEqual(sorted(unused), [])

    def test_are_the_same_again(self):
        for index in range(20):
            self.assertEqual(decks.make_deck(SEED, index), decks.make_deck(SEED, index))
        self.assertNotEqual(decks.make_deck(SEED, 0), decks.make_deck(SEED, 1))
        self.assertNotEqual(decks.make_deck(SEED, 0), decks.make_deck(SEED + 1, 0))


class Judgement(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "deck.toml").write_text(BEAM)
        judge = Judge(GXROD, SEED, self.folder)
        self.assertEqual(judge.run_deck().returncode, 0)
        self.summary = judge.read_summary()

    def faults_after(self, name, change):
        """What is found after a dataset's numbers were changed."""
        with h5py.File(self.folder / "deck.vtkhdf", "r+") as file:
            values = file[name][()]
            change(values)
            file[name][...] = values
        return soundness.find_faults(self.folder / "deck.vtkhdf", self.summary)

    def test_sees_nothing_in_a_sound_file(self):
        self.assertEqual(self.faults_after("ledger/kinetic_energy", lambda values: None), [])

    def test_sees_what_is_wrong(self):
        def put(index, value):
            def change(values):
                values[index] = value
            return change

        def add(index, value):
            def change(values):
                values[index] += value
            return change

        for name, change, fault in (
                ("VTKHDF/PointData/velocity", put((1, 0), np.nan), "not finite"),
                ("VTKHDF/PointData/axis_y", add((4, 0), 1e-6), "orthonormal"),
                ("VTKHDF/PointData/displacement", add((5, 1), 1e-6), "where the model was"),
                ("histories/tip/quaternion", add((1, 0), 1e-6), "unit quaternion"),
                ("histories/tip/displacement", add((1, 0), 1e-6), "displacement"),
                ("histories/tip/rotation_vector", add((2, 2), 0.1), "differ"),
                ("ledger/energy_error", add(1, 1e-3), "other columns"),
                ("ledger/strain_energy", put(0, -1.0), "negative"),
                ("solver/newton_iterations", add(1, 1), "newton_iterations"),
                ("solver/time_step", add(1, 0.1), "time steps"),
                ("histories/time", put(2, 0.4), "times do not rise")):
            with self.subTest(name):
                self.setUp()
                self.assertIn(fault, "; ".join(self.faults_after(name, change)))

    def test_sees_another_status(self):
        self.summary["status"] = "failed"
        self.assertIn("status", "; ".join(self.faults_after("ledger/kinetic_energy", lambda values: None)))

    def test_asks_messages_for_place_and_advice(self):
        good = ("gxrod: the step from t = 0.5 failed, even with Δt = 1e-05: the rotation within one step reaches half a "
                "turn at r0.end. Try a smaller time_step\nResults up to t = 0.5 are in deck.vtkhdf")
        self.assertEqual(judge_failure(0, good).kind, "failed")
        self.assertEqual(judge_failure(0, good.replace(". Try a smaller time_step", "")).kind, "finding")
        self.assertEqual(judge_failure(0, good.replace("Results up to t = 0.5", "")).kind, "finding")
        refusal = "deck.toml:5:11: rod.r0.section: no section \"s\"; the deck has s0"
        self.assertEqual(judge_refusal(0, refusal).kind, "refused")
        self.assertEqual(judge_refusal(0, refusal.replace(":5:11", "")).kind, "finding")
        self.assertEqual(judge_refusal(0, "").kind, "finding")


class Campaign(unittest.TestCase):
    def test_has_no_findings(self):
        with tempfile.TemporaryDirectory() as folder:
            judge = Judge(GXROD, SEED, pathlib.Path(folder))
            verdicts = [judge.judge(index) for index in range(SHORT)]
            # The page of whatever ran last.
            self.assertEqual(judge.report_faults() if (judge.folder / "deck.vtkhdf").exists() else [], [])
        findings = [dataclasses.asdict(verdict) for verdict in verdicts if verdict.kind == "finding"]
        self.assertEqual(findings, [])
        self.assertGreater(sum(verdict.kind == "sound" for verdict in verdicts), SHORT / 2)

    def test_studies_blame_nothing_on_gxrod(self):
        # Of seed 1, some that hardly move, that are of a mesh, have one step, few digits, or steps that are cut.
        with tempfile.TemporaryDirectory() as folder:
            judge = Judge(GXROD, 1, pathlib.Path(folder))
            verdicts = [judge.examine(index) for index in (4, 9, 5, 12, 35, 116, 123, 131, 168, 200, 216, 1480)[:SHORT // 2]]
        self.assertEqual([verdict for verdict in verdicts if verdict.kind not in ("sound", "warned")], [])

    def test_a_study_is_judged(self):
        def judge(code, accurate, *errors):
            study = {"accurate": accurate, "tolerance": 0.01, "judgement": ["It is so."],
                     "series": [{"relative_error": error} for error in errors]}
            return judge_study(0, subprocess.CompletedProcess([], code, json.dumps(study), ""))

        self.assertEqual(judge(0, True, 0.01, 0.0).kind, "sound")
        self.assertEqual(judge(0, False, 0.02, 0.0).reason, "not right to 1 %")
        self.assertEqual(judge(0, False, None).reason, "errors are not known")
        self.assertEqual(judge(0, True, 0.02, 0.0).kind, "finding")
        self.assertEqual(judge(0, True, None).kind, "finding")
        self.assertEqual(judge(3, False, None).kind, "failed")
        self.assertEqual(judge(3, True, 0.0).kind, "finding")
        self.assertEqual(judge(5, True, 0.0).kind, "finding")
        self.assertEqual(judge(5, True, 0.0).message, "\nIt is so.")
        self.assertEqual(judge(-11, True).kind, "finding")

    def test_a_study_is_long_only_for_a_long_run(self):
        with tempfile.TemporaryDirectory() as folder:
            judge = Judge(GXROD, SEED, pathlib.Path(folder))

            def judge_after(seconds):
                judge.run_deck = lambda: setattr(judge, "seconds", seconds)
                return judge.judge_unended(0).kind

            self.assertEqual(judge_after(5.0), "warned")
            self.assertEqual(judge_after(0.05), "finding")


if __name__ == "__main__":
    unittest.main()
