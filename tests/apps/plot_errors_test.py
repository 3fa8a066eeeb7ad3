"""gxrod-plot --error: errors of batches over mesh or step, against closed forms."""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")

SOURCE = Path(os.environ["GXROD_SOURCE"])
sys.path[:0] = [str(SOURCE / "apps" / "python"), str(SOURCE / "tests" / "apps" / "batch")]
sys.dont_write_bytecode = True

from batch_folders import BatchFolder  # noqa: E402
from forked import run_forked  # noqa: E402
from gxrod.plot import command, convergence, error_figure  # noqa: E402

PLANK = """title = "A plank"
[section.plank]
shape    = { rectangle = { width_y = 0.3, height_z = 0.05 } }
material = { E = 11e9, G = 6e8, density = 500, shear_factor = "5/6" }
[rod.plank]
section  = "plank"
line     = { from = [0, 0, 0], to = [3, 0, 0] }
elements = 2
order    = 1
y_axis   = [0, 1, 0]
[[support]]
at  = "plank.start"
fix = "all"
[[load]]
at    = "plank.end"
force = [0, 0, -80]
[analysis]
kind = "static"
steps = 2
[[history]]
name = "tip"
at   = "plank.end"
quantities = ["displacement"]
"""
PLAN = """deck = "plank.toml"
[vary]
"rod.plank.order" = [1, 2]
"rod.plank.elements" = [2, 4, 8, 16, 32]
[collect]
tip = { history = "tip", quantity = "displacement", component = "z", take = "final" }
"""


class Errors(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def plot(self, *arguments, code=0):
        done = run_forked(command.main, arguments, self.folder)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done

    def make(self, key="rod.a.elements", values=(2, 4, 8, 16, 32), of=lambda n: 3.0 + 5.0 * n**-2.0, name="batch", **record):
        """A batch that collects `of` of the values of a key."""
        batch = BatchFolder(self.folder / name, [key], ["tip"], **record)
        for value in values:
            batch.add([value], [repr(float(of(value)))])
        return batch

    def orders(self, *arguments):
        """Of each line the orders that the table says."""
        lines = self.plot("--error", *arguments).stdout.splitlines()
        rows = [line.split() for line in lines if re.fullmatch(r"\s+\S+\s+\S+\s+\S+\s+(-|[\d.]+)", line)]
        return [None if row[-1] == "-" else float(row[-1]) for row in rows]

    def test_an_order_is_found_against_the_finest_run_and_against_a_number(self):
        for power in (1.0, 2.0, 4.0):
            with self.subTest(power=power):
                folder = self.make(of=lambda n, power=power: 3.0 + 5.0 * n**-power, name=f"p{power:g}").write()
                self.assertEqual(self.orders(folder), [None, power, power, power])
                self.assertEqual(self.orders(folder, "--reference", "3"), [None, power, power, power, power])

    def test_a_step_is_finer_where_it_is_smaller(self):
        steps = (0.1, 0.04, 0.02, 0.01)
        folder = self.make("analysis.time_step", steps, lambda h: 1.0 - 7.0 * h**2).write()
        self.assertEqual(self.orders(folder), [None, 2.0, 2.0])
        self.assertRegex(self.plot(folder, "--error").stdout, r"(?s)0\.1 .*0\.04 .*0\.02 ")

    def test_a_key_of_another_name_is_finer_where_values_change_less(self):
        folder = self.make("parameters.cells", (1, 2, 4, 8), lambda n: 2.0 + n**-3.0).write()
        self.assertIn("varies neither elements nor steps nor a step or tolerance; --x takes the key", self.plot(folder, "--error", code=2).stderr)
        self.assertEqual(self.orders(folder, "--x", "cells"), [None, 3.0, 3.0])

    def test_round_off_has_no_order(self):
        folder = self.make(of=lambda n: 3.0 + (5.0 * n**-2.0 if n < 8 else 1e-14 / n)).write()
        self.assertEqual(self.orders(folder, "--reference", "3"), [None, 2.0, None, None, None])

    def test_columns_with_a_reference_are_errors_already(self):
        batch = self.make(of=lambda n: 5.0 * n**-2.0)
        batch.record["columns"] = [{"name": "tip", "description": "final z of displacement of tip, distance from 3"}]
        self.assertEqual(self.orders(batch.write()), [None, 2.0, 2.0, 2.0, 2.0])
        self.assertIn("against the reference of the plan", self.plot("batch", "--error").stdout)

    def test_cases_that_failed_are_left_out_and_said(self):
        batch = self.make()
        batch.rows[1][2:4] = ["failed", "did not converge"]
        done = self.plot(batch.write(), "--error")
        self.assertIn("without 1 of 5 cases, which are not done", done.stdout)
        self.assertNotRegex(done.stdout, r"\n\s+4 ")

    def test_the_picture_has_orders_triangles_and_the_numbers_of_the_runs(self):
        self.plot(self.make().write(), "--error", "-o", "a.svg")
        texts = re.findall(r"<!-- (.*?) -->", (self.folder / "a.svg").read_text(encoding="utf-8"))
        for text in ("2", "4", "8", "16", "2.00", "1", "rod.a.elements", "error of tip"):
            self.assertIn(text, texts)
        request = type("Request", (), {"x": None, "y": [], "reference": None, "size": None, "title": None})
        [axes] = error_figure.draw_errors(convergence.read_convergence(self.folder / "batch", request), request).axes
        line, triangle = axes.get_lines()
        x, y = triangle.get_data()
        self.assertAlmostEqual(np.log(y[0] / y[1]) / np.log(x[1] / x[0]), 2.0)
        np.testing.assert_array_equal(line.get_xdata(), [2, 4, 8, 16])
        self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))

    def test_tables_of_latex(self):
        done = self.plot(self.make().write(), "--error", "--latex", "-o", "b.png")
        self.assertEqual(done.stdout.split()[-2:], ["b.png", "b.tex"])
        table = (self.folder / "b.tex").read_text()
        self.assertIn("\\toprule\nrod.a.elements & error & order \\\\\n\\midrule", table)
        self.assertIn("$4$ & $3.08\\cdot10^{-1}$ & $2.00$ \\\\\n", table)  # 5/16 − 5/1024
        self.assertEqual(table.count("\\begin{tabular}"), table.count("\\end{tabular}"))

    def test_steps_in_latex_are_powers_of_ten(self):
        self.plot(self.make("analysis.newton.tolerance", (1e-3, 2e-5, 1e-7, 1e-9), lambda h: 1.0 - 7.0 * h).write(), "--error", "--latex")
        table = (self.folder / "batch.tex").read_text()
        self.assertEqual(re.findall(r"^\$(\S+)\$ &", table, re.MULTILINE), ["0.001", r"2\cdot10^{-5}", r"10^{-7}"])

    def test_a_reference_of_the_plan_and_another_one_are_refused(self):
        batch = self.make()
        batch.record["columns"] = [{"name": "tip", "description": "final z of displacement of tip, distance from 3"}]
        self.assertIn("--reference: the plan has a `reference`", self.plot(batch.write(), "--error", "--reference", "3", code=2).stderr)

    def test_rows_without_values_are_left_out(self):
        of = lambda n: 2.0 + n**-3.0 if n > 1 else np.nan
        self.assertEqual(self.orders(self.make("parameters.cells", (1, 2, 4, 8, 16), of).write(), "--x", "cells"), [None, 3.0, 3.0])
        for words in ((), ("--reference", "3")):
            self.assertIn("too few cases", self.plot(self.make(of=lambda n: np.nan).write(), "--error", *words, code=2).stderr)

    def test_a_beam_against_its_own_finest_mesh(self):
        (self.folder / "plank.toml").write_text(PLANK)
        (self.folder / "plan.toml").write_text(PLAN)
        subprocess.run([os.environ["GXROD"], "batch", "plan.toml", "--quiet"], cwd=self.folder, check=True, capture_output=True)
        done = self.plot("plan", "--error")
        first, second = done.stdout.split("order = 2")
        orders = [float(line.split()[-1]) for line in (first.splitlines()[-1], second.splitlines()[4])]
        # Elements of order p with reduced integration: the end converges with 2p.
        self.assertAlmostEqual(orders[0], 2.0, delta=0.1)
        self.assertAlmostEqual(orders[1], 4.0, delta=0.3)

    def test_a_study_by_verify(self):
        (self.folder / "plank.toml").write_text(PLANK)
        done = subprocess.run([os.environ["GXROD"], "verify", "plank.toml", "--json"], cwd=self.folder, capture_output=True, text=True, check=False)
        (self.folder / "study.json").write_text(done.stdout)
        study = json.loads(done.stdout)
        mesh = study["series"][0]["mesh"]["differences"]
        said = self.plot("study.json", "--error").stdout
        self.assertIn(f"{np.log2(mesh[0] / mesh[1]):.2f}", said)
        # Steps of a linear load on objective elements change nothing but round-off.
        self.assertLess(study["series"][0]["steps"]["differences"][0], 1e-10)
        self.assertNotIn("half the step", said)

    def test_faults_are_one_line(self):
        self.make().write()
        (self.folder / "no.json").write_text("{}")
        for words, says, code in (
                (("nowhere", "--error"), "nowhere: --error takes the folder of a batch, or what `gxrod verify DECK --json` printed", 2),
                ((".", "--error"), "index.csv: cannot be read", 4),
                (("no.json", "--error"), "no.json: is not what `gxrod verify DECK --json` prints", 4),
                (("batch", "--error", "--y", "top"), "--y top: the batch collects no such column; there are tip", 2),
                (("batch", "--error", "--x", "top"), "--x top: not a key of positive numbers that differs between cases; there are rod.a.elements", 2),
                (("batch", "batch", "--error"), "--error needs one folder of a batch, or one study", 2),
                (("batch", "--latex"), "--reference and --latex go with --error", 2),
                ((self.make(values=(2, 4), name="two").write(), "--error"), "too few cases are done", 2),
                ((self.make(name="random", combine="latin-hypercube").write(), "--error"), "holds random samples", 2)):
            with self.subTest(words=words):
                self.assertIn(says, self.plot(*words, code=code).stderr)


if __name__ == "__main__":
    unittest.main()
