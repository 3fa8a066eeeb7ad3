"""`gxrod batch --slurm` and `--gather` with a real Slurm: an array job, one that is cancelled, a node that dies."""

import collections
import csv
import json
import re
import shlex
import subprocess
import tempfile
import unittest

from program import GXROD, SOURCE, SPINNING_BODY, ProgramTest
from slurm_cluster import SlurmCluster, missing_commands

QUICK = 200  # steps of a case of some milliseconds
SLOW = 60000  # of a third of a second: what is done to a task meets it before its last case

PLAN = """deck = "body.toml"
[vary]
"parameters.torque" = {{ from = 0.1, to = 1.6, count = 16 }}
"analysis.steps" = [{steps}]
[collect]
spin = {{ history = "spin", quantity = "angular_velocity", component = "x", take = "final" }}
[keep]
results = "none"
"""


def setUpModule():
    missing = missing_commands()
    if missing:
        raise unittest.SkipTest(f"no Slurm on this machine: {', '.join(missing)}; apt-get install slurm-wlm munge")
    folder = tempfile.TemporaryDirectory(prefix="gxrod-slurm-")
    unittest.addModuleCleanup(folder.cleanup)
    global cluster
    cluster = SlurmCluster(folder.name)
    unittest.addModuleCleanup(cluster.stop)
    cluster.start()


class SlurmTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("body.toml", SPINNING_BODY)
        self.addCleanup(self.cancel_all)

    def cancel_all(self):
        cluster.call("scancel", "--user", cluster.user)
        self.wait_for_empty_queue()

    def batch(self, *arguments, code=0):
        return self.gxrod("batch", *arguments, code=code, env=cluster.environment)

    def rows(self, folder="sweep"):
        """All rows that the folder has, those of parts included: a list for each case."""
        rows = collections.defaultdict(list)
        for file in [self.folder / folder / "index.csv", *(self.folder / folder / "parts").glob("*.csv")]:
            if not file.exists():
                continue
            for row in csv.DictReader(file.read_text().splitlines()):
                rows[int(row["case"])].append(row)
        return rows

    def table(self, folder="sweep"):
        with open(self.folder / folder / "index.csv", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def assert_complete(self, folder="sweep", cases=16):
        table = self.table(folder)
        self.assertEqual([int(row["case"]) for row in table], list(range(1, cases + 1)))
        self.assertEqual({row["status"] for row in table}, {"done"})
        self.assertFalse((self.folder / folder / "parts").exists())

    def jobs(self, folder="sweep"):
        return json.loads((self.folder / folder / "slurm" / "jobs.json").read_text())["jobs"]

    def queue(self):
        return cluster.call("squeue", "-h", "-r", "-o", "%i %T %N").splitlines()

    def wait_for_empty_queue(self):
        cluster.wait_until(lambda: not self.queue(), "all jobs have ended")

    def wait_for_rows(self, first, last, count=1):
        cluster.wait_until(lambda: sum(first <= case <= last for case in self.rows()) >= count,
                           f"{count} of the cases {first} to {last} have a row")


class Submitting(SlurmTest):
    def test_an_array_job_makes_the_table_of_a_batch_on_one_machine(self):
        """In a folder whose name sbatch, Slurm and the shell each could misread."""
        plan, folder = "my sweep.toml", "100%j of it's #1"
        self.write(plan, PLAN.format(steps=QUICK))
        self.batch(plan, "-o", "here")
        told = self.batch(plan, "-o", folder, "--slurm", "--tasks", "4", "--", "-c", "1", "-J", "mine").stdout
        [job] = self.jobs(folder)
        self.assertIn(f"job {job['id']}: 16 cases in 4 tasks", told)
        self.assertEqual(job["slices"], [[1, 4], [5, 8], [9, 12], [13, 16]])
        self.wait_for_empty_queue()
        self.assertIn("16 of 16 cases done", self.batch(plan, "-o", folder, "--gather").stdout)
        self.assert_complete(folder)
        here, there = ([{**row, "seconds": ""} for row in self.table(name)] for name in ("here", folder))
        self.assertEqual(here, there)
        outputs = {path.name: path.read_text() for path in (self.folder / folder / "slurm").glob("*.out")}
        self.assertEqual(set(outputs), {f"{job['id']}_{task}.out" for task in range(1, 5)})
        self.assertIn("cases 1..4 on n", outputs[f"{job['id']}_1.out"])
        self.assertIn("4 of 4 cases done", outputs[f"{job['id']}_1.out"])
        self.assertEqual({text.split(" on ")[1].split(",")[0] for text in outputs.values()}, {"n1", "n2"})
        # Nothing is left to do.
        self.assertIn("nothing to submit", self.batch(plan, "-o", folder, "--slurm").stdout)
        self.assertEqual(len(self.jobs(folder)), 1)

    def test_the_commands_of_the_page(self):
        page = (SOURCE / "docs" / "howto" / "cluster.md").read_text()
        page = re.sub(r"```bash.*?```", "", page, flags=re.DOTALL)
        commands = re.findall(r"^(gxrod batch sweep.toml .*)$", page, re.MULTILINE)
        self.assertEqual(len(commands), 5)
        self.write("sweep.toml", PLAN.format(steps=QUICK).replace("count = 16", "count = 30"))
        for command in commands:
            done = subprocess.run([GXROD, *shlex.split(command)[1:]], cwd=self.folder, env=cluster.environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60)
            self.assertIn(done.returncode, (0, 3) if "--gather" in command else (0,), done.stdout)
        self.wait_for_empty_queue()
        self.batch("sweep.toml", "--gather")
        self.assert_complete(cases=30)

    def test_what_sbatch_refuses_is_reported_and_not_recorded(self):
        self.write("sweep.toml", PLAN.format(steps=QUICK))
        done = self.batch("sweep.toml", "--slurm", "--", "--partition", "moon", code=4)
        self.assertIn("sbatch: refused the job: exit code 1", done.stderr)
        self.assertIn("invalid partition specified: moon", done.stderr)
        self.assertEqual(list((self.folder / "sweep" / "slurm").glob("*.sbatch")), [])
        self.assertEqual(self.jobs(), [])
        self.assertEqual(self.queue(), [])

    def test_cases_that_a_job_has_are_not_submitted_again(self):
        self.write("sweep.toml", PLAN.format(steps=QUICK))
        self.batch("sweep.toml", "--only", "1..3")
        self.batch("sweep.toml", "--slurm", "--tasks", "2", "--", "--hold")
        told = self.batch("sweep.toml", "--slurm", code=3).stdout
        self.assertIn("Nothing was submitted.", told)
        self.assertIn("2 PENDING (JobHeldUser)", told)
        self.assertIn("13 cases not done yet", told)
        told = self.batch("sweep.toml", "--gather", code=3).stdout
        self.assertIn("3 of 16 cases done, 13 missing", told)
        self.assertEqual([job["slices"] for job in self.jobs()], [[[4, 9], [10, 16]]])
        told = self.batch("sweep.toml", "--slurm", "--force", code=4).stderr
        self.assertIn(f"scancel {self.jobs()[0]['id']}", told)
        cluster.call("scontrol", "release", self.jobs()[0]["id"])
        self.wait_for_empty_queue()
        self.assert_complete()


class Failing(SlurmTest):
    def test_a_cancelled_task_is_completed_by_gather(self):
        self.write("sweep.toml", PLAN.format(steps=SLOW))
        self.batch("sweep.toml", "--slurm", "--tasks", "2")
        first = self.jobs()[0]["id"]
        self.wait_for_rows(1, 8, 2)
        cluster.call("scancel", f"{first}_1")
        cluster.wait_until(lambda: not any(line.startswith(f"{first}_1 ") for line in self.queue()), "the task has ended")
        before = self.rows()
        missing = [case for case in range(1, 9) if case not in before]
        self.assertNotEqual(missing, [])
        self.batch("sweep.toml", "--gather", code=3)
        again = self.jobs()[1]
        self.assertEqual([case for first, last in again["slices"] for case in range(first, last + 1)], missing)
        self.wait_for_empty_queue()
        self.batch("sweep.toml", "--gather")
        self.assert_complete()
        self.assertEqual(len(self.jobs()), 2)
        table = self.table()
        for case, rows in before.items():  # none was run again
            self.assertEqual(table[case - 1], rows[0])

    def run_with_a_node_that_dies(self, *options):
        """Two tasks, one on each node; n2 dies. Returns the number of the job and the rows at that time."""
        self.write("sweep.toml", PLAN.format(steps=SLOW))
        self.addCleanup(cluster.revive_node, "n2")
        self.batch("sweep.toml", "--slurm", "--tasks", "2", "--", "-c", "2", *options)
        self.wait_for_rows(1, 8)
        self.wait_for_rows(9, 16)
        cluster.kill_node("n2")
        before = self.rows()
        cluster.call("scontrol", "update", "nodename=n2", "state=down", "reason=test")
        return self.jobs()[0]["id"], before

    def assert_none_was_run_again(self, before):
        table = self.table()
        for case, rows in before.items():
            self.assertEqual(table[case - 1], rows[-1])

    def test_a_task_of_a_dead_node_is_completed_by_gather(self):
        _, before = self.run_with_a_node_that_dies("--no-requeue")
        self.wait_for_empty_queue()
        self.batch("sweep.toml", "--gather", code=3)
        self.assertEqual(self.jobs()[1]["options"], ["-c", "2", "--no-requeue"])
        self.wait_for_empty_queue()
        self.batch("sweep.toml", "--gather")
        self.assert_complete()
        self.assert_none_was_run_again(before)

    def test_a_task_that_slurm_restarts_continues(self):
        job, before = self.run_with_a_node_that_dies("--requeue")
        cluster.wait_until(lambda: any(line.startswith(f"{job}_2 PENDING") for line in self.queue()), "the task waits again")
        told = self.batch("sweep.toml", "--gather", code=3).stdout
        self.assertIn("1 PENDING", told)
        self.assertEqual(len(self.jobs()), 1)
        # Slurm waits for two minutes, and can set them again while it clears up after the node.
        def hurry():
            cluster.call("scontrol", "update", f"jobid={job}_2", "starttime=now", check=False)
            return not self.queue()

        cluster.wait_until(hurry, "all jobs have ended")
        output = (self.folder / "sweep" / "slurm" / f"{job}_2.out").read_text()
        self.assertEqual(output.count("cases 9..16 on n"), 2)
        self.batch("sweep.toml", "--gather")
        self.assert_complete()
        self.assert_none_was_run_again(before)

    def test_what_failed_is_submitted_once_more(self):
        # A torque a billion times larger turns the body by more than half a turn in the shortest step.
        self.write("sweep.toml", PLAN.format(steps=QUICK).replace("{ from = 0.1, to = 1.6, count = 16 }",
                                                                  "[1, 2, 1e12, 3]"))
        self.batch("sweep.toml", "--slurm", "--tasks", "2")
        self.wait_for_empty_queue()
        done = self.batch("sweep.toml", "--gather", code=3)
        self.assertIn("3 of 4 cases done, 1 not", done.stdout)
        self.assertIn("1 case (3): ", done.stderr)
        self.assertIn("JobState=FAILED", cluster.call("scontrol", "show", "job", f"{self.jobs()[0]['id']}_2"))
        self.assertEqual(self.jobs()[1]["slices"], [[3, 3]])
        self.assertEqual(self.jobs()[1]["retried"], [[3, 3]])
        self.wait_for_empty_queue()
        [text] = [path.read_text() for path in (self.folder / "sweep" / "slurm").glob(f"{self.jobs()[1]['id']}_*.out")]
        self.assertIn("1 run now", text)
        self.assertIn("1 case still not done after a repeated job", self.batch("sweep.toml", "--gather", code=3).stdout)
        self.assertEqual(len(self.jobs()), 2)
        self.batch("sweep.toml", "--gather", "--retry-failed", code=3)
        self.assertEqual(len(self.jobs()), 3)


if __name__ == "__main__":
    unittest.main()
