"""`gxrod batch`: many cases, one table; stopped, killed, resumed; failures of cases and of users."""

import csv
import json
import os
import pathlib
import signal
import subprocess
import time
import unittest

import h5py
import numpy as np

from program import GXROD, ProgramTest

SANITIZED = os.environ.get("GXROD_SANITIZED") == "1"

SWINGER = """title = "A swinging rod"
gravity = [0, 0, -9.81]
[parameters]
EI = 500.0
[section.tube]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = "EI", EIy = "EI", EIz = "EI" }
inertia = { rhoA = 1.0, rhoJ = 20.0, rhoIy = 10.0, rhoIz = 10.0 }
[rod.flyer]
section = "tube"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 4
[[support]]
at = "flyer.start"
fix = ["x", "y", "z"]
[analysis]
kind = "dynamic"
end_time = 1.0
time_step = 0.02
[[history]]
name = "tip"
at = "flyer.end"
quantities = ["position", "velocity"]
"""

PLAN = """deck = "swinger.toml"
[vary]
"parameters.EI" = [100, 200, 500]
"analysis.time_step" = [0.05, 0.02]
[collect]
lowest = { history = "tip", quantity = "position", component = "z", take = "min" }
mean_z = { history = "tip", quantity = "position", component = "z", take = "mean" }
rms_z = { history = "tip", quantity = "position", component = "z", take = "rms" }
half_z = { history = "tip", quantity = "position", component = "z", at = 0.5 }
speed = { history = "tip", quantity = "velocity", component = "magnitude", take = "final" }
energy = { ledger = "energy_error", take = "max_abs" }
"""

# The second case cannot converge.
FAILING = """deck = "swinger.toml"
[vary]
"gravity" = [[0, 0, -9.81], [0, 0, -1e5], [0, 0, -5]]
[collect]
lowest = { history = "tip", quantity = "position", component = "z", take = "min" }
"""

# Cases of some seconds, that go on until they are stopped.
ENDLESS = """deck = "swinger.toml"
[vary]
"parameters.EI" = [100, 200]
"analysis.end_time" = [10000.0]
"gravity" = [[0, 0, -0.001]]
[keep]
results = "none"
"""

MESH = """$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
1 1 "beam"
$EndPhysicalNames
$Entities
2 1 0 0
1 0 0 0 0
2 10 0 0 0
1 0 0 0 10 0 0 1 1 2 1 -2
$EndEntities
$Nodes
3 3 1 3
0 1 0 1
1
0 0 0
0 2 0 1
2
10 0 0
1 1 0 1
3
5 0 0
$EndNodes
$Elements
1 2 1 2
1 1 1 2
1 1 3
2 3 2
$EndElements
"""

# Many cases of some milliseconds.
MANY = """deck = "swinger.toml"
combine = "latin-hypercube"
count = {count}
seed = 7
[vary]
"parameters.EI" = {{ uniform = {{ from = 100, to = 500 }} }}
[collect]
lowest = {{ history = "tip", quantity = "position", component = "z", take = "min" }}
[keep]
results = "none"
"""

COUNT = 60 if SANITIZED else 300


class BatchTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("swinger.toml", SWINGER)

    def rows(self, folder="plan", name="index.csv"):
        with open(self.folder / folder / name, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def table(self, folder):
        """The table without what differs from run to run."""
        return [{key: value for key, value in row.items() if key != "seconds"} for row in self.rows(folder)]

    def start(self, *arguments):
        """A batch in the background, in a process group of its own."""
        process = subprocess.Popen([GXROD, "batch", *arguments], cwd=self.folder, text=True, start_new_session=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()

    def wait_for(self, condition, what):
        for _ in range(1200):
            result = condition()
            if result:
                return result
            time.sleep(0.05)
        return self.fail(f"waited for {what}")

    def workers_of(self, process):
        path = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children")
        return [int(word) for word in path.read_text().split()]

    def wait_for_workers(self, process, count):
        return self.wait_for(lambda: len(self.workers_of(process)) >= count and self.workers_of(process), "workers")

    def count_lines(self, folder):
        path = self.folder / folder / "index.csv"
        return path.read_text().count("\n") if path.exists() else 0


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

    def test_index_for_programs_has_the_same(self):
        self.write("plan.toml", PLAN)
        self.gxrod("batch", "plan.toml", "--quiet")
        rows = self.rows()
        with h5py.File(self.folder / "plan" / "index.h5") as file:
            self.assertEqual(file.attrs["plan_text"], PLAN)
            self.assertEqual(file.attrs["cases"], 6)
            self.assertEqual(file.attrs["title"], "A swinging rod")
            self.assertEqual(list(file["case"]), [1, 2, 3, 4, 5, 6])
            np.testing.assert_array_equal(file["parameters/parameters.EI"], [100, 100, 200, 200, 500, 500])
            for name in ("lowest", "mean_z", "rms_z", "half_z", "speed", "energy"):
                np.testing.assert_array_equal(file["collected"][name], [float(row[name]) for row in rows])
            self.assertIn("lowest", file["collected"])
            self.assertEqual(file["collected/lowest"].attrs["description"], "least z of position of tip")
            for name in ("steps", "newton_iterations", "rejected_steps"):
                np.testing.assert_array_equal(file[name], [int(row[name]) for row in rows])
            for name in ("status", "reason", "results", "warning"):
                self.assertEqual([text.decode() for text in file[name]], [row[name] for row in rows])
            np.testing.assert_array_equal(file["time"], [float(row["time"]) for row in rows])
            self.assertTrue((file["seconds"][:] > 0).all())

    def test_a_case_is_what_a_run_is(self):
        self.write("plan.toml", PLAN)
        self.gxrod("batch", "plan.toml", "--quiet")
        self.gxrod("run", "swinger.toml", "--set", "parameters.EI=200", "--set", "analysis.time_step=0.02",
                   "-o", "alone.vtkhdf", "--quiet")
        self.assertEqual(self.values_of("alone.vtkhdf"), self.values_of("plan/cases/0004.vtkhdf"))

    def values_of(self, name):
        """The bytes of every dataset."""
        values = {}
        with h5py.File(self.folder / name) as file:
            file.visititems(lambda path, item: values.update({path: np.asarray(item[()]).tobytes()})
                            if isinstance(item, h5py.Dataset) and item.dtype.kind in "fiu" else None)
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
        self.assertIn("6 cases read and found right, 6 to run into plan on 3 at a time", done.stdout)
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


class Failures(BatchTest):
    def test_cases_fail_and_the_rest_go_on(self):
        self.write("plan.toml", FAILING)
        done = self.gxrod("batch", "plan.toml", code=3)
        rows = self.rows()
        self.assertEqual([row["status"] for row in rows], ["done", "failed", "done"])
        self.assertRegex(rows[1]["reason"], r"^the step from t = .* failed, even with Δt = ")
        # What there is of it: the steps that were made.
        with h5py.File(self.folder / "plan" / rows[1]["results"]) as file:
            self.assertEqual(file.attrs["status"], "failed")
            self.assertEqual(file["histories/time"][-1], float(rows[1]["time"]))
            self.assertEqual(file["histories/tip/position"][:, 2].min(), float(rows[1]["lowest"]))
            self.assertEqual(len(file["histories/time"]) - 1, int(rows[1]["steps"]))
        self.assertIn("case 2 (gravity = [0, 0, -1e+05]): failed: ", done.stderr)
        self.assertNotIn("Not done:", done.stderr)
        self.assertIn("2 of 3 cases done, 1 not", done.stdout)
        # It stays so, until it is to be tried again.
        done = self.gxrod("batch", "plan.toml", code=3)
        self.assertIn("0 run now", done.stdout)
        self.assertIn("Not done:\n  failed, 1 case (2): the step", done.stderr)
        done = self.gxrod("batch", "plan.toml", "--retry-failed", code=3)
        self.assertIn("1 run now", done.stdout)
        self.assertEqual([row["status"] for row in self.rows()], ["done", "failed", "done"])

    def test_time_limit(self):
        self.write("plan.toml", ENDLESS.replace("[vary]", "time_limit = 0.5\n[vary]").replace('"none"', '"all"'))
        self.gxrod("batch", "plan.toml", "--quiet", code=3)
        for row in self.rows():
            self.assertEqual(row["status"], "time limit")
            self.assertRegex(row["reason"], r"the time limit of 0\.5 s was over at t = ")
            self.assertGreater(float(row["time"]), 0)
            self.assertLess(float(row["seconds"]), 60)
            with h5py.File(self.folder / "plan" / row["results"]) as file:
                self.assertEqual(file.attrs["status"], "interrupted")
                self.assertEqual(file["histories/time"][-1], float(row["time"]))

    def test_time_limit_within_a_step(self):
        self.write("plan.toml", ENDLESS.replace("[vary]", "time_limit = 0.5\n[vary]").replace("[100, 200]", "[100]"))
        process = self.start("plan.toml", "-j", "1")
        os.kill(self.wait_for_workers(process, 1)[0], signal.SIGSTOP)
        self.assertEqual(process.wait(60), 3)
        self.assertEqual([(row["status"], row["reason"]) for row in self.rows()],
                         [("time limit", "the time limit of 0.5 s was over, and the step at hand or the setup took longer "
                           "still; the process was ended")])

    def test_memory_limit(self):
        self.write("plan.toml", """deck = "swinger.toml"
memory_limit = 0.2
[vary]
"rod.flyer.elements" = [4, 200000]
"analysis.end_time" = [0.04]
[keep]
results = "none"
""")
        self.gxrod("batch", "plan.toml", "-j", "1", "--quiet", code=3)
        rows = self.rows()
        self.assertEqual([row["status"] for row in rows], ["done", "out of memory"])
        self.assertEqual(rows[1]["reason"], "more than memory_limit, 0.2 GB")

    def test_a_worker_that_crashes_is_replaced(self):
        self.write("plan.toml", ENDLESS)
        process = self.start("plan.toml", "-j", "2")
        workers = self.wait_for_workers(process, 2)
        os.kill(workers[0], signal.SIGSEGV if not SANITIZED else signal.SIGABRT)
        self.wait_for(lambda: self.count_lines("plan") == 2, "the row of the crashed case")
        os.killpg(process.pid, signal.SIGTERM)
        self.assertEqual(process.wait(60), 130)
        rows = self.rows()
        self.assertEqual([row["status"] for row in rows], ["crashed"])
        self.assertRegex(rows[0]["reason"], "the process was ended by signal (11|6)")

    def test_a_worker_that_is_killed_has_its_case_run_again(self):
        self.write("plan.toml", MANY.format(count=COUNT))
        process = self.start("plan.toml", "-j", "2")
        killed = 0
        while process.poll() is None and killed < 3:
            self.wait_for(lambda lines=self.count_lines("plan"): self.count_lines("plan") > lines + 5
                          or process.poll() is not None, "rows")
            for worker in self.workers_of(process)[:1] if process.poll() is None else []:
                os.kill(worker, signal.SIGKILL)
                killed += 1
        self.assertEqual(process.wait(300), 0)
        self.assertEqual(killed, 3)
        rows = self.rows()
        self.assertEqual([int(row["case"]) for row in rows], list(range(1, COUNT + 1)))
        self.assertEqual({row["status"] for row in rows}, {"done"})

    def test_a_case_whose_worker_is_killed_twice_is_told(self):
        self.write("plan.toml", ENDLESS.replace("[100, 200]", "[100]"))
        process = self.start("plan.toml", "-j", "1")
        first = self.wait_for_workers(process, 1)[0]
        os.kill(first, signal.SIGKILL)
        second = self.wait_for(lambda: [w for w in self.workers_of(process) if w != first], "the next worker")[0]
        os.kill(second, signal.SIGKILL)
        self.assertEqual(process.wait(60), 3)
        self.assertEqual(self.rows()[0]["status"], "crashed")
        self.assertEqual(self.rows()[0]["reason"], "the process was killed twice, perhaps for want of memory")


class Stopping(BatchTest):
    def test_killed_at_any_moment_and_completed(self):
        self.write("plan.toml", MANY.format(count=COUNT))
        self.gxrod("batch", "plan.toml", "-o", "whole", "--quiet")
        kept = {}
        for _ in range(6):
            process = self.start("plan.toml", "-j", "2", "--quiet")
            lines = self.count_lines("plan")
            self.wait_for(lambda lines=lines: self.count_lines("plan") > lines + COUNT // 10
                          or process.poll() is not None, "rows")
            os.kill(process.pid, signal.SIGKILL)
            process.wait()
            rows = {row["case"]: row for row in self.rows() if row["warning"] is not None}
            # Nothing that was written is lost or run again.
            for number, row in kept.items():
                self.assertEqual(rows[number], row)
            kept = rows
        self.gxrod("batch", "plan.toml", "--quiet")
        self.assertEqual(self.table("plan"), self.table("whole"))
        rows = {row["case"]: row for row in self.rows()}
        for number, row in kept.items():
            self.assertEqual(rows[number], row)
        with h5py.File(self.folder / "plan" / "index.h5") as file:
            self.assertEqual(len(file["case"]), COUNT)

    def test_workers_die_with_the_batch(self):
        self.write("plan.toml", ENDLESS)
        process = self.start("plan.toml", "-j", "2")
        workers = self.wait_for_workers(process, 2)
        os.kill(process.pid, signal.SIGKILL)
        process.wait()
        self.wait_for(lambda: not any(self.is_alive(worker) for worker in workers), "the workers' end")

    @staticmethod
    def is_alive(process):
        try:
            return pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
        except FileNotFoundError:
            return False

    def test_interrupted_once_it_finishes_the_cases_at_hand(self):
        self.write("plan.toml", MANY.format(count=COUNT))
        process = self.start("plan.toml", "-j", "2")
        self.wait_for(lambda: self.count_lines("plan") > 5, "rows")
        os.killpg(process.pid, signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertRegex(errors, r"gxrod: ends after the \d cases? at hand; Ctrl-C again leaves them")
        self.assertRegex(errors, r"gxrod: interrupted; \d+ cases not run\. The same command goes on\.")
        rows = self.rows()
        self.assertLess(len(rows), COUNT)
        self.assertEqual({row["status"] for row in rows}, {"done"})
        self.gxrod("batch", "plan.toml", "--quiet")
        self.assertEqual(len(self.rows()), COUNT)

    def test_interrupted_twice_it_leaves_them(self):
        self.write("plan.toml", ENDLESS)
        process = self.start("plan.toml", "-j", "2")
        self.wait_for_workers(process, 2)
        os.killpg(process.pid, signal.SIGINT)
        time.sleep(0.5)
        self.assertIsNone(process.poll())
        os.killpg(process.pid, signal.SIGINT)
        self.assertEqual(process.wait(60), 130)
        self.assertEqual(self.rows(), [])

    def test_two_batches_in_one_folder(self):
        self.write("plan.toml", ENDLESS)
        process = self.start("plan.toml", "-j", "1")
        self.wait_for_workers(process, 1)
        done = self.gxrod("batch", "plan.toml", code=4)
        self.assertEqual(done.stderr, "gxrod: plan: another gxrod batch is running in it "
                                      "(-o takes another folder, --only other cases)\n")
        self.gxrod("batch", "plan.toml", "--only", "2..2", code=4)
        os.killpg(process.pid, signal.SIGTERM)
        self.assertEqual(process.wait(60), 130)

    def test_killed_while_it_throws_away(self):
        self.write("plan.toml", PLAN)
        for delay in np.linspace(0, 0.02, 8):
            self.gxrod("batch", "plan.toml", "--quiet", "--force")
            process = self.start("plan.toml", "--force", "--quiet", "-j", "1")
            self.wait_for(lambda: not (self.folder / "plan" / "index.h5").exists() or process.poll() is not None,
                          "the table's end")
            time.sleep(delay)
            process.kill()
            process.wait()
            self.gxrod("batch", "plan.toml", "--quiet")
            self.assertEqual(len(self.rows()), 6)

    def test_what_a_kill_leaves_is_taken_away(self):
        self.write("plan.toml", PLAN)
        (self.folder / "plan" / "cases").mkdir(parents=True)
        for name in ("lock", "batch.json.123", "index.csv.99", "index.h5.5"):
            self.write("plan/" + name, "torn")
        self.gxrod("batch", "plan.toml", "--quiet")
        self.assertEqual(sorted(os.listdir(self.folder / "plan")),
                         ["batch.json", "cases", "index.csv", "index.h5", "lock"])

    def test_interrupted_at_its_last_cases_it_is_complete(self):
        self.write("plan.toml", PLAN.replace("time_step\" = [0.05, 0.02]", "time_step\" = [0.0005]"))
        process = self.start("plan.toml", "-j", "3")
        self.wait_for_workers(process, 3)
        os.killpg(process.pid, signal.SIGINT)
        self.assertEqual(process.wait(120), 0)
        self.assertEqual(len(self.rows()), 3)

    def test_slices_that_begin_together(self):
        self.write("plan.toml", PLAN.replace("[collect]", "[keep]\nresults = \"none\"\n[collect]"))
        for attempt in range(5):
            folder = f"together{attempt}"
            slices = [self.start("plan.toml", "-o", folder, "--only", str(case), "--quiet") for case in range(1, 7)]
            for process in slices:
                self.assertEqual(process.wait(120), 0, process.stderr.read())
            self.assertEqual(len(self.rows(folder)), 6)

    def test_slices_share_a_folder(self):
        self.write("plan.toml", MANY.format(count=40))
        self.gxrod("batch", "plan.toml", "-o", "whole", "--quiet")
        slices = [self.start("plan.toml", "--only", part, "-j", "1", "--quiet")
                  for part in ("1..10", "11..25", "26..40")]
        for process in slices:
            self.assertEqual(process.wait(120), 0)
        self.assertEqual(self.table("plan"), self.table("whole"))
        self.assertFalse((self.folder / "plan" / "parts").exists())
        done = self.gxrod("batch", "plan.toml")
        self.assertIn("40 of 40 cases done; 0 run now", done.stdout)

    def test_a_slice_alone_and_then_the_rest(self):
        self.write("plan.toml", PLAN)
        done = self.gxrod("batch", "plan.toml", "--only", "5")
        self.assertIn("1 of 1 case done", done.stdout)
        self.gxrod("batch", "plan.toml", "--only", "2..3", "--quiet")
        self.assertEqual([row["case"] for row in self.rows()], ["2", "3", "5"])
        done = self.gxrod("batch", "plan.toml")
        self.assertIn("6 of 6 cases done; 3 run now", done.stdout)


class Faults(BatchTest):
    def test_nothing_runs_when_a_case_is_wrong(self):
        self.write("plan.toml", PLAN.replace("parameters.EI", "parameters.EJ"))
        done = self.gxrod("batch", "plan.toml", code=2)
        self.assertEqual(done.stderr, 'plan.toml:3:1: vary."parameters.EJ": the deck has no parameter "EJ"; '
                                      'it has EI\n')
        self.assertFalse((self.folder / "plan").exists())

    def test_a_changed_plan_needs_force(self):
        self.write("plan.toml", PLAN)
        self.gxrod("batch", "plan.toml", "--quiet")
        self.write("plan.toml", PLAN.replace("[100, 200, 500]", "[100, 300]"))
        done = self.gxrod("batch", "plan.toml", code=2)
        self.assertIn('plan.toml:3:19: vary."parameters.EI": the batch in plan has [100, 200, 500]', done.stderr)
        self.gxrod("batch", "plan.toml", "--quiet", "--force")
        self.assertEqual(len(self.rows()), 4)

    def test_arguments(self):
        self.write("plan.toml", PLAN)
        for arguments, message in (
                (("plan.toml", "swinger.toml"), "plan.toml is a plan; expected one plan, or decks only"),
                (("plan.toml", "--only", "0..3"), "--only 0..3: expected I..J, the first and the last case to run, "
                                                  "from 1 to 6"),
                (("plan.toml", "--only", "3..2"), "--only 3..2: expected I..J"),
                (("plan.toml", "--only", "3..7"), "--only 3..7: expected I..J"),
                (("plan.toml", "--only", "1-3"), "--only 1-3: expected I..J"),
                (("plan.toml", "-j", "0"), "--jobs"),
                ((), "FILES is required")):
            with self.subTest(arguments):
                self.assertIn(message, self.gxrod("batch", *arguments, code=2).stderr)
        self.assertIn("nowhere.toml: cannot be read", self.gxrod("batch", "nowhere.toml", code=4).stderr)
        for verb in ("run", "check"):
            self.assertEqual(self.gxrod(verb, "plan.toml", code=2).stderr,
                             "plan.toml: is the plan of a batch, not a deck; gxrod batch runs it\n")

    def test_force_goes_with_the_whole_batch(self):
        self.write("plan.toml", PLAN)
        done = self.gxrod("batch", "plan.toml", "--only", "1..2", "--force", code=2)
        self.assertIn("--only excludes --force", done.stderr)

    def test_a_mesh_that_changes_is_noticed(self):
        self.write("line.msh", MESH)
        self.write("meshed.toml", SWINGER.replace("line = { from = [0, 0, 0], to = [10, 0, 0] }\nelements = 4\n",
                                                  "mesh = { file = \"line.msh\", group = \"beam\" }\n"))
        self.write("plan.toml", PLAN.replace("swinger.toml", "meshed.toml").replace("[100, 200, 500]", "[100, 200]"))
        self.gxrod("batch", "plan.toml", "--quiet")
        self.write("line.msh", MESH.replace("\n10 0 0\n", "\n12 0 0\n"))
        done = self.gxrod("batch", "plan.toml", code=4)
        self.assertIn("meshed.toml: its mesh line.msh is another one than that of the batch in plan", done.stderr)
        # While it runs.
        self.write("plan.toml", ENDLESS.replace("swinger.toml", "meshed.toml").replace("[100, 200]", "[100, 200, 300]")
                   .replace("[vary]", "time_limit = 1\n[vary]"))
        process = self.start("plan.toml", "-j", "1", "-o", "running")
        self.wait_for_workers(process, 1)
        time.sleep(0.3)
        self.write("line.msh", MESH)
        self.assertEqual(process.wait(60), 4)
        self.assertRegex(process.stderr.read(), r"gxrod: running: the batch ends at case 2, which is left to be run: "
                                                r"meshed.toml: its mesh line.msh has changed since the batch began")
        self.assertEqual([row["case"] for row in self.rows("running")], ["1"])

    def test_results_that_cannot_be_written_are_not_the_cases_fault(self):
        self.write("plan.toml", PLAN)
        limit = "ulimit -f 200; exec \"$0\" batch plan.toml --quiet -j 1"
        done = subprocess.run(["bash", "-c", limit, GXROD], cwd=self.folder, text=True, capture_output=True, check=False,
                              timeout=300)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("gxrod: plan: the batch ends at case 1, which is left to be run: plan/cases/0001.vtkhdf: ",
                      done.stderr)
        self.gxrod("batch", "plan.toml", "--quiet")
        self.assertEqual({row["status"] for row in self.rows()}, {"done"})

    def test_nobody_listens(self):
        self.write("plan.toml", FAILING)
        for closing in (">&- 2>&-", "<&- >&- 2>&-"):
            done = subprocess.run(["bash", "-c", f"exec \"$0\" batch plan.toml --force {closing}", GXROD],
                                  cwd=self.folder, timeout=120, check=False)
            self.assertEqual(done.returncode, 3)
            self.assertEqual(len(self.rows()), 3)
            self.assertEqual((self.folder / "plan" / "lock").read_text(), "")
        read, write = os.pipe()
        os.close(read)
        done = subprocess.run([GXROD, "batch", "plan.toml", "--force"], cwd=self.folder, timeout=120, check=False,
                              stdout=write, stderr=write)
        os.close(write)
        self.assertEqual(done.returncode, 3)
        self.assertEqual(len(self.rows()), 3)

    def test_more_workers_than_cases(self):
        self.write("plan.toml", PLAN)
        self.gxrod("batch", "plan.toml", "-j", "4096", "--quiet")
        self.assertEqual({row["status"] for row in self.rows()}, {"done"})

    def test_a_folder_with_other_things_is_left_alone(self):
        self.write("plan.toml", PLAN)
        (self.folder / "plan").mkdir()
        self.write("plan/precious.txt", "mine")
        for force in ((), ("--force",)):
            done = self.gxrod("batch", "plan.toml", *force, code=4)
            self.assertEqual(done.stderr,
                             "gxrod: plan: is not empty and holds no batch (-o takes another folder)\n")
        self.assertEqual((self.folder / "plan" / "precious.txt").read_text(), "mine")

    def test_force_takes_away_what_is_the_batchs_only(self):
        self.write("plan.toml", PLAN)
        self.gxrod("batch", "plan.toml", "--quiet")
        self.write("plan/precious.txt", "mine")
        self.gxrod("batch", "plan.toml", "--quiet", "--force")
        self.assertEqual((self.folder / "plan" / "precious.txt").read_text(), "mine")

    def test_a_table_that_cannot_be_written_ends_the_batch(self):
        self.write("plan.toml", MANY.format(count=COUNT))
        limit = "ulimit -f 8; exec \"$0\" batch plan.toml --quiet"
        done = subprocess.run(["bash", "-c", limit, GXROD], cwd=self.folder, text=True, capture_output=True, check=False,
                              timeout=300)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertRegex(done.stderr, r"gxrod: plan/index\.(csv|h5)")
        rows = self.rows()
        self.assertGreater(len(rows), 10)
        self.gxrod("batch", "plan.toml", "--quiet")
        self.assertEqual(len(self.rows()), COUNT)
        again = {row["case"]: row for row in self.rows()}
        for row in rows:
            self.assertEqual(again[row["case"]], row)


if __name__ == "__main__":
    unittest.main()
