"""gxrod verify ends with exit code 5 where something misses its reference: here a sine that is wrong by a little more
each time that it is computed."""

import json
import os
import pathlib
import unittest

from program import SPINNING_BODY, ProgramTest

SHIM = pathlib.Path(os.environ["GXROD_SHIMS"]) / "libsine_shim.so"


class Missed(ProgramTest):
    def verify(self, *arguments, drift, code):
        """Sines are off by `drift` times 1e-15, 2e-15 … of themselves, one after the other."""
        self.assertTrue(SHIM.exists())
        return self.gxrod("verify", *arguments, code=code, env={
            **os.environ, "LD_PRELOAD": str(SHIM), "SINE_DRIFT": str(drift), "ASAN_OPTIONS": "verify_asan_link_order=0"})

    def test_a_study_that_misses_its_reference(self):
        study = ("rubin2007", "--steps", "100")
        for options in ((), ("--json",), ("--table",)):
            self.assertEqual(self.verify(*study, *options, drift=0, code=0).stderr, "")
            done = self.verify(*study, *options, drift=10**6, code=5)
            self.assertEqual(done.stderr, "gxrod: rubin2007 missed its reference\n")
            if "--json" in options:
                self.assertIn(False, [check["passed"] for check in json.loads(done.stdout)["checks"]])
            else:
                self.assertIn("MISSED", done.stdout)

    def test_one_of_several_studies(self):
        done = self.verify("rubin2007", "axial_step", "--steps", "100", "--table", drift=100, code=5)
        self.assertEqual(done.stderr, "gxrod: rubin2007 missed its reference\n")
        self.assertRegex(done.stdout, r"(?s)MISSED.*\naxial_step .*\n2 cases, \d+ checks, [1-9]\d* MISSED in ")

    def test_one_that_cannot_be_run_is_missed_and_the_others_are_run(self):
        done = self.verify("elastica", "rubin2007", "--steps", "100", "--table", drift=10**12, code=5)
        self.assertRegex(done.stderr, "(?m)^gxrod: elastica missed its reference: .*failed")
        self.assertIn("\n2 cases, ", done.stdout)

    def test_a_deck_whose_runs_differ(self):
        self.write("body.toml", SPINNING_BODY)
        done = self.verify("body.toml", drift=0, code=0)
        self.assertIn("two threads: the same to the last bit\n", done.stdout)
        done = self.verify("body.toml", drift=1, code=5)
        self.assertIn("two threads: NOT the same: spin angular_velocity differs at t = 0.01\n", done.stdout)
        found = json.loads(self.verify("body.toml", "--json", "-o", "page.html", drift=1, code=5).stdout)
        self.assertFalse(found["sound"])
        self.assertTrue((self.folder / "page.html").exists())


if __name__ == "__main__":
    unittest.main()
