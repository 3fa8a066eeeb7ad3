"""`gxrod batch`: faults of users, folders and machines; nothing is lost."""

import os
import subprocess
import time
import unittest

from batches import COUNT, ENDLESS, FAILING, MANY, MESH, PLAN, SANITIZED, SWINGER, BatchTest
from program import GXROD


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
        # Before it has a folder, it is another process that reads the mesh.
        self.wait_for((self.folder / "running").exists, "the folder")
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

    def test_closed_standard_streams(self):
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

    def test_a_folder_that_cannot_be_made(self):
        self.write("plan.toml", PLAN)
        done = self.gxrod("batch", "plan.toml", "-o", "plan.toml/x", code=4)
        self.assertEqual(done.stderr, "gxrod: plan.toml/x: cannot be created (Not a directory)\n")

    @unittest.skipIf(SANITIZED, "the sanitizers need descriptors themselves")
    def test_no_process_can_be_had(self):
        self.write("plan.toml", PLAN)
        self.gxrod("batch", "plan.toml", "--only", "1", "--quiet")
        # Standard streams, the two locks and the table: no channel to a worker.
        limit = "ulimit -n 6; exec \"$0\" batch plan.toml --quiet"
        done = subprocess.run(["bash", "-c", limit, GXROD], cwd=self.folder, text=True, capture_output=True, check=False,
                              timeout=300)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertEqual(done.stderr, "gxrod: plan: no process can be started for its cases: making a channel: "
                                      "Too many open files (a smaller -j needs fewer)\n")
        self.gxrod("batch", "plan.toml", "--quiet")
        self.assertEqual(len(self.rows()), 6)

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
