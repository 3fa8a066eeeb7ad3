"""Results in which the disk changed a bit: what a user sees of it."""

import os
import shutil
import subprocess
import unittest

import h5py

from program import SPINNING_BODY, ProgramTest

CHANGED = "not all of its bytes are those that were written"


class ChangedResults(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("body.toml", SPINNING_BODY)
        self.gxrod("run", "body.toml")
        shutil.copy(self.folder / "body.vtkhdf", self.folder / "changed.vtkhdf")
        with h5py.File(self.folder / "changed.vtkhdf", "r+") as file:
            momentum = file["ledger/angular_momentum"]
            momentum[3, 1] += 1e-15

    def plot(self, *arguments):
        return subprocess.run([os.environ["GXROD_PLOT"], *arguments], cwd=self.folder, text=True, capture_output=True,
                              check=True)

    def test_no_run_resumes_from_them(self):
        before = (self.folder / "changed.vtkhdf").read_bytes()
        told = self.gxrod("resume", "changed.vtkhdf", "--set", "analysis.end_time=100", code=4).stderr
        self.assertEqual(told, f"gxrod: changed.vtkhdf: cannot be resumed: {CHANGED} (gxrod run --force starts it again)\n")
        self.assertEqual((self.folder / "changed.vtkhdf").read_bytes(), before)

    def test_they_are_shown_with_a_warning(self):
        told = self.gxrod("export", "changed.vtkhdf", "--csv", "tables", "--series", "frames").stderr
        self.assertEqual(told, f"warning: changed.vtkhdf: {CHANGED}\n")
        told = self.gxrod("report", "changed.vtkhdf").stderr
        self.assertEqual(told, f"warning: This file is in doubt: {CHANGED}.\n")
        self.assertIn("This file is in doubt", (self.folder / "changed.html").read_text())
        told = self.plot("changed.vtkhdf", "--what", "ledger").stderr
        self.assertEqual(told, f"warning: changed.vtkhdf: {CHANGED}\n")
        self.assertEqual(self.plot("body.vtkhdf", "--what", "ledger").stderr, "")
        for verb in (("export", "body.vtkhdf", "--csv", "others"), ("report", "body.vtkhdf")):
            self.assertEqual(self.gxrod(*verb).stderr, "")


if __name__ == "__main__":
    unittest.main()
