"""`gxrod batch`: stopped, killed, resumed, divided."""

import os
import pathlib
import signal
import time
import unittest

import numpy as np

from batches import COUNT, ENDLESS, MANY, PLAN, BatchTest


class Stopping(BatchTest):
    def test_killed_at_any_moment_and_completed(self):
        count = 5 * COUNT
        self.write("plan.toml", MANY.format(count=count))
        self.gxrod("batch", "plan.toml", "-o", "whole", "--quiet")
        kept = {}
        ends = []
        for _ in range(6):
            process = self.start("plan.toml", "-j", "2", "--quiet")
            lines = self.count_lines("plan")
            self.wait_for(lambda lines=lines: self.count_lines("plan") > lines + COUNT // 10
                          or process.poll() is not None, "rows")
            process.kill()
            ends.append(process.wait())
            rows = {row["case"]: row for row in self.rows() if row["warning"] is not None}
            # Nothing that was written is lost or run again.
            for number, row in kept.items():
                self.assertEqual(rows[number], row)
            kept = rows
        self.assertIn(-signal.SIGKILL, ends)
        self.gxrod("batch", "plan.toml", "--quiet")
        self.assertEqual(self.table("plan"), self.table("whole"))
        rows = {row["case"]: row for row in self.rows()}
        for number, row in kept.items():
            self.assertEqual(rows[number], row)
        self.assertEqual(len(rows), count)

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
        count = 5 * COUNT
        self.write("plan.toml", MANY.format(count=count))
        process = self.start("plan.toml", "-j", "2")
        self.wait_for(lambda: self.count_lines("plan") > 5, "rows")
        os.killpg(process.pid, signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertRegex(errors, r"gxrod: ends after the running \d cases?; Ctrl-C again leaves them")
        self.assertRegex(errors, r"gxrod: interrupted; \d+ cases left to run\. The same command resumes the batch\.")
        rows = self.rows()
        self.assertLess(len(rows), count)
        self.assertEqual({row["status"] for row in rows}, {"done"})
        self.gxrod("batch", "plan.toml", "--quiet")
        self.assertEqual(len(self.rows()), count)

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

    def test_what_is_left_of_what_was_to_be_tried_again(self):
        self.write("plan.toml", ENDLESS.replace("[vary]", "time_limit = 0.3\n[vary]"))
        self.gxrod("batch", "plan.toml", "--quiet", code=3)
        self.write("plan.toml", ENDLESS)
        process = self.start("plan.toml", "-j", "1", "--retry-failed")
        self.wait_for_workers(process, 1)
        os.killpg(process.pid, signal.SIGTERM)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("gxrod: interrupted; 2 cases left to run. The same command resumes the batch.", errors)
        self.assertEqual([row["status"] for row in self.rows()], ["time limit"] * 2)

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
            self.wait_for(lambda: not (self.folder / "plan" / "index.csv").exists() or process.poll() is not None,
                          "the table's end")
            time.sleep(delay)
            process.kill()
            process.wait()
            self.gxrod("batch", "plan.toml", "--quiet")
            self.assertEqual(len(self.rows()), 6)

    def test_what_a_kill_leaves_is_taken_away(self):
        self.write("plan.toml", PLAN)
        (self.folder / "plan" / "cases").mkdir(parents=True)
        for name in ("lock", "batch.json.123", "index.csv.99"):
            self.write("plan/" + name, "torn")
        self.gxrod("batch", "plan.toml", "--quiet")
        self.assertEqual(sorted(os.listdir(self.folder / "plan")),
                         ["batch.json", "cases", "index.csv", "lock"])

    def test_interrupted_at_its_last_cases_it_is_complete(self):
        # Three cases of a second each, that all are seen at once.
        self.write("plan.toml", PLAN.replace("\"analysis.time_step\" = [0.05, 0.02]", "\"analysis.end_time\" = [30]\n"
                                             "\"analysis.time_step\" = [0.0005]"))
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


if __name__ == "__main__":
    unittest.main()
