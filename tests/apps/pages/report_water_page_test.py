"""The ranges of tension and bending along rods in water, on the page of gxrod report, in a browser."""

import unittest

import h5py
import numpy as np
import report_pages
from report_pages import PageTest, set_up_pages

# A pipe in water from its foot up to the surface, filled and pulled; first hung, then swung.
PIPE = """title = "A pipe in water"
units = "m kg s"
gravity = [0, 0, -9.81]
[fluid]
density = 1025
surface = 0
[section.s]
stiffness = { EA = 1e8, GAy = 4e7, GAz = 4e7, GJ = 1e5, EIy = 1e5, EIz = 1e5 }
inertia = { rhoA = 30, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
fluid = { outer_diameter = 0.2, contents = { density = 800, pressure = 1e5, inner_diameter = 0.15 } }
[rod.pipe]
section = "s"
line = { from = [0, 0, -40], to = [0, 0, 0] }
elements = 8
order = 2
[[support]]
at = "pipe.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "pipe.end"
fix = ["x", "y"]
stages = "hang"
[[support]]
at = "pipe.end"
fix = "y"
move = { x = "sin(t)^3" }
stages = "swing"
[[load]]
at = "pipe.end"
force = [0, 0, 2e4]
[[history]]
name = "low"
at = "pipe@0.0625"
quantities = ["effective_tension", "wall_tension"]
[[stage]]
name = "hang"
kind = "static"
steps = 3
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 2
time_step = 0.05
integrator = "generalized-alpha"
"""
# It hangs in air, then half the water comes, then ground, without water.
STAGES = PIPE.replace("surface = 0\n", 'surface = 0\nstages = "soak"\nfactor = 0.5\n').replace("[section.s]", """[air]
density = 1.2
[seabed]
z = -40
stiffness = 1e4
stages = "lie"
[section.s]""")
STAGES = STAGES[:STAGES.index("[[support]]\nat = \"pipe.end\"")] + """[[support]]
at = "pipe.end"
fix = ["x", "y"]
[[load]]
at = "pipe.end"
force = [0, 0, 2e4]
[[history]]
name = "low"
at = "pipe@0.0625"
quantities = ["effective_tension", "wall_tension"]
""" + "".join(f'[[stage]]\nname = "{name}"\nkind = "static"\nsteps = 2\n' for name in ("hang", "soak", "lie"))
CHART = "document.querySelector('.along')"


def setUpModule():
    report_pages.DECKS = {"pipe": PIPE, "rod": report_pages.ROD, "stages": STAGES}
    set_up_pages()


class RangesInWater(PageTest):
    def plot(self, quantity):
        self.browser.run(f"const menu = {CHART}.querySelector('[aria-label=Quantity]'); menu.value = arguments[0];"
                         "menu.dispatchEvent(new Event('change'))", quantity)
        self.browser.settle()
        return self.browser.run(f"return {CHART}.querySelector('.chart-body').plotted().map((c) => [...c])")

    def test_come_first_with_least_largest_and_mean_from_the_start_of_time(self):
        self.open("pipe")
        self.assertIn("Ranges of tension and bending", self.text(".along h2"))
        s, largest, least, _, mean = self.plot("effective_tension")
        with h5py.File(self.folder / "pipe.vtkhdf") as file:
            times = file["VTKHDF/Steps/Values"][()]
            force = file["VTKHDF/CellData/force"][()].reshape(len(times), 8, 3)
        tension = force[times >= 0, :, 0]
        np.testing.assert_allclose(s, 40 * (np.arange(8) + 0.5) / 8, rtol=1e-6)
        np.testing.assert_allclose(largest, tension.max(axis=0), rtol=1e-6)
        np.testing.assert_allclose(least, tension.min(axis=0), rtol=1e-6)
        np.testing.assert_allclose(mean, tension.mean(axis=0), rtol=1e-6)
        self.assertIn("range over frames from t = 0", self.text(".along"))

    def test_have_the_tension_in_the_wall_that_histories_have(self):
        self.open("pipe")
        _, largest, least, *_ = self.plot("wall_tension")
        with h5py.File(self.folder / "pipe.vtkhdf") as file:
            times = file["VTKHDF/Steps/Values"][()]
            steps = np.isin(file["histories/time"][()], times[times >= 0])
            wall = file["histories/low/wall_tension"][()][steps]
        np.testing.assert_allclose([largest[0], least[0]], [wall.max(), wall.min()], rtol=1e-5)
        self.assertEqual(self.browser.take_errors(), [])

    def test_have_the_pressure_of_each_stage(self):
        self.open("stages")
        _, largest, least, *_ = self.plot("wall_tension")
        with h5py.File(self.folder / "stages.vtkhdf") as file:
            steps = np.isin(file["histories/time"][()], file["VTKHDF/Steps/Values"][()])
            wall = file["histories/low/wall_tension"][()][steps]
        np.testing.assert_allclose([largest[0], least[0]], [wall.max(), wall.min()], rtol=1e-5)

    def test_water_and_ground_are_drawn_in_their_stages(self):
        self.open("stages")
        with h5py.File(self.folder / "stages.vtkhdf") as file:
            frames = len(file["VTKHDF/Steps/Values"])
        shown = []
        for frame in range(frames):
            self.slide(frame)
            shown.append(self.browser.run("return document.getElementById('canvas').picture().parts.surroundings.sheets.map(({ mesh }) => mesh.visible)"))
        # Frames at the ends of steps: the start and two in "hang", two in "soak", two in "lie"; water, then ground.
        self.assertEqual(shown, [[False, False]] * 3 + [[True, False]] * 2 + [[False, True]] * 2)
        self.assertEqual(self.browser.take_errors(), [])

    def test_are_not_there_without_water(self):
        self.open("rod")
        self.assertEqual(self.text(".along h2"), "Along a rod")


if __name__ == "__main__":
    unittest.main()
