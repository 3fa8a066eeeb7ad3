"""Results in which the disk changed a bit: what a user is told of them."""

import shutil
import unittest

import h5py

from program import SPINNING_BODY, ProgramTest

CHANGED = "rows of its histories, ledger or solver's record, up to t = {}, are not those that were written"


class ChangedResults(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("body.toml", SPINNING_BODY)
        self.gxrod("run", "body.toml")
        shutil.copy(self.folder / "body.vtkhdf", self.folder / "changed.vtkhdf")
        with h5py.File(self.folder / "changed.vtkhdf", "r+") as file:
            momentum = file["ledger/angular_momentum"]
            momentum[3, 1] += 1e-15
            self.told = CHANGED.format(f"{file['histories/time'][-1]:.10g}")

    def test_no_run_goes_on_from_them(self):
        before = (self.folder / "changed.vtkhdf").read_bytes()
        told = self.gxrod("resume", "changed.vtkhdf", "--set", "analysis.end_time=100", code=4).stderr
        self.assertEqual(told, f"gxrod: changed.vtkhdf: cannot be resumed: {self.told} (gxrod run --force begins it anew)\n")
        self.assertEqual((self.folder / "changed.vtkhdf").read_bytes(), before)

    def test_they_are_shown_with_a_warning(self):
        told = self.gxrod("export", "changed.vtkhdf", "--csv", "tables", "--series", "frames").stderr
        self.assertEqual(told, f"warning: changed.vtkhdf: {self.told}\n")
        told = self.gxrod("report", "changed.vtkhdf").stderr
        self.assertEqual(told, f"warning: This file is in doubt: {self.told}.\n")
        self.assertIn("This file is in doubt", (self.folder / "changed.html").read_text())
        for verb in (("export", "body.vtkhdf", "--csv", "others"), ("report", "body.vtkhdf")):
            self.assertEqual(self.gxrod(*verb).stderr, "")


if __name__ == "__main__":
    unittest.main()
