"""gxrod run --until STAGE stops after a stage; gxrod resume continues it."""

import unittest

import h5py
import numpy as np

from program import ProgramTest

SWING = """gravity = [0, 0, -9.81]
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e7, nu = 0.4, density = 1000 }
[rod.cord]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 2
[[support]]
at = "cord.start"
fix = "all"
[[support]]
at = "cord.end"
fix = "position"
stages = "hang"
[[stage]]
name = "hang"
kind = "static"
steps = 4
[[stage]]
name = "tones"
kind = "modes"
count = 2
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 0.2
time_step = 0.01
integrator = "generalized-alpha"
[[history]]
name = "end"
at = "cord.end"
quantities = "position"
"""


def read(path):
    with h5py.File(path) as file:
        return file["histories/end/position"][:], sorted(file["stages"]), {name: file["ledger"][name][:] for name in file["ledger"]}


class Until(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("swing.toml", SWING)
        self.gxrod("run", "swing.toml", "-o", "whole.vtkhdf")

    def stop_and_resume(self, stage, rows):
        said = self.gxrod("run", "swing.toml", "-o", "part.vtkhdf", "--force", "--until", stage).stdout
        self.assertIn(f"stopped after stage {stage} at t = 0", said)
        self.assertIn("To resume: gxrod resume part.vtkhdf", said)
        self.assertEqual(len(read(self.folder / "part.vtkhdf")[0]), rows)
        self.gxrod("resume", "part.vtkhdf")
        whole, part = read(self.folder / "whole.vtkhdf"), read(self.folder / "part.vtkhdf")
        np.testing.assert_array_equal(whole[0], part[0])
        self.assertEqual(whole[1], part[1])
        for name, column in whole[2].items():
            np.testing.assert_array_equal(column, part[2][name])

    def test_it_stops_after_statics_and_goes_on_to_the_same_bits(self):
        self.stop_and_resume("hang", 5)

    def test_it_stops_after_modes(self):
        self.stop_and_resume("tones", 5)

    def test_the_last_stage_is_the_end(self):
        said = self.gxrod("run", "swing.toml", "-o", "last.vtkhdf", "--until", "swing").stdout
        self.assertIn("steps to t = 0.2", said)
        self.assertIn("is at its end", self.gxrod("resume", "last.vtkhdf").stdout)

    def test_an_unknown_stage_names_those_there_are(self):
        said = self.gxrod("run", "swing.toml", "--force", "--until", "swin", code=2).stderr
        self.assertIn('swing.toml: --until swin: no such stage; did you mean "swing"?', said)
        said = self.gxrod("run", "swing.toml", "--force", "--until", "end", code=2).stderr
        self.assertIn("the deck has hang, tones, swing", said)


if __name__ == "__main__":
    unittest.main()
