"""gxrod verify DECK: a user's own deck examined."""

import json
import os
import signal
import subprocess
import time
import unittest

from program import GXROD, SPINNING_BODY, ProgramTest

SWING = """title = "A beam that swings"
[section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 100, EIy = 100, EIz = 100 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.01 }
[rod.beam]
section = "s"
line = { from = [0, 0, 0], to = [4, 0, 0] }
elements = 4
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam.end"
force = [0, "3*sin(t)^2", 0]
[analysis]
kind = "dynamic"
end_time = 2.0
time_step = 0.02
[[history]]
name = "tip"
at = "beam.end"
quantities = ["position", "moment"]
[[history]]
name = "root"
at = "beam.start"
quantities = ["reaction_force"]
"""


class VerifyDeck(ProgramTest):
    def write(self, text=SWING, name="swing.toml"):
        (self.folder / name).write_text(text)
        return name

    def test_says_what_can_be_trusted(self):
        told = self.gxrod("verify", self.write()).stdout
        self.assertIn("A beam that swings\n11 runs, which cost about 20.5 times what the deck costs as it is\n", told)
        self.assertIn("the others will take about", told)
        self.assertIn("tip position", told)
        self.assertIn("stopped midway and resumed: the same to the last bit\n", told)
        self.assertIn("two threads: the same to the last bit\n", told)
        # At the free end there is no moment, and what solvers leave there is not an error.
        self.assertRegex(told, r"tip moment +0 ")
        self.assertIn("\n- Right to 1 % of their largest change: tip moment", told)
        self.assertIn("- Not right to 1 %: ", told)
        self.assertIn("times as many elements would bring that to", told)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["swing.toml"])

    def test_steps_that_are_cut_show_nothing(self):
        options = ("--set", "analysis.time_step=1", "--set", "load[0].force=[0, '300*sin(t)^2', 0]")
        told = self.gxrod("verify", self.write(), *options).stdout
        self.assertRegex(told, r"\ntip position .*-      - .* \?         \?\n")
        self.assertIn("\n- Steps that did not converge were cut, and finer ones came to nearly the same (", told)
        self.assertNotIn("ight to 1 %", told)
        found = json.loads(self.gxrod("verify", "swing.toml", "--json", *options).stdout)
        self.assertFalse(found["accurate"])
        self.assertIsNone(found["series"][0]["relative_error"])
        self.assertIsNone(found["series"][0]["steps"])
        self.assertEqual(found["runs"][0]["steps"], found["runs"][1]["steps"])
        for run in found["runs"]:
            self.assertGreater(run["rejected_steps"], 0, run["run"])

    def test_as_json(self):
        found = json.loads(self.gxrod("verify", self.write(), "--json", "--levels", "1").stdout)
        self.assertEqual((found["deck"], found["title"]), ("swing.toml", "A beam that swings"))
        self.assertTrue(found["sound"])
        self.assertFalse(found["accurate"])
        self.assertEqual(len(found["runs"]), 9)
        self.assertEqual(found["runs"][1]["set"], ["analysis.steps=200"])
        tip = found["series"][0]
        self.assertEqual((tip["point"], tip["quantity"], tip["steps"]["order"]), ("tip", "position", None))
        self.assertGreater(tip["error"], 0)
        self.assertNotIn("times", found)
        strict = json.loads(self.gxrod("verify", "swing.toml", "--json", "--tolerance", "1e-9").stdout)
        self.assertFalse(strict["accurate"])

    def test_keys_can_be_changed(self):
        found = json.loads(self.gxrod("verify", self.write(), "--json", "--levels", "1", "--set", "rod.beam.elements=6",
                                      "--set", "rod.beam.order=2").stdout)
        self.assertEqual([run["elements"] for run in found["runs"][:3]], [6, 6, 12])
        self.assertTrue(found["accurate"])

    def test_seeds_turn_otherwise(self):
        first, again, other = (json.loads(self.gxrod("verify", self.write(), "--json", "--levels", "1", "--seed",
                                                     seed).stdout)["rotation"] for seed in ("1", "1", "2"))
        self.assertEqual(first, again)
        self.assertNotEqual(first, other)

    def test_a_body(self):
        found = json.loads(self.gxrod("verify", self.write(SPINNING_BODY), "--json").stdout)
        self.assertEqual([run["run"] for run in found["runs"]],
                         ["as it is", "half the step", "a quarter of the step", "turned in space", "turned by 1e-6 rad more",
                          "stopped midway and resumed", "two threads"])
        self.assertAlmostEqual(found["series"][0]["steps"]["order"], 2, delta=0.05)
        self.assertIsNone(found["series"][0]["mesh"])

    def test_a_deck_that_does_not_converge(self):
        deck = self.write(SWING.replace("3*sin(t)^2", "1e9*t"))
        done = self.gxrod("verify", deck, "--set", "analysis.newton.max_iterations=2", code=3)
        self.assertIn("The deck as it is does not reach its end", done.stdout)

    def test_faults_of_a_deck_and_of_the_command(self):
        self.assertIn("swing.toml:8:1: rod.beam.elemnts", self.gxrod(
            "verify", self.write(SWING.replace("elements = 4", "elemnts = 4")), code=2).stderr)
        self.assertIn("none.toml", self.gxrod("verify", "none.toml", code=4).stderr)
        self.gxrod("verify", self.write(), "--levels", "3", code=2)
        self.gxrod("verify", self.write(), "--tolerance", "0", code=2)
        both = self.gxrod("verify", "bend_45", self.write(), code=2)
        self.assertIn("swing.toml", both.stderr)
        for options in (("--all",), ("--steps", "100"), ("--figures", "pictures")):
            self.assertIn("is only for the built-in studies", self.gxrod("verify", self.write(), *options, code=2).stderr)
        self.assertIn("is only for a deck", self.gxrod("verify", "bend_45", "--seed", "2", code=2).stderr)

    def test_a_model_that_cannot_be_run(self):
        deck = self.write(SWING.replace('fix = "all"', 'fix = "rotation"')
                          .replace('kind = "dynamic"\nend_time = 2.0\ntime_step = 0.02', 'kind = "static"'))
        self.assertIn("error: ", self.gxrod("verify", deck, code=2).stderr)

    def test_a_stage(self):
        stages = """[[stage]]
name = "bend"
kind = "static"
steps = 2
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 0.4
time_step = 0.02
[[stage]]
name = "tones"
kind = "modes"
[[history]]"""
        deck = self.write(SWING.replace(SWING[SWING.index("[analysis]"):SWING.index("[[history]]") + len("[[history]]")], stages))
        told = self.gxrod("verify", deck, "--levels", "1").stdout
        self.assertIn("A beam that swings\nstage swing\n9 runs, ", told)
        self.assertIn("stopped midway and resumed: the same to the last bit\n", told)
        found = json.loads(self.gxrod("verify", deck, "--json", "--levels", "1", "--stage", "bend").stdout)
        self.assertEqual((found["stage"], found["analysis"]), ("bend", "static"))
        self.assertEqual(found["runs"][1]["set"], ["stage[0].steps=4"])
        self.assertIn("swing.toml: stage tones finds modes; gxrod verify refines what moves. Take --stage bend or swing",
                      self.gxrod("verify", deck, "--stage", "tones", code=2).stderr)
        self.assertIn('there is no stage "swin"; did you mean "swing"?', self.gxrod("verify", deck, "--stage", "swin", code=2).stderr)
        self.assertIn("is only for a deck", self.gxrod("verify", "bend_45", "--stage", "swing", code=2).stderr)

    def test_ctrl_c_leaves_what_is_known(self):
        deck = self.write(SWING.replace("end_time = 2.0", "end_time = 200.0"))
        process = subprocess.Popen([GXROD, "verify", deck], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, env={**os.environ, "TMPDIR": str(self.folder)})
        while not process.stdout.readline().startswith("as it is"):
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        told, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("- Interrupted: of the runs that are missing nothing is said.\n", told)
        self.assertIn("tip position", told)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["swing.toml"])


    def test_ctrl_c_at_once(self):
        deck = self.write(SWING.replace("end_time = 2.0", "end_time = 2000.0"))
        process = subprocess.Popen([GXROD, "verify", deck], cwd=self.folder, stdout=subprocess.PIPE, text=True)
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        told, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("- Interrupted before the first run had ended.\n", told)


if __name__ == "__main__":
    unittest.main()
