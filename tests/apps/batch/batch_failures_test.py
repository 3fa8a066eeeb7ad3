"""`gxrod batch`: cases that fail do not stop the others."""

import os
import signal
import unittest

import h5py

from batches import COUNT, ENDLESS, FAILING, MANY, SANITIZED, BatchTest


class Failures(BatchTest):
    def test_cases_fail_and_the_rest_continue(self):
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
                         [("time limit", "the time limit of 0.5 s was over, and the current step or the setup took longer "
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
        count = 5 * COUNT
        self.write("plan.toml", MANY.format(count=count))
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
        self.assertEqual([int(row["case"]) for row in rows], list(range(1, count + 1)))
        self.assertEqual({row["status"] for row in rows}, {"done"})

    def test_a_case_whose_worker_is_killed_twice_is_reported(self):
        self.write("plan.toml", ENDLESS.replace("[100, 200]", "[100]"))
        process = self.start("plan.toml", "-j", "1")
        first = self.wait_for_workers(process, 1)[0]
        os.kill(first, signal.SIGKILL)
        second = self.wait_for(lambda: [w for w in self.workers_of(process) if w != first], "the next worker")[0]
        os.kill(second, signal.SIGKILL)
        self.assertEqual(process.wait(60), 3)
        self.assertEqual(self.rows()[0]["status"], "crashed")
        self.assertEqual(self.rows()[0]["reason"], "the process was killed twice, perhaps for lack of memory")


if __name__ == "__main__":
    unittest.main()
