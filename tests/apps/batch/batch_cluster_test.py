"""`gxrod batch --slurm` and `--gather`: what they say and ask, with commands in Slurm's place. tests/slurm has a real one."""

import json
import os
import re
import subprocess
import unittest

from program import GXROD, SOURCE, SPINNING_BODY, ProgramTest

PLAN = """deck = "body.toml"
[vary]
"parameters.torque" = { from = 0.1, to = 1.2, count = 12 }
[keep]
results = "none"
"""


class ClusterTest(ProgramTest):
    """Commands that record how they were called, and answer as set."""

    def setUp(self):
        super().setUp()
        self.write("body.toml", SPINNING_BODY)
        self.write("sweep.toml", PLAN)
        (self.folder / "bin").mkdir()
        self.environment = {**os.environ, "PATH": f"{self.folder}/bin"}

    def answer(self, command, output="", errors="", code=0):
        path = self.folder / "bin" / command
        path.write_text(f"#!/bin/sh\necho \"$@\" >> {path}.calls\necho '{output}'\necho '{errors}' >&2\nexit {code}\n")
        path.chmod(0o755)

    def calls(self, command):
        return (self.folder / "bin" / f"{command}.calls").read_text().splitlines()

    def batch(self, *arguments, code=0):
        return self.gxrod("batch", *arguments, code=code, env=self.environment)

    def jobs(self, folder="sweep"):
        return json.loads((self.folder / folder / "slurm" / "jobs.json").read_text())["jobs"]


class WithoutSlurm(ClusterTest):
    def test_submitting_says_so(self):
        self.assertIn("sbatch: there is no such command (Slurm's commands are expected on this machine)",
                      self.batch("sweep.toml", "--slurm", code=4).stderr)
        self.assertEqual(self.jobs(), [])

    def test_gathering_completes_the_table_of_slices(self):
        self.assertIn("sweep: holds no batch yet", self.batch("sweep.toml", "--gather", code=4).stderr)
        self.batch("sweep.toml", "--only", "1..4")
        part = self.folder / "sweep" / "parts" / "6-7.csv"
        part.parent.mkdir()
        header, *rows = (self.folder / "sweep" / "index.csv").read_text().splitlines()
        part.write_text(f"{header}\n6{rows[0][1:]}\n7,half a ro")
        done = self.batch("sweep.toml", "--gather", code=3)
        self.assertIn("5 of 12 cases done, 7 missing", done.stdout)
        self.assertIn("nothing was submitted: there is no sbatch on this machine", done.stderr)
        self.assertFalse(part.exists())
        self.batch("sweep.toml")
        self.assertIn("12 of 12 cases done", self.batch("sweep.toml", "--gather").stdout)


class AnotherScheduler(ClusterTest):
    def test_the_script_of_the_page(self):
        page = (SOURCE / "docs" / "howto" / "cluster.md").read_text()
        [script] = re.findall(r"```bash\n(.*?)```", page, flags=re.DOTALL)
        self.assertIn("cases=200 tasks=20", script)
        self.write("job.sh", script.replace("cases=200 tasks=20", "cases=12 tasks=5"))
        environment = {**os.environ, "PBS_O_WORKDIR": str(self.folder),
                       "PATH": os.pathsep.join([os.path.dirname(GXROD), os.environ["PATH"]])}
        for task in range(1, 6):
            subprocess.run(["bash", "job.sh"], check=True, stdout=subprocess.DEVNULL, cwd=self.folder,
                           env={**environment, "PBS_ARRAY_INDEX": str(task)})
        self.assertIn("12 of 12 cases done", self.batch("sweep.toml", "--gather").stdout)


class Submitting(ClusterTest):
    def test_options_go_to_sbatch_as_they_are_and_serve_the_next_job_too(self):
        self.answer("sbatch", "17;north")
        self.answer("squeue", "CLUSTER: north")
        told = self.batch("sweep.toml", "-o", "here", "--slurm", "--", "-c", "3", "--comment=a b", "--hold").stdout
        self.assertIn("squeue -M north -j 17", told)
        self.assertIn("gxrod batch sweep.toml -o here --gather", told)
        script = f"{self.folder}/here/slurm/sweep-{{}}.sbatch"
        self.assertEqual(self.calls("sbatch"), [f"--parsable -c 3 --comment=a b --hold {script.format(1)}"])
        self.assertEqual(self.jobs("here")[0]["options"], ["-c", "3", "--comment=a b", "--hold"])
        self.batch("sweep.toml", "-o", "here", "--gather", "--tasks", "4", code=3)
        self.assertEqual(self.calls("squeue"), ["-h -r -j 17 -o %F|%K|%T|%r -M north"])
        self.batch("sweep.toml", "-o", "here", "--gather", "--", code=3)
        self.assertEqual(self.calls("sbatch")[1:], ["--version",
                                                    f"--parsable -c 3 --comment=a b --hold {script.format(2)}",
                                                    "--version", f"--parsable {script.format(3)}"])
        self.assertEqual([len(job["slices"]) for job in self.jobs("here")], [1, 4, 3])

    def test_a_dry_run_shows_the_script_and_leaves_no_trace(self):
        self.answer("sbatch", "17")
        told = self.batch("sweep.toml", "--slurm", "--tasks", "2", "--dry-run", "--", "--mem", "2 G").stdout
        self.assertIn("  [2]=7..12\n", told)
        self.assertIn(f"# sbatch --parsable --mem '2 G' {self.folder}/sweep/slurm/sweep-1.sbatch", told)
        self.assertFalse((self.folder / "sweep").exists())
        self.assertFalse((self.folder / "bin" / "sbatch.calls").exists())

    def test_decks_are_run_by_the_names_they_were_given(self):
        self.write("other.toml", SPINNING_BODY.replace("mass = 2.0", "mass = 3.0"))
        self.answer("sbatch", "17")
        self.batch("body.toml", "other.toml", "-o", "two", "--slurm", "--tasks", "2", "--quiet")
        script = (self.folder / "two" / "slurm" / "two-1.sbatch").read_text()
        self.assertIn(f"cd {self.folder} || exit\n", script)
        self.assertIn(" batch body.toml other.toml \\\n", script)
        self.assertIn("  [2]=2\n", script)

    def test_only_cases_that_are_not_taken_are_submitted(self):
        self.answer("sbatch", "17")
        self.answer("squeue", "17|2|PENDING|Priority")
        self.batch("sweep.toml", "--slurm", "--tasks", "3", "--", "--nice")
        self.answer("sbatch", "18")
        told = self.batch("sweep.toml", "--slurm", "--tasks", "1").stdout
        self.assertIn("Tasks of job 17: 1 PENDING (Priority)\n4 cases not done yet, left to", told)
        self.assertEqual(self.jobs()[1]["slices"], [[1, 4], [9, 12]])
        self.assertEqual([job["options"] for job in self.jobs()], [["--nice"], []])
        told = self.batch("sweep.toml", "--gather", "--dry-run", code=3).stdout
        self.assertIn("8 cases to submit", told)
        self.assertEqual(len(self.jobs()), 2)

    def test_force_waits_for_jobs_of_the_former_batch(self):
        self.answer("sbatch", "17")
        self.answer("squeue", "17|1|RUNNING|None")
        self.batch("sweep.toml", "--slurm")
        self.write("sweep.toml", PLAN.replace("count = 12", "count = 10"))
        self.batch("sweep.toml", "--slurm", code=2)
        self.assertIn("scancel 17", self.batch("sweep.toml", "--slurm", "--force", code=4).stderr)
        self.answer("squeue")
        self.batch("sweep.toml", "--slurm", "--force")
        self.assertEqual([job["slices"][-1][1] for job in self.jobs()], [10])


class Trouble(ClusterTest):
    def test_sbatch_prints_no_number(self):
        self.answer("sbatch", "Have a nice day")
        self.assertIn("sbatch: did not print a job number, but: Have a nice day",
                      self.batch("sweep.toml", "--slurm", code=4).stderr)
        self.assertEqual(self.jobs(), [])

    def test_squeue_does_not_answer(self):
        self.answer("sbatch", "17")
        self.batch("sweep.toml", "--slurm")
        self.answer("squeue", errors="Unable to contact slurm controller", code=1)
        message = "squeue: does not say what became of job 17: exit code 1, Unable to contact slurm controller"
        self.assertIn(message, self.batch("sweep.toml", "--slurm", code=4).stderr)
        done = self.batch("sweep.toml", "--gather", code=3)
        self.assertIn(f"nothing was submitted: {message}", done.stderr)
        self.assertIn("0 of 12 cases done, 12 missing", done.stdout)
        self.assertEqual(len(self.jobs()), 1)

    def test_a_job_that_slurm_forgot_has_no_cases(self):
        self.answer("sbatch", "17")
        self.batch("sweep.toml", "--slurm")
        self.answer("squeue", errors="slurm_load_jobs error: Invalid job id specified", code=1)
        self.batch("sweep.toml", "--gather", code=3)
        self.assertEqual(len(self.jobs()), 2)

    def test_usage(self):
        for arguments, message in ((["--slurm", "--gather"], "--slurm excludes --gather"),
                                   (["--slurm", "--only", "1..2"], "--only excludes --slurm"),
                                   (["--gather", "--only", "1..2"], "--only excludes --gather"),
                                   (["--gather", "-j", "2"], "--jobs excludes --gather"),
                                   (["--gather", "--force"], "--force excludes --gather"),
                                   (["--tasks", "2"], "--tasks is for jobs of a cluster"),
                                   (["--slurm", "--tasks", "0"], "--tasks"),
                                   (["--", "-c", "2"], "the part after -- is for jobs of a cluster")):
            self.assertIn(message, self.batch("sweep.toml", *arguments, code=2).stderr)
        self.assertFalse((self.folder / "sweep").exists())


if __name__ == "__main__":
    unittest.main()
