"""The matrix campaign itself: it meets every part of the deck's schema, and sees what is wrong."""

import importlib.machinery
import importlib.util
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent / "random")]

import kinds  # noqa: E402  pylint: disable=wrong-import-position
import limits  # noqa: E402  pylint: disable=wrong-import-position
from features import FEATURES, cantilever  # noqa: E402  pylint: disable=wrong-import-position
from judge import Ended, Judge, Mismatch, Outcome, require_close, verdict_of_refusal  # noqa: E402  pylint: disable=wrong-import-position
from schema_coverage import list_items, list_used  # noqa: E402  pylint: disable=wrong-import-position

GXROD = os.environ["GXROD"]
# Tables and words that no feature has, with the reason.
ABSENT = {
    "output": "says what is written, not what is computed",
    "units": "a label",
    "title": "a label",
}


def load_campaign():
    loader = importlib.machinery.SourceFileLoader("campaign", str(FOLDER / "campaign"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("campaign", loader))
    loader.exec_module(module)
    return module


class Matrix(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.judge = Judge(GXROD, folder.name, cantilever(), [FEATURES["plain"]])

    def test_has_every_table_law_and_scheme_of_the_schema(self):
        schema = json.loads(subprocess.run([GXROD, "schema"], capture_output=True, text=True, check=True).stdout)
        used = set()
        decks = []
        for name in FEATURES:
            deck = cantilever()
            FEATURES[name].add(deck, random.Random(1))
            decks.append(kinds.with_analysis(deck, kinds.static(), kinds.motion("radau-5")))
        for tables in ([kinds.motion(scheme)] for scheme in kinds.SCHEMES):
            decks.append(kinds.with_analysis(cantilever(), *tables))
        for table in (kinds.static(), kinds.path(), kinds.quasi_static(), kinds.modes(), kinds.modes("buckling"), kinds.modes("eigenvalues"),
                      kinds.response()):
            decks.append(kinds.with_analysis(cantilever(), table))
        decks.append(kinds.with_analysis(kinds.with_steady_frame(cantilever()), {"kind": "steady"}))
        for deck in decks:
            used |= set(list_used(deck, schema, schema))
        items = set(list_items(schema, schema))
        wanted = {item for item in items if "." not in item and " " not in item and "[" not in item}
        wanted |= {item for item in items if item.startswith("section.*.law.") and item.count(".") == 3 and "[" not in item and " " not in item}
        wanted |= {item for item in items if item.startswith("analysis.kind = ") or item.startswith("analysis.integrator = ")}
        missing = sorted(wanted - used - set(ABSENT) - {"analysis.integrator = auto"})
        self.assertEqual(missing, [], "tests/matrix/features.py lacks a feature for these keys of the deck")

    def test_a_right_cell_works(self):
        self.assertEqual(self.judge.judge(self.judge.static).kind, "works")
        self.assertEqual(self.judge.judge(self.judge.buckling).kind, "works")

    def test_other_numbers_are_broken(self):
        def off():
            end = self.judge.values(kinds.static(10))
            require_close(end, end * 1.001, 1e-4, "numbers")
        self.assertEqual(self.judge.judge(off).kind, "broken")
        with self.assertRaises(Mismatch):
            require_close([np.nan], [np.nan], 1.0, "numbers")

    def test_steps_that_do_not_converge_are_broken(self):
        with self.assertRaises(Mismatch):
            self.judge.require_convergence((np.array([1.1]), np.array([1.09]), np.array([1.0])), "steps")
        self.judge.require_convergence((np.array([1.1]), np.array([1.04]), np.array([1.0])), "steps")

    def test_what_says_nothing_or_crashes_is_broken(self):
        for outcome, kind in ((Outcome(2, "deck.toml:1:2: analysis.kind: no such word", None), "refused"),
                              (Outcome(3, "the step failed. Try shorter steps", None), "failed"),
                              (Outcome(2, "", None), "broken"), (Outcome(-11, "", None), "broken"),
                              (Outcome(1, "internal error", None), "broken"),
                              (Outcome(3, "no velocities fit , which are off by 0.00e+00", None), "broken")):
            self.assertEqual(verdict_of_refusal(outcome).kind, kind, outcome)

    def test_a_misspelt_deck_is_refused(self):
        self.judge.deck["rod"]["beam"]["elemnts"] = 3
        self.assertEqual(self.judge.judge(self.judge.static).kind, "refused")

    def test_the_guide_lists_what_is_refused(self):
        """Each cell of docs/guide/limits.md is refused for the reason that stands there."""
        campaign = load_campaign()
        cells = [cell for cell in limits.cells_of_page() if cell[0] in campaign.CHECKS and not cell[0].startswith("gradient")]
        self.assertGreater(len(cells), 10)
        for kind, feature, why in cells:
            with self.subTest(kind=kind, feature=feature), tempfile.TemporaryDirectory() as folder:
                judge = Judge(GXROD, folder, campaign.deck_of([feature], 1), [FEATURES[feature]])
                verdict = judge.judge(campaign.CHECKS[kind], judge)
                self.assertEqual(verdict.kind, "refused")
                self.assertEqual(limits.reason(verdict.words), why, "run tests/matrix/campaign --limits")

    def test_a_refusal_that_changes_is_seen(self):
        rows = [{"features": "winch", "kind": "path", "verdict": "refused", "words": "gxrod: run0.toml:3:4: tendon.winch: not so"},
                {"features": "winch", "kind": "static", "verdict": "works", "words": ""}]
        self.assertIn("| path | winch | tendon.winch: not so |", limits.text_of(rows))
        self.assertIn("Of these 2 cells 1", limits.text_of(rows))

    def test_the_campaign_prints_what_it_judged(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            done = subprocess.run([sys.executable, FOLDER / "campaign", GXROD, "--only", "twist+spring", "static", "modes",
                                   "--page", page], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("2 cells: 2 works", done.stdout)
            self.assertIn("| twist+spring | works | works |", page.read_text())


if __name__ == "__main__":
    unittest.main()
