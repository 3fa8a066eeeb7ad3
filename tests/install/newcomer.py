"""What a newcomer does first with an installed gxrod, for the tests of packages and wheels. GXROD_SOURCE is the source tree."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"]).resolve()
[VERSION] = re.findall(r"project\(gxrod VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())
# A run step by step; results as arrays.
DRIVE = """
import sys, gxrod
with gxrod.Simulation(gxrod.Deck(sys.argv[1]).build(), results="driven.vtkhdf") as sim:
    sim.advance(steps=5)
    assert sim.state.position.shape == (31, 3)
"""
READ = """
import gxrod
r = gxrod.open_results("run.vtkhdf")
print(gxrod.__version__, r.status, r["tip"].position.shape)
"""


def run(*command, **options):
    done = subprocess.run([str(part) for part in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


class Scratch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        os.chmod(cls.folder, 0o755)  # apt's own user reads packages

    def work(self, bin_folder, deck, python, module, environment):
        """A newcomer's first steps: a run, its page, its picture, its results as arrays, a run from Python."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        do = lambda *command: run(*command, cwd=folder, env=environment)
        self.assertEqual(do(bin_folder / "gxrod", "--version").split(), ["gxrod", VERSION])
        do(bin_folder / "gxrod", "run", deck, "-o", "run.vtkhdf")
        # Packages are for machines without AVX, too.
        run(bin_folder / "gxrod", "run", deck, "-o", "old.vtkhdf", cwd=folder, env=environment | {"GXROD_INSTRUCTION_SET": "baseline"})
        do(bin_folder / "gxrod", "report", "run.vtkhdf")
        self.assertIn("three.js authors", (folder / "run.html").read_text())
        do(bin_folder / "gxrod-plot", "run.vtkhdf")
        self.assertEqual((folder / "run.png").read_bytes()[:4], b"\x89PNG")
        self.assertEqual(do(python, "-B", "-c", READ).split(maxsplit=2), [VERSION, "complete", "(401, 3)\n"])
        if module:
            do(python, "-B", "-c", DRIVE, deck)


def without_ours():
    """The environment of this process without what would lead to another gxrod."""
    return {key: value for key, value in os.environ.items() if not key.startswith(("GXROD", "PYTHON"))}
