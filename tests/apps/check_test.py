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
        self.write("beam.toml", BEAM + 'fix = ["x", "y", "rotation"]\n')
        for verb in ("check", "run"):
            done = self.gxrod(verb, "beam.toml", code=2)
            self.assertIn("error: rod beam can move along z; "
                          "a static analysis needs supports that prevent it", done.stderr)
        self.assertFalse((self.folder / "beam.vtkhdf").exists())

    def test_scheme_and_steps_that_do_not_suit_are_named(self):
        dynamic = BEAM.replace('kind  = "static"\nsteps = 2', 'kind = "dynamic"\nend_time = 30\ntime_step = 3')
        self.write("beam.toml", dynamic + 'fix = "all"\n')
        said = self.gxrod("check", "beam.toml").stdout
        self.assertRegex(said, r"  a step of 3 is [\d.]+ of the longest period and \d+ of the shortest\n")
        self.assertRegex(said, r"newmark-simplified needs some 20 steps in a period that matters: expected time_step = [\d.]+, or accuracy")
        for scheme, words in (("sdirk-4", "radau-5 keeps its order"), ("gauss-4", "they ring"), ("runge-kutta-4", "will fail; accuracy")):
            self.assertIn(words, self.gxrod("check", "beam.toml", "--set", f"analysis.integrator={scheme}").stdout)

    def test_friction_that_hides_errors_is_noted(self):
        deck = """[body.wheel]
mass = 1
inertia = [1, 1, 1]
angular_velocity = [0, 0, 20]
[joint.axle]
type = "hinge"
between = ["ground", "wheel"]
axis = [0, 0, 1]
friction = { moment = 2, stick = 1e-4 }
[analysis]
kind = "dynamic"
end_time = 12
accuracy = 1e-3
"""
        self.write("wheel.toml", deck)
        note = "note: joint axle has friction: where it sticks or slips, errors can be far above the accuracy"
        self.assertIn(note, self.gxrod("check", "wheel.toml").stdout)
        chosen = self.gxrod("check", "wheel.toml", "--set", "analysis.integrator=auto").stdout
        self.assertNotIn("note: joint", chosen)
        self.assertIn("generalized-alpha (auto: for friction, which joint axle has)", chosen)

    def test_warnings_are_printed_and_listed_also_when_quiet(self):
        tail = '[rod.tail]\nsection = "s"\nline = { from = [4, 0, 0], to = [4, 1, 0] }\nelements = 1\nelement = "simo"\n'
        self.write("beam.toml", BEAM + 'fix = "all"\n' + tail + '[[support]]\nat = "tail.end"\nfix = "all"\n')
        warning = ("warning: beam.end and tail.start are at one place and not connected; to connect them write "
                   '[[connect]] points = ["beam.end", "tail.start"]')
        done = self.gxrod("check", "beam.toml")
        self.assertIn(warning, done.stdout)
        self.assertIn("note: nothing connects these 2 parts: rod beam; rod tail", done.stdout)
        self.assertIn(warning, self.gxrod("run", "beam.toml").stderr)
        done = self.gxrod("run", "beam.toml", "--force", "--quiet", "--summary", "run.json")
        self.assertEqual((done.stdout, done.stderr), ("", f"beam.toml: {warning}\n"))
        listed = [warning.removeprefix("warning: ")]
        self.assertEqual(json.loads((self.folder / "run.json").read_text())["warnings"], listed)
        with h5py.File(self.folder / "beam.vtkhdf") as file:
            self.assertEqual(file.attrs["warnings"], listed[0])

    def test_tendons_and_inputs_are_listed(self):
        self.write("beam.toml", BEAM + 'fix = "all"\n[input.pull]\nvalue = 3\n[input.idle]\nvalue = 1\n'
                   '[tendon.t]\non = "beam"\noffset = [0, 0.01]\ntension = "2*pull"\n')
        done = self.gxrod("check", "beam.toml").stdout
        self.assertIn("tendon t: in rod beam, at (y, z) = (0, 0.01), 4 long; tension changes with t, 6 at t = 1\n", done)
        self.assertIn("input pull: 3 at t = 0, between two values a step; read by tendon.t.tension\n", done)
        self.assertIn("note: input.idle: nothing uses it", done)
        self.assertNotIn("note: input.pull", done)

    @unittest.skipIf(os.environ.get("GXROD_SANITIZED") == "1", "AddressSanitizer has memory of its own")
    def test_memory_is_estimated_beforehand(self):
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

    def test_a_load_without_an_integral_is_an_error_of_check_and_run(self):
        along = '[[load]]\non = "beam"\nforce_per_length = [0, 0, "sin(1e7*s)"]\n'
        for analysis in ("static", "dynamic"):
            deck = (BEAM + 'fix = "all"\n' + along).replace(
                'kind  = "static"', f'kind  = "{analysis}"' + ("\nend_time = 1.0" if analysis == "dynamic" else ""))
            self.write("beam.toml", deck)
            for verb in ("check", "run"):
                done = self.gxrod(verb, "beam.toml", *(("--force",) if verb == "run" else ()), code=2)
                self.assertIn("load[1]: the load per length has no integral that can be found from s = 0 to s = 1 at t = ",
                              done.stderr + done.stdout, (analysis, verb))

    def test_a_motion_from_a_file_is_kept_and_resumed(self):
        rows = "".join(f"{0.1 * i},{0.01 * i * i}\n" for i in range(11))
        self.write("motion.csv", "t,z\n" + rows)
        deck = BEAM.replace('kind  = "static"\nsteps = 2', 'kind = "dynamic"\nend_time = 0.5\nsteps = 50')
        self.write("beam.toml", deck + 'fix = ["x", "y", "rotation"]\nmove = { z = "lift(t)" }\n'
                   '[function.lift]\nfile = "motion.csv"\ncolumns = ["t", "z"]\n')
        warning = "warning: the [[support]] at beam.start moves z with a velocity that jumps from "
        self.assertIn(warning, self.gxrod("check", "beam.toml").stdout)
        cubic = ("--set", 'function.lift.interpolation="cubic"')
        self.assertNotIn(warning, self.gxrod("check", "beam.toml", *cubic).stdout)
        self.gxrod("run", "beam.toml", *cubic)
        with h5py.File(self.folder / "beam.vtkhdf") as file:
            kept = list(file["deck/meshes"].values())
            self.assertEqual([mesh.attrs["file"] for mesh in kept], ["motion.csv"])
        (self.folder / "motion.csv").unlink()
        self.gxrod("resume", "beam.vtkhdf", "--set", "analysis.end_time=1.0", "--set", "analysis.steps=100")
        with h5py.File(self.folder / "beam.vtkhdf") as file:
            self.assertEqual(file["histories/time"][-1], 1.0)


if __name__ == "__main__":
    unittest.main()
