"""gxrod report as a command: what it refuses, and running jobs. report_test opens its pages in a browser."""

import subprocess
import time
import unittest

import h5py
from program import GXROD, SPINNING_BODY, ProgramTest

BAR = """[section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 20, EIy = 20, EIz = 40 }
[rod.bar]
section = "s"
mesh = { file = "bar.geo", group = "bar" }
[[support]]
at = "bar.start"
fix = "all"
[[load]]
at = "bar.end"
force = [0, 1, 0]
[analysis]
kind = "static"
"""


class Program(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("body.toml", SPINNING_BODY)
        self.gxrod("run", "body.toml", "--quiet")

    def test_refuses_to_overwrite(self):
        self.assertIn("body.html (", self.gxrod("report", "body.vtkhdf").stdout)
        done = self.gxrod("report", "body.vtkhdf", code=4)
        self.assertIn("body.html: exists already (--force overwrites it)", done.stderr)
        self.gxrod("report", "body.vtkhdf", "--force")
        self.gxrod("report", "body.vtkhdf", "-o", "other.html")
        done = self.gxrod("report", "body.vtkhdf", "-o", "body.vtkhdf", "--force", code=4)
        self.assertIn("is the results file itself", done.stderr)
        h5py.File(self.folder / "body.vtkhdf").close()

    def test_rejects_what_is_not_a_results_file(self):
        for name, said in (("none.vtkhdf", "there is no such file"), (".", "is a folder"),
                           ("body.toml", "cannot be read as results of gxrod")):
            self.assertIn(said, self.gxrod("report", name, "-o", "x.html", code=4).stderr)
        with h5py.File(self.folder / "body.vtkhdf", "r+") as file:
            file["VTKHDF/Connectivity"][0] = 10 ** 6
        self.assertIn("a point that is not there", self.gxrod("report", "body.vtkhdf", code=4).stderr)
        with h5py.File(self.folder / "body.vtkhdf", "r+") as file:
            file["VTKHDF/Connectivity"][0] = 0
        done = self.gxrod("report", "body.vtkhdf", "-o", "no/such/folder.html", code=4)
        self.assertIn("cannot be written", done.stderr)
        self.assertIn("--budget", self.gxrod("report", "body.vtkhdf", "--budget", "0.1", code=2).stderr)

    def test_runs_no_geometry_script_of_results(self):
        self.write("bar.geo", 'Point(1) = {0, 0, 0, 1}; Point(2) = {4, 0, 1, 1}; Line(1) = {1, 2}; Physical Curve("bar") = {1};\n')
        self.write("bar.toml", BAR)
        self.gxrod("run", "bar.toml", "--quiet")
        self.gxrod("report", "bar.vtkhdf")
        self.assertIn("bar.geo: is a geometry script", (self.folder / "bar.html").read_text())

    def test_takes_a_running_job(self):
        run = subprocess.Popen([GXROD, "run", "body.toml", "--quiet", "-o", "long.vtkhdf", "--set",
                                "analysis.steps=5000000"], cwd=self.folder)
        try:
            time.sleep(1.0)  # five times the longest before the first frame is in the file
            for _ in range(4):
                done = self.gxrod("report", "long.vtkhdf", "--force", "--budget", "2")
                self.assertIn("had not ended", done.stderr)
            self.assertIsNone(run.poll())
        finally:
            run.kill()
            run.wait()
        self.gxrod("report", "long.vtkhdf", "--force", "--budget", "2")


if __name__ == "__main__":
    unittest.main()
