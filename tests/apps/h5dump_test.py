"""Results are read without gxrod, and without Python: by h5dump."""

import re
import subprocess
import unittest

import h5py
import numpy as np
from program import SPINNING_BODY, ProgramTest


class H5dump(ProgramTest):
    def setUp(self):
        super().setUp()
        self.gxrod("run", self.write("body.toml", SPINNING_BODY), "--quiet")

    def h5dump(self, *arguments):
        done = subprocess.run(["h5dump", *arguments, "body.vtkhdf"], cwd=self.folder, capture_output=True, text=True,
                              check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_all_of_it(self):
        text = self.h5dump()
        with h5py.File(self.folder / "body.vtkhdf") as file:
            names = []
            file.visit(names.append)
        for name in names:
            self.assertIn(f'"{name.split("/")[-1]}"', text)

    def test_numbers(self):
        text = self.h5dump("-y", "-w", "0", "-m", "%.17g", "-d", "/histories/spin/angular_velocity")
        self.assertIn('"angular velocity', text)
        self.assertIn("DATASPACE  SIMPLE { ( 101, 3 ) / ( H5S_UNLIMITED, 3 ) }", text)
        rows = re.search(r"DATA \{(.*?)\}", text, re.DOTALL).group(1)
        numbers = np.array([float(number) for number in rows.replace(",", " ").split()])
        with h5py.File(self.folder / "body.vtkhdf") as file:
            np.testing.assert_array_equal(numbers.reshape(-1, 3), file["histories/spin/angular_velocity"][()])

    def test_the_deck(self):
        text = self.h5dump("-d", "/deck/text")
        self.assertIn("[body.top]", text)


if __name__ == "__main__":
    unittest.main()
