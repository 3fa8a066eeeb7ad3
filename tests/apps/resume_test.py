"""gxrod resume: killed, interrupted and finished runs continue as if they had never stopped."""

import os
import signal
import subprocess
import time
import unittest

import h5py
import numpy as np

from program import GXROD, SPINNING_BODY, ProgramTest

STEPS = 40000 if os.environ.get("GXROD_SANITIZED") == "1" else 200000
LONG = SPINNING_BODY.replace("steps = 100", f"steps = {STEPS}").replace("every = 10", "every = 7")
PROVENANCE = ("restart", "deck")


class Resume(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("body.toml", SPINNING_BODY)

    def start_long_run(self, deck=LONG):
        """A run of a second or more, when it has written steps twice, so that the first time is all in the file."""
        self.write("long.toml", deck)
        process = subprocess.Popen([GXROD, "run", "long.toml"], cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.wait)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        first = 0
        for _ in range(2000):
            steps = self.steps("long.vtkhdf")
            if steps > first > 1:
                return process
            first = steps
            time.sleep(0.01)
        self.fail("no steps within 20 s")

    def steps(self, name):
        try:
            with h5py.File(self.folder / name, "r", locking=False) as file:
                return len(file["histories/time"])
        except (OSError, KeyError, RuntimeError):
            return 0

    def check_equal(self, first, second):
        """Every dataset but the state to resume from and the deck, to the last bit."""
        with h5py.File(self.folder / first) as a, h5py.File(self.folder / second) as b:
            names = []
            a.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
            compared = [name for name in names if not name.startswith(PROVENANCE)]
            self.assertGreater(len(compared), 30)
            for name in compared:
                self.assertEqual(a[name].shape, b[name].shape, name)
                if a[name].dtype.kind == "O":  # texts
                    self.assertEqual(list(a[name][()]), list(b[name][()]), name)
                    continue
                self.assertEqual(a[name][()].tobytes(), b[name][()].tobytes(), name)
            for attribute in ("status", "title", "units", "analysis"):
                self.assertEqual(a.attrs[attribute], b.attrs[attribute])
            self.assertEqual(a["VTKHDF/Steps"].attrs["NSteps"], b["VTKHDF/Steps"].attrs["NSteps"])

    def test_a_killed_run_resumes_to_the_last_bit(self):
        process = self.start_long_run()
        process.kill()
        process.wait()
        self.assertLess(self.steps("long.vtkhdf"), STEPS, "the run ended before it was killed")
        done = self.gxrod("resume", "long.vtkhdf")
        self.assertIn("long.vtkhdf continues from t = ", done.stdout)
        self.assertIn(f"{STEPS} steps to t = 1", done.stdout)
        self.gxrod("run", "long.toml", "-o", "whole.vtkhdf", "--quiet")
        self.check_equal("whole.vtkhdf", "long.vtkhdf")

    def test_a_resumed_run_can_be_killed_too(self):
        process = self.start_long_run()
        process.kill()
        process.wait()
        before = self.steps("long.vtkhdf")
        again = subprocess.Popen([GXROD, "resume", "long.vtkhdf", "--quiet"], cwd=self.folder)
        self.addCleanup(again.kill)
        for _ in range(2000):
            if self.steps("long.vtkhdf") > before:
                break
            time.sleep(0.005)
        again.kill()
        again.wait()
        self.assertGreater(self.steps("long.vtkhdf"), before)
        self.gxrod("resume", "long.vtkhdf", "--quiet")
        self.gxrod("run", "long.toml", "-o", "whole.vtkhdf", "--quiet")
        self.check_equal("whole.vtkhdf", "long.vtkhdf")

    def test_an_interrupted_run_says_how_to_resume(self):
        process = self.start_long_run()
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(), 130)
        self.assertIn("To resume: gxrod resume long.vtkhdf", process.stderr.read())
        self.gxrod("resume", "long.vtkhdf", "--quiet")
        with h5py.File(self.folder / "long.vtkhdf") as file:
            self.assertEqual(file.attrs["status"], "complete")

    def test_a_running_job_is_left_alone(self):
        process = self.start_long_run(LONG.replace(f"steps = {STEPS}", "steps = 50000000"))
        done = self.gxrod("resume", "long.vtkhdf", code=4)
        self.assertIn("long.vtkhdf: another process is writing it", done.stderr)
        done = self.gxrod("run", "body.toml", "-o", "long.vtkhdf", "--force", code=4)
        self.assertIn("long.vtkhdf: another process is writing it", done.stderr)
        process.kill()

    def test_a_run_is_made_longer(self):
        self.gxrod("run", "body.toml", "--set", "analysis.time_step=0.01")
        done = self.gxrod("resume", "body.vtkhdf")
        self.assertIn("is at its end, t = 1; nothing was changed. --set analysis.end_time=", done.stdout)
        self.assertIn('"steps": 100', self.gxrod("resume", "body.vtkhdf", "--summary", "-").stdout)
        done = self.gxrod("resume", "body.vtkhdf", "--set", "analysis.end_time=2.5", "--summary", "-")
        self.assertIn('"steps": 250', done.stdout)
        self.gxrod("run", "body.toml", "--set", "analysis.time_step=0.01", "--set", "analysis.end_time=2.5",
                   "-o", "whole.vtkhdf")
        self.check_equal("whole.vtkhdf", "body.vtkhdf")
        with h5py.File(self.folder / "body.vtkhdf") as file:
            self.assertIn(b"end_time = 2.5", file["deck/text_2"][()])

    def test_the_deck_can_be_edited_where_that_changes_no_state(self):
        self.gxrod("run", "body.toml")
        edited = SPINNING_BODY.replace("end_time = 1.0", "end_time = 2.0").replace("steps = 100", "steps = 200")
        self.write("edited.toml", edited.replace("every = 10", "every = 5"))
        self.gxrod("resume", "body.vtkhdf", "--deck", "edited.toml")
        with h5py.File(self.folder / "body.vtkhdf") as file:
            np.testing.assert_allclose(file["VTKHDF/Steps/Values"],
                                       np.append(np.arange(11) / 10, np.arange(21, 41) / 20), atol=1e-12)
            self.assertEqual(len(file["histories/spin/position"]), 201)

    def test_another_deck_is_refused_with_its_differences(self):
        self.gxrod("run", "body.toml")
        before = (self.folder / "body.vtkhdf").read_bytes()
        self.write("other.toml", SPINNING_BODY.replace("mass = 2.0", "mass = 2.5").replace("end_time = 1.0", "end_time = 2.0"))
        done = self.gxrod("resume", "body.vtkhdf", "--deck", "other.toml", code=2)
        self.assertEqual(done.stderr, "other.toml:5:8: body.top.mass: the run to be resumed has 2.0\n")
        done = self.gxrod("resume", "body.vtkhdf", "--set", "parameters.torque=3", code=2)
        self.assertIn("--set parameters.torque=3: the run to be resumed has 0.5", done.stderr)
        self.assertEqual((self.folder / "body.vtkhdf").read_bytes(), before)

    def test_what_cannot_be_resumed_is_reported(self):
        self.assertIn("there is no such file", self.gxrod("resume", "none.vtkhdf", code=4).stderr)
        self.write("text.vtkhdf", "no HDF5")
        self.assertIn("text.vtkhdf: cannot be resumed", self.gxrod("resume", "text.vtkhdf", code=4).stderr)
        with h5py.File(self.folder / "other.vtkhdf", "w") as file:
            file["a"] = 1
        self.assertIn("it is not a results file of gxrod", self.gxrod("resume", "other.vtkhdf", code=4).stderr)
        self.gxrod("run", "body.toml")
        done = self.gxrod("resume", "body.vtkhdf", "--set", "analysis.end_time=0.505", code=4)
        self.assertIn("it is at t = 1 already, after the end, 0.505", done.stderr)
        self.assertEqual(done.stdout, "")
        done = self.gxrod("resume", "body.vtkhdf", "--set", "analysis.end_time=1.55", "--set", "analysis.time_step=0.1", code=4)
        self.assertIn("do not meet t = 1, where it stopped", done.stderr)
        self.assertIn("is a results file, not a deck", self.gxrod("run", "body.vtkhdf", code=4).stderr)
        self.assertIn("it is not a results file of gxrod", self.gxrod("resume", "body.toml", code=4).stderr)


if __name__ == "__main__":
    unittest.main()
