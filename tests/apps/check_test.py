"""gxrod check, and run, of models that are suspicious or cannot be run."""

import json
import os
import re
import subprocess
import unittest

import h5py
import numpy as np

from program import GXROD, ProgramTest

BEAM = """title = "Beam"
[section.s]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 500, EIy = 600, EIz = 600 }
inertia   = { rhoA = 1.0, rhoIy = 0.1, rhoIz = 0.1 }
[rod.beam]
section  = "s"
line     = { from = [0, 0, 0], to = [4, 0, 0] }
elements = 4
element  = "simo"
[[load]]
at    = "beam.end"
force = [0, 0, 3]
[analysis]
kind  = "static"
steps = 2
[[support]]
at  = "beam.start"
"""


class Check(ProgramTest):
    def test_a_part_that_drifts_is_an_error_of_check_and_run(self):
        self.write("beam.toml", BEAM + 'fix = ["position", "rx", "rz"]\n')
        for verb in ("check", "run"):
            done = self.gxrod(verb, "beam.toml", code=2)
            self.assertIn("error: rod beam can turn about an axis along y through (0, 0, 0); "
                          "a static analysis needs supports that prevent it", done.stderr)
        self.assertFalse((self.folder / "beam.vtkhdf").exists())

    def test_warnings_are_told_unless_quiet(self):
        tail = '[rod.tail]\nsection = "s"\nline = { from = [4, 0, 0], to = [4, 1, 0] }\nelements = 1\nelement = "simo"\n'
        self.write("beam.toml", BEAM + 'fix = "all"\n' + tail + '[[support]]\nat = "tail.end"\nfix = "all"\n')
        warning = ("warning: beam.end and tail.start are at one place and not connected; to connect them write "
                   '[[connect]] points = ["beam.end", "tail.start"]')
        done = self.gxrod("check", "beam.toml")
        self.assertIn(warning, done.stdout)
        self.assertIn("note: nothing connects these 2 parts: rod beam; rod tail", done.stdout)
        self.assertIn(warning, self.gxrod("run", "beam.toml").stderr)
        self.assertEqual(self.gxrod("run", "beam.toml", "--force", "--quiet").stderr, "")

    @unittest.skipIf(os.environ.get("GXROD_SANITIZED") == "1", "AddressSanitizer has memory of its own")
    def test_memory_is_told_beforehand(self):
        self.write("beam.toml", BEAM + 'fix = "all"\n')
        many = ("beam.toml", "--set", "rod.beam.elements=30000", "--set", "rod.beam.order=2")
        told = int(re.search(r"^memory: about (\d+) MB$", self.gxrod("check", *many).stdout, re.MULTILINE)[1])
        process = subprocess.Popen([GXROD, "run", *many, "--quiet"], cwd=self.folder)
        status, usage = os.wait4(process.pid, 0)[1:]
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        self.assertAlmostEqual(told / (usage.ru_maxrss / 1e3), 1.0, delta=0.33)

    def test_a_clamped_beam_has_the_reactions_of_its_load(self):
        self.write("beam.toml", BEAM + 'fix = "all"\n[[history]]\nname = "root"\nat = "beam.start"\n'
                   'quantities = ["reaction_force", "reaction_moment"]\n')
        done = self.gxrod("check", "beam.toml")
        self.assertIn("support at beam.start: fixes x y z rx ry rz", done.stdout)
        self.assertIn("static analysis: 2 steps", done.stdout)
        summary = json.loads(self.gxrod("run", "beam.toml", "--summary", "-").stdout)
        self.assertEqual((summary["status"], summary["steps"], summary["time"]), ("complete", 2, 1.0))
        with h5py.File(self.folder / "beam.vtkhdf") as file:
            force = file["histories/root/reaction_force"][:]
            # The load has no t: it grows with the load factor.
            np.testing.assert_allclose(force, [[0, 0, 0], [0, 0, -1.5], [0, 0, -3]], atol=1e-6)


if __name__ == "__main__":
    unittest.main()
