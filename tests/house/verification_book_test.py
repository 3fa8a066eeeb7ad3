"""The validation book belongs together: pages, pictures, results.json, and the cases that the program lists."""

import copy
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])
BOOK = SOURCE / "docs" / "verification"
sys.path.insert(0, str(BOOK))

from book import cases, check, comparison, figures, pages, results  # noqa: E402 — after the path to it

KEPT = results.read_kept()


class VerificationBook(unittest.TestCase):
    def test_is_current(self):
        done = subprocess.run([sys.executable, "-B", BOOK / "make_book.py", os.environ["GXROD"], "--check"], text=True,
                              stderr=subprocess.PIPE, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_index_has_every_case(self):
        index = (BOOK / "README.md").read_text(encoding="utf-8")
        for name in KEPT["cases"]:
            self.assertEqual(index.count(f"| [{name}]({name}.md) |"), 1, name)

    def test_other_numbers_are_found(self):
        kept = copy.deepcopy(KEPT)
        kept["cases"]["arch"]["rows"][2]["error"] *= 1.5
        found = check.find_faults(kept, os.environ["GXROD"])
        self.assertEqual(len(found), 2, found)
        self.assertIn("arch.md has tables that are not those of results.json", found[0])
        self.assertIn("arch_convergence.png of arch is missing or not drawn from these data", found[1])

    def test_a_case_too_many_or_too_few_is_found(self):
        kept = copy.deepcopy(KEPT)
        kept["cases"]["arc"] = kept["cases"].pop("arch")
        found = "\n".join(check.find_faults(kept, os.environ["GXROD"]))
        self.assertIn("results.json has no arch, which the program lists", found)
        self.assertIn("results.json has arc, which the program does not list", found)

    def test_a_missing_page_is_found(self):
        with mock.patch.object(pages, "page_of", lambda name: BOOK / f"no_{name}.md"):
            found = check.find_faults(KEPT, os.environ["GXROD"])
        self.assertIn("no_arch.md is missing", found)

    def test_a_page_without_a_block_is_refused(self):
        with self.assertRaisesRegex(pages.PageFault, r"has the blocks \['runs'\], not \['results', 'runs'\]"):
            pages.renew_text("<!-- runs -->\n<!-- end -->\n", {"results": [], "runs": []})

    def test_a_page_without_a_picture_is_found(self):
        text = "![](figures/arch_sketch.png)"
        self.assertEqual(check.missing_figures(BOOK / "arch.md", text),
                         ["arch.md does not show figures/arch_convergence.png"])

    def test_what_is_written_by_hand_stays(self):
        text = "before\n<!-- index -->\nold\n<!-- end -->\nafter\n"
        self.assertEqual(pages.renew_text(text, {"index": ["new", "lines"]}),
                         "before\n<!-- index -->\nnew\nlines\n<!-- end -->\nafter\n")

    def test_a_picture_without_its_data_is_not_current(self):
        path = cases.figure_of("arch", figures.SKETCH)
        self.assertTrue(figures.is_current(path, figures.digest_of_sketch("arch")))
        self.assertFalse(figures.is_current(path, figures.digest_of_sketch("lee_frame")))
        self.assertFalse(figures.is_current(path.with_name("none.png"), ""))


class Comparison(unittest.TestCase):
    """What the tests verify.NAME find."""

    def faults_of(self, name, change):
        found = copy.deepcopy(KEPT["cases"][name])
        change(found)
        return comparison.compare(name, found, KEPT["cases"][name])

    def test_the_same_is_the_same(self):
        for name in KEPT["cases"]:
            self.assertEqual(self.faults_of(name, lambda case: None), [])

    def test_each_change_is_reported(self):
        row = KEPT["cases"]["bend_45"]["rows"][1]
        for key, value in (("error", 1.03 * row["error"]), ("order", row["order"] + 0.1), ("steps", row["steps"] + 1),
                           ("unknowns", row["unknowns"] + 6), ("newton_iterations", row["newton_iterations"] + 3)):
            with self.subTest(key):
                found = self.faults_of("bend_45", lambda case: case["rows"][1].update({key: value}))
                self.assertEqual(found, [f"{row['set']}: {key} is {value}, results.json has {row[key]}"])

    def test_round_off_is_not_reported(self):
        def change(case):
            case["rows"][1]["error"] *= 1.01
            case["rows"][1]["newton_iterations"] += 1
            case["rows"][-3]["error"] += 1e-9  # below the floor of 3e-9

        self.assertEqual(self.faults_of("bend_45", change), [])

    def test_checks_are_compared(self):
        found = self.faults_of("bend_45", lambda case: case["checks"][0].update(tolerance=1.0))
        self.assertEqual(found, ["order of the error; order 1: tolerance is 1.0, results.json has 0.3"])
        found = self.faults_of("bend_45", lambda case: case["checks"][0].update(error=0.1))
        self.assertEqual(found, ["order of the error; order 1: error is 0.1, results.json has 0.0"])
        value = next(index for index, check in enumerate(KEPT["cases"]["arch"]["checks"]) if "crown" in check["what"])
        found = self.faults_of("arch", lambda case: case["checks"][value].update(error=1e-6))
        self.assertEqual(len(found), 1, found)
        self.assertIn("crown reaction_force, t = 1; order 3: error is 1e-06, results.json has", found[0])

    def test_missing_runs_and_other_sources_are_reported(self):
        self.assertEqual(self.faults_of("bend_45", lambda case: case["rows"].pop()),
                         ["there are 16 rows, results.json has 17"])
        found = self.faults_of("arch", lambda case: case.update(kind="dynamics"))
        self.assertEqual(found, ["kind is 'dynamics', results.json has 'statics'"])

    def test_studies_are_compared(self):
        found = self.faults_of("rubin2007", lambda case: case["rows"][0].update(error_orientation=2.5))
        self.assertEqual(found, ["S, 50 steps: error_orientation is 2.5, results.json has 2.353"])
        found = self.faults_of("rod_schemes", lambda case: case["rows"][0].update(converged=False))
        self.assertIn("free flight newmark-simplified, 100 steps: converged is False", found[0])


class Kept(unittest.TestCase):
    def test_numbers_are_rounded(self):
        check_found = {"what": "x", "reference": [1.0, None], "uncertainty": 0.0, "value": [1.00123456, 5.4321],
                       "error": 1.23456e-3, "tolerance": 0.1, "order": 1.98765}
        kept = results.round_check(check_found)
        self.assertEqual((kept["value"], kept["error"], kept["order"]), ([1.0012, 5.4321], 1.235e-3, 1.99))

    def test_orders_are_rounded_as_orders(self):
        check_found = {"what": "order of the error; order 4", "reference": [7.5], "uncertainty": 0.0, "value": [8.6612],
                       "error": 0.0, "tolerance": 0.3, "order": None}
        self.assertEqual(results.round_check(check_found)["value"], [8.66])

    def test_writes_what_it_reads(self):
        with tempfile.TemporaryDirectory() as folder:
            path, usual = pathlib.Path(folder) / "results.json", results.KEPT
            results.KEPT = path
            try:
                results.write_kept(KEPT)
                self.assertEqual(json.loads(path.read_text(encoding="utf-8")), KEPT)
                self.assertEqual(path.read_bytes(), usual.read_bytes())
            finally:
                results.KEPT = usual


if __name__ == "__main__":
    unittest.main()
