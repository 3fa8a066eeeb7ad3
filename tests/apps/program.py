"""What the end-to-end tests share: calling gxrod as a user would, in a folder of its own."""

import os
import pathlib
import subprocess
import tempfile
import unittest

GXROD = os.environ["GXROD"]
GXROD_PLOT = os.environ["GXROD_PLOT"]
SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])

SPINNING_BODY = """title = "A body that spins"
[parameters]
torque = 0.5
[body.top]
mass = 2.0
inertia = [1.0, 1.0, 0.75]
at = [0, 0, 0]
angular_velocity = [0, 0, 3]
[[load]]
at = "top"
moment = ["torque*sin(t)", 0, 0]
[analysis]
kind = "dynamic"
end_time = 1.0
steps = 100
[output]
every = 10
[[history]]
name = "spin"
at = "top"
quantities = ["angular_velocity", "position"]
"""


class ProgramTest(unittest.TestCase):
    """Gives each test an empty folder, in which gxrod runs."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def gxrod(self, *arguments, code=0, program=GXROD, timeout=300, **options):
        """Runs the program; the exit code must be as told."""
        done = subprocess.run([program, *map(str, arguments)], cwd=self.folder, text=True, timeout=timeout,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        self.assertEqual(done.returncode, code, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done
