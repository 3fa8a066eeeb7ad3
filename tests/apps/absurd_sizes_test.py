"""Sizes that no machine has are refused at once, with what they would need; and a deck runs nothing."""

import os
import resource
import time
import unittest

from program import SPINNING_BODY, ProgramTest

ROD = """[section.s]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 500, EIy = 600, EIz = 600 }
inertia   = { rhoA = 1.0, rhoIy = 0.1, rhoIz = 0.1 }
[rod.beam]
section  = "s"
line     = { from = [0, 0, 0], to = [4, 0, 0] }
elements = 1000
[[support]]
at  = "beam.start"
fix = "all"
[analysis]
kind     = "dynamic"
end_time = 1.0
steps    = 10
"""
IS_SANITIZED = os.environ.get("GXROD_SANITIZED") == "1"


class AbsurdSizes(ProgramTest):
    def refuse(self, *arguments, code):
        """What gxrod says, which must be at once."""
        start = time.monotonic()
        done = self.gxrod(*arguments, code=code)
        self.assertLess(time.monotonic() - start, 60)
        return done.stderr

    def test_numbers_out_of_their_range(self):
        self.write("rod.toml", ROD)
        for setting, told in (("rod.beam.elements=1000000000000", "10000000 elements already need more than 30 GB"),
                              ("rod.beam.order=1000000000", "expected an integer from 1 to 4"),
                              ("output.every=0", "expected an integer from 1 to"),
                              ("analysis.steps=10000000000000", "expected an integer from 1 to 1000000000000"),
                              ("analysis.newton.max_iterations=1e12", "expected an integer from 1 to 1000000")):
            self.assertIn(told, self.refuse("check", "rod.toml", "--set", setting, code=2))

    def test_results_that_the_disk_has_no_room_for(self):
        self.write("body.toml", SPINNING_BODY)
        told = self.refuse("run", "body.toml", "--set", "analysis.steps=1000000000000", "--set", "output.every=1000000000", code=4)
        self.assertRegex(told, r"body.vtkhdf: would take more than 2.4e\+05 GB, for 1e\+12 steps and 1001 frames, where "
                               r"[0-9.e+]+ GB are free \(a larger output.every or output.interval makes fewer frames; histories have each step\)")
        self.write("rod.toml", ROD)
        told = self.refuse("run", "rod.toml", "--set", "analysis.steps=1000000000", "--set", "output.every=1", code=4)
        self.assertIn("for 1e+09 steps and 1e+09 frames", told)
        self.assertFalse((self.folder / "body.vtkhdf").exists() or (self.folder / "rod.vtkhdf").exists())
        self.assertIn("results: at least 3.35 MB\n", self.gxrod("check", "rod.toml").stdout)

    @unittest.skipIf(IS_SANITIZED, "AddressSanitizer maps more than any limit")
    def test_a_model_larger_than_the_memory(self):
        self.write("rod.toml", ROD)
        gigabyte = 10**9
        done = self.gxrod("run", "rod.toml", "--set", "rod.beam.elements=1000000", code=2,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (2 * gigabyte, 2 * gigabyte)))
        self.assertRegex(done.stderr, r"the model would have 1000001 nodes and need more than 2.98 GB of "
                                      r"memory, where 2 GB may be used; expected fewer elements")

    def test_plans_of_more_cases_than_are_run(self):
        self.write("body.toml", SPINNING_BODY)
        plan = 'deck = "body.toml"\ncombine = "latin-hypercube"\ncount = 1000000000000\n[vary]\n"parameters.torque" = '
        self.write("plan.toml", plan + "{ uniform = { from = 1, to = 2 } }\n")
        self.assertIn("count: expected an integer from 1 to 1000000", self.refuse("batch", "plan.toml", code=2))
        self.write("plan.toml", 'deck = "body.toml"\n[vary]\n"parameters.torque" = { from = 1, to = 2, count = 1000000 }\n'
                                '"analysis.end_time" = { from = 1, to = 2, count = 1000000 }\n')
        self.assertIn("makes 1000000000000 cases; 1000000 at most are run", self.refuse("batch", "plan.toml", code=2))


class DecksAreData(ProgramTest):
    def test_a_mesh_runs_nothing(self):
        script = '$Foo;\n;\nSystemCall "touch made";\nPrintf("x") > "made";\n'
        for name, told in (("cable.msh", "is no mesh; a .msh file starts with $MeshFormat"),
                           ("cable.geo", "Gmsh cannot read it: it tries to run a program")):
            self.write(name, script)
            self.write("deck.toml", ROD.replace("elements = 1000", "").replace(
                "line     = { from = [0, 0, 0], to = [4, 0, 0] }", f'mesh = {{ file = "{name}", group = "cable" }}'))
            self.assertIn(told, self.gxrod("check", "deck.toml", code=2).stderr)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["cable.geo", "cable.msh", "deck.toml"])

    def test_messages_hold_nothing_that_a_terminal_obeys(self):
        for deck in ('title = "\\u001b]0;title\\u0007"\n' + SPINNING_BODY.split("\n", 1)[1], "title = \x1b[31mred\n",
                     SPINNING_BODY + "[\x1b[31m]\n"):
            self.write("deck.toml", deck)
            done = self.gxrod("check", "deck.toml", code=2)
            self.assertNotIn("\x1b", done.stdout + done.stderr)
        self.assertNotIn("\x1b", self.gxrod("report", "\x1b[31m.vtkhdf", code=4).stderr)


if __name__ == "__main__":
    unittest.main()
