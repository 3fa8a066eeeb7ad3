"""`gxrod batch`: many cases, one table."""

import json
import os
import unittest

import h5py
import numpy as np

from batches import FAILING, PLAN, SWINGER, BatchTest


class Running(BatchTest):
    def test_table_has_what_results_have(self):
        self.write("plan.toml", PLAN)
        done = self.gxrod("batch", "plan.toml", "-j", "2")
        self.assertIn("6 of 6 cases done", done.stdout)
        rows = self.rows()
        self.assertEqual([int(row["case"]) for row in rows], [1, 2, 3, 4, 5, 6])
        self.assertEqual([(row["parameters.EI"], row["analysis.time_step"]) for row in rows],
                         [(ei, step) for ei in ("100", "200", "500") for step in ("0.05", "0.02")])
        for row in rows:
            self.assertEqual((row["status"], row["reason"]), ("done", ""))
            with h5py.File(self.folder / "plan" / row["results"]) as file:
                t = file["histories/time"][:]
                z = file["histories/tip/position"][:, 2]
                v = file["histories/tip/velocity"][-1]
                error = file["ledger/energy_error"][:]
                self.assertEqual(int(row["newton_iterations"]), file["solver/newton_iterations"][:].sum())
            self.assertEqual(int(row["steps"]), len(t) - 1)
            self.assertEqual(float(row["time"]), t[-1])
            self.assertEqual(float(row["lowest"]), z.min())
            np.testing.assert_allclose(float(row["mean_z"]), np.trapz(z, t) / t[-1], rtol=1e-13)
            fine = np.linspace(0, t[-1], 100_001)
            np.testing.assert_allclose(float(row["rms_z"]),
                                       np.sqrt(np.trapz(np.interp(fine, t, z)**2, fine) / t[-1]), rtol=1e-7)
            np.testing.assert_allclose(float(row["half_z"]), np.interp(0.5, t, z), rtol=1e-13)
            np.testing.assert_allclose(float(row["speed"]), np.linalg.norm(v), rtol=1e-14)
            self.assertEqual(float(row["energy"]), np.abs(error).max())

    def test_the_record_says_what_the_columns_are(self):
        self.write("plan.toml", PLAN)
        self.gxrod("batch", "plan.toml", "--quiet")
        record = json.loads((self.folder / "plan" / "batch.json").read_text(encoding="utf-8"))
        self.assertEqual(record["title"], "A swinging rod")
        self.assertIn({"name": "lowest", "description": "least z of position of tip"}, record["columns"])

    def test_a_case_is_what_a_run_is(self):
        self.write("plan.toml", PLAN)
        self.gxrod("batch", "plan.toml", "--quiet")
        self.gxrod("run", "swinger.toml", "--set", "parameters.EI=200", "--set", "analysis.time_step=0.02",
                   "-o", "alone.vtkhdf", "--quiet")
        self.assertEqual(self.values_of("alone.vtkhdf"), self.values_of("plan/cases/0004.vtkhdf"))

    def test_a_row_and_its_file_have_the_warnings_of_the_run(self):
        pulse = '[[load]]\nat = "flyer.end"\nforce = [0, 0, "t > 0.21 && t < 0.215 ? 1e3 : 0"]\n'
        self.write("swinger.toml", SWINGER + pulse)
        self.write("plan.toml", PLAN)
        self.gxrod("batch", "plan.toml", "--quiet")
        for row in self.rows():
            self.assertIn("load[0].force[2]: between t = ", row["warning"])
            with h5py.File(self.folder / "plan" / row["results"]) as file:
                self.assertEqual(file.attrs["warnings"].replace("\n", "; "), row["warning"])

    def values_of(self, name):
        """The bytes of every dataset, except states to resume from: the older of two depends on the clock."""
        values = {}
        with h5py.File(self.folder / name) as file:
            file.visititems(lambda path, item: values.update({path: np.asarray(item[()]).tobytes()})
                            if isinstance(item, h5py.Dataset) and item.dtype.kind in "fiu"
                            and not path.startswith("restart/") else None)
        self.assertGreater(len(values), 20)
        return values

    def test_results_do_not_depend_on_workers(self):
        self.write("plan.toml", PLAN)
        for jobs in ("1", "2", "3"):
            self.gxrod("batch", "plan.toml", "-j", jobs, "-o", f"j{jobs}", "--quiet")
        self.assertEqual(self.table("j1"), self.table("j2"))
        self.assertEqual(self.table("j1"), self.table("j3"))
        for number in range(1, 7):
            one = self.values_of(f"j1/cases/{number:04}.vtkhdf")
            self.assertEqual(one, self.values_of(f"j2/cases/{number:04}.vtkhdf"))

    def test_plain_decks_and_a_table(self):
        self.write("other.toml", SWINGER.replace("elements = 4", "elements = 2"))
        self.gxrod("batch", "swinger.toml", "other.toml", "--quiet")
        self.assertEqual([row["deck"] for row in self.rows("batch")], ["swinger.toml", "other.toml"])
        self.write("cases.csv", "stiffness,parameters.EI,where\n1,150,\"[5, 0, 0]\"\n2,250,\"[6, 0, 0]\"\n")
        self.write("plan.toml", """deck = "swinger.toml"
combine = "table"
table = "cases.csv"
[vary]
"parameters.EI" = { column = "parameters.EI" }
"rod.flyer.line.to" = { column = "where" }
[collect]
x = { history = "tip", quantity = "position", component = "x", at = 0 }
""")
        self.gxrod("batch", "plan.toml", "--quiet")
        self.assertEqual([float(row["x"]) for row in self.rows()], [5.0, 6.0])

    def test_dry_run_lists_and_runs_nothing(self):
        self.write("plan.toml", PLAN)
        done = self.gxrod("batch", "plan.toml", "--dry-run", "-j", "3")
        self.assertIn("4: parameters.EI = 200, analysis.time_step = 0.02\n", done.stdout)
        self.assertIn("6 cases read and checked, 6 to run into plan, 3 at a time", done.stdout)
        self.assertFalse((self.folder / "plan").exists())
        self.gxrod("batch", "plan.toml", "--only", "2..3", "--quiet")
        done = self.gxrod("batch", "plan.toml", "--dry-run")
        self.assertIn("2: parameters.EI = 100, analysis.time_step = 0.02  [done]", done.stdout)
        self.assertIn("4 to run into plan", done.stdout)

    def test_what_is_kept(self):
        self.write("plan.toml", FAILING + "[keep]\nresults = \"failed\"\n")
        self.gxrod("batch", "plan.toml", "--quiet", code=3)
        rows = self.rows()
        self.assertEqual([row["status"] for row in rows], ["done", "failed", "done"])
        self.assertEqual([row["results"] for row in rows], ["", "cases/0002.vtkhdf", ""])
        self.assertEqual(os.listdir(self.folder / "plan" / "cases"), ["0002.vtkhdf"])
        self.write("plan.toml", PLAN + "[keep]\nresults = \"none\"\n")
        self.gxrod("batch", "plan.toml", "--quiet", "--force")
        self.assertEqual({row["results"] for row in self.rows()}, {""})
        self.assertFalse((self.folder / "plan" / "cases").exists())

    def test_summary_for_programs(self):
        self.write("plan.toml", PLAN)
        done = self.gxrod("batch", "plan.toml", "--summary", "-", "-j", "2")
        summary = json.loads(done.stdout)
        self.assertEqual({key: summary[key] for key in ("cases", "done", "failed", "time_limit", "missing", "run_now",
                                                        "interrupted", "workers", "folder")},
                         {"cases": 6, "done": 6, "failed": 0, "time_limit": 0, "missing": 0, "run_now": 6,
                          "interrupted": False, "workers": 2, "folder": "plan"})


if __name__ == "__main__":
    unittest.main()
