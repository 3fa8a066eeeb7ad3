"""Small plans, and a test that runs them with `gxrod batch` and reads their tables."""

import csv
import os
import pathlib
import signal
import subprocess
import time

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

# Cases that run until they are stopped.
ENDLESS = """deck = "swinger.toml"
[vary]
"parameters.EI" = [100, 200]
"analysis.end_time" = [1e6]
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
