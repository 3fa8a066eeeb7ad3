"""Shapes that stages find, as users see them: lines of a run, tables, pictures, files for ParaView."""

import csv
import json
import os
import unittest

import h5py
import numpy as np
from program import ProgramTest

PLOT = os.environ["GXROD_PLOT"]

COLUMN = """
[section.s]
stiffness = { EA = 1e3, GAy = 4e2, GAz = 4e2, GJ = 1, EIy = 1, EIz = 2 }
inertia = { rhoA = 1, rhoJ = 3e-4, rhoIy = 1e-4, rhoIz = 2e-4 }
[rod.column]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 3
[[support]]
at = "column.start"
fix = "all"
[[load]]
at = "column.end"
force = [-1, 0, 0]
"""
STAGES = COLUMN + """
[[stage]]
name = "press"
kind = "static"
steps = 2
[[stage]]
name = "tones"
kind = "modes"
count = 4
[[stage]]
name = "more"
kind = "buckling"
"""


class Shapes(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("column.toml", STAGES)

    def test_a_run_lists_what_it_finds(self):
        done = self.gxrod("run", "column.toml", "--summary", "summary.json")
        self.assertRegex(done.stdout, r"tones: 4 modes below [\d.]+ cycles per time, and no others \(counted\)\n"
                                      r"     1  [\d.]+ +ω [\d.]+ +1st bending about y of column\n")
        self.assertIn("more: 3 buckling factors on the loads at t = 1, by linear theory", done.stdout)
        summary = json.loads((self.folder / "summary.json").read_text())
        self.assertEqual([found["stage"] for found in summary["found"]], ["tones", "more"])
        self.assertEqual(len(summary["found"][0]["shapes"]), 4)
        self.assertTrue(summary["found"][1]["complete"])

    def test_a_table_of_each_stage(self):
        self.gxrod("run", "column.toml", "--quiet")
        self.gxrod("export", "column.vtkhdf", "--csv", "tables")
        with open(self.folder / "tables" / "stage_tones.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        with h5py.File(self.folder / "column.vtkhdf") as file:
            tones = file["stages/tones"]
            np.testing.assert_array_equal([float(row["frequency"]) for row in rows], tones["frequency"][()])
            np.testing.assert_array_equal([float(row["effective_mass_z"]) for row in rows],
                                          tones["effective_mass"][:, 2])
            self.assertEqual([row["words"] for row in rows], list(tones["words"].asstr()))
        with open(self.folder / "tables" / "stage_more.csv", newline="") as file:
            self.assertEqual(len(list(csv.DictReader(file))), 3)

    def test_pictures(self):
        self.gxrod("run", "column.toml", "--quiet")
        for what in ("found", "all"):
            self.gxrod("column.vtkhdf", "--what", what, "-o", f"{what}.png", program=PLOT)
            self.assertGreater((self.folder / f"{what}.png").stat().st_size, 10000)
        (self.folder / "column.tones.vtkhdf").unlink()
        failed = self.gxrod("column.vtkhdf", code=4, program=PLOT)
        self.assertIn("column.tones.vtkhdf: there is no such file; it holds the shapes of stage tones", failed.stderr)

    def test_a_finished_run_has_nothing_to_resume(self):
        self.gxrod("run", "column.toml", "--quiet")
        before = (self.folder / "column.vtkhdf").read_bytes()
        done = self.gxrod("resume", "column.vtkhdf")
        self.assertIn("is at its end", done.stdout)
        self.assertEqual((self.folder / "column.vtkhdf").read_bytes(), before)

    def test_modes_of_the_reference_shape(self):
        self.write("bare.toml", COLUMN + '[analysis]\nkind = "modes"\n')
        done = self.gxrod("run", "bare.toml")
        self.assertIn("note: about the reference shape, where load[0] does not act", done.stderr)
        with h5py.File(self.folder / "bare.modes.vtkhdf") as file:
            grid = file["VTKHDF"]
            self.assertEqual(grid["Steps"].attrs["NSteps"][0], 10)
            self.assertEqual(len(grid["PointData/displacement"]), 10 * len(grid["Points"]))
        self.gxrod("bare.vtkhdf", "-o", "bare.png", program=PLOT)

    def test_answers_to_a_force_that_swings(self):
        self.write("shaken.toml", COLUMN + """
[[stage]]
name = "tones"
kind = "eigenvalues"
count = 4
[[stage]]
name = "shake"
kind = "response"
frequency = { from = 0.1, to = 1.0, count = 4 }
excite = [{ at = "column.end", force = [0, 0, 1] }]
[[history]]
name = "tip"
at = "column.end"
quantities = ["displacement"]
""")
        done = self.gxrod("run", "shaken.toml")
        self.assertIn("tones: 4 eigenvalues, and none missed nearer to 0 (counted)", done.stdout)
        self.assertIn("shake: the answer at 4 frequencies", done.stdout)
        self.gxrod("export", "shaken.vtkhdf", "--csv", "tables")
        with open(self.folder / "tables" / "stage_shake.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        with h5py.File(self.folder / "shaken.vtkhdf") as file:
            moves = file["stages/shake/histories/tip/displacement"][()]
        self.assertEqual(moves.shape, (4, 3, 2))
        np.testing.assert_array_equal([float(row["tip_displacement_z_real"]) for row in rows], moves[:, 2, 0])
        np.testing.assert_allclose([float(row["frequency"]) for row in rows], [0.1, 0.4, 0.7, 1.0])
        # Slowly, it bends as statics have it, PL/GA + PL^3/3EI; beyond the first tone against the force.
        self.assertAlmostEqual(moves[0, 2, 0], 1 / 400 + 1 / 3, delta=0.02)
        self.assertLess(moves[3, 2, 0], 0.0)
        self.gxrod("shaken.vtkhdf", "-o", "shaken.png", program=PLOT)

    def test_modes_over_a_number_of_the_deck(self):
        self.write("swept.toml", "[parameters]\nP = 1\n" + COLUMN.replace("force = [-1, 0, 0]", 'force = ["-P", 0, 0]') + """
[[stage]]
name = "press"
kind = "static"
steps = 1
[[stage]]
name = "onset"
kind = "eigenvalues"
count = 2
sweep = { key = "parameters.P", from = 0, to = 3, count = 4 }
""")
        done = self.gxrod("run", "swept.toml", "--summary", "summary.json")
        # B1: the column buckles at 2.458335976611 about y.
        self.assertRegex(done.stdout, r"onset: 2 modes followed over 4 values of parameters.P, from 0 to 3\n"
                                      r"     1  ω [\d.]+ +… [\d.]+ +1st bending about y of column\n")
        self.assertRegex(done.stdout, r"\n  divergence begins at parameters.P = 2.4583\d+\n")
        found = json.loads((self.folder / "summary.json").read_text())["found"][0]
        self.assertEqual((found["stage"], found["sweep"], len(found["modes"])), ("onset", "parameters.P", 2))
        self.assertAlmostEqual(found["onsets"][0]["value"], 2.458335976611, delta=1e-5)
        self.assertEqual(found["onsets"][0]["kind"], "divergence")
        self.gxrod("export", "swept.vtkhdf", "--csv", "tables")
        with open(self.folder / "tables" / "stage_onset.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        with h5py.File(self.folder / "swept.vtkhdf") as file:
            omegas = file["stages/onset/omega"][()]
        np.testing.assert_array_equal([float(row["omega_2"]) for row in rows], omegas[:, 1])
        self.gxrod("swept.vtkhdf", "--what", "found", "-o", "swept.png", program=PLOT)
        self.assertGreater((self.folder / "swept.png").stat().st_size, 10000)


if __name__ == "__main__":
    unittest.main()
