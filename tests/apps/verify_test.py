"""gxrod verify: tables, JSON, figures, exit codes."""

import json
import unittest

import numpy as np

from program import ProgramTest


class Verify(ProgramTest):
    def test_lists_the_studies(self):
        listed = self.gxrod("verify", "--list").stdout
        self.assertIn("rubin2007", listed)
        self.assertIn("free_flight", listed)

    def test_rubin2007_as_json(self):
        done = self.gxrod("verify", "rubin2007", "--json")
        rows = json.loads(done.stdout)["rubin2007"]
        self.assertEqual({row["scheme"] for row in rows}, {"S", "I", "RK4", "SDIRK4", "RADAU5", "GAUSS4"})
        self.assertEqual([row["steps"] for row in rows if row["scheme"] == "S"], [50, 100, 200, 400, 800, 1600])
        self.assertEqual(set(rows[0]), {"scheme", "steps", "max_theta_deg", "error_orientation", "error_momentum",
                                        "error_energy", "iterations_per_step", "diverged"})
        simplified = next(row for row in rows if row["scheme"] == "S" and row["steps"] == 100)
        self.assertAlmostEqual(simplified["error_orientation"], 0.850934, delta=5e-6)
        diverged = next(row for row in rows if row["diverged"])
        self.assertEqual((diverged["scheme"], diverged["steps"], diverged["error_orientation"]), ("RK4", 50, None))
        explicit = next(row for row in rows if row["scheme"] == "RK4" and row["steps"] == 400)
        self.assertIsNone(explicit["max_theta_deg"])
        self.assertIsNone(explicit["iterations_per_step"])

    def test_rubin2007_as_a_table(self):
        table = self.gxrod("verify", "rubin2007", "--steps", "100,200").stdout
        self.assertIn("0.850934", table)
        self.assertIn("agrees", table)
        self.assertNotIn("MISSED", table)

    def test_checks_as_json(self):
        found = json.loads(self.gxrod("verify", "bend_45", "composite", "--json").stdout)
        self.assertEqual({check["case"] for check in found["checks"]}, {"bend_45", "composite"})
        check = next(check for check in found["checks"] if check["what"] == "end position, t = 1; order 4")
        self.assertEqual((check["kind"], check["passed"]), ("statics", True))
        self.assertIn("Bathe & Bolourchi (1979)", check["source"])
        self.assertEqual(check["reference"], [46.891924953, 15.557785914, 53.607369177])
        self.assertEqual(check["uncertainty"], 5e-10)
        self.assertLess(np.linalg.norm(np.subtract(check["value"], check["reference"])), 1e-8)
        self.assertLess(check["error"], check["tolerance"])

    def test_the_table_of_all(self):
        told = self.gxrod("verify", "bend_45", "symmetric_top", "--table").stdout
        head, first = told.splitlines()[:2]
        self.assertRegex(head, r"case and value +reference ± uncertainty +gxrod +error tolerance +order")
        self.assertRegex(first, r"^bend_45 \(statics\): Bathe & Bolourchi \(1979\), GJ of the square section; by shooting\. \d")
        self.assertRegex(told, r"\n  end position, t = 1; order 3: z +53.607369177 ± 5e-10 +53\.6073691")
        self.assertRegex(told, r"\n2 cases, 30 checks, none missed in \d")

    def test_figures(self):
        self.gxrod("verify", "rubin2007", "--steps", "50,100,200", "--figures", "figures")
        for name in ("fig2", "fig3", "fig4"):
            self.assertTrue((self.folder / "figures" / f"{name}.csv").exists())
            self.assertGreater((self.folder / "figures" / f"{name}.png").stat().st_size, 10000)

    def test_an_unknown_study(self):
        done = self.gxrod("verify", "rubin2008", code=2)
        self.assertIn("rubin2007", done.stderr)
        self.gxrod("verify", code=2)
        self.gxrod("verify", "rubin2007", "--steps", "0", code=2)

    def test_a_folder_that_cannot_be(self):
        (self.folder / "file").write_text("")
        self.gxrod("verify", "rubin2007", "--steps", "100", "--figures", "file", code=4)


if __name__ == "__main__":
    unittest.main()
