"""Sleeves in the pictures of gxrod-plot: from the program to the picture."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from matplotlib import image
from program import GXROD, GXROD_PLOT, SOURCE

sys.path.insert(0, str(SOURCE / "apps" / "python"))
sys.dont_write_bytecode = True

from gxrod.plot import mechanism, results, shapes, style  # noqa: E402

# A spoke that falls: a bob hangs on it by an arm, a mast slides along it with its end and a rail with its middle, it slides through
# an eye of the ground; the place of another eye is an expression.
SLEEVES = """units = "m kg s"
gravity = [0, -9.81, 0]
[parameters]
place = 0.8
[section.bar]
stiffness = { EA = 1e3, GAy = 500, GAz = 500, GJ = 4, EIy = 5, EIz = 5 }
inertia = { rhoA = 1, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }
[rod.rail]
section = "bar"
line = { from = [0.6, 0, -0.3], to = [0.6, 0, 0.3] }
elements = 4
[rod.spoke]
section = "bar"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 10
[rod.mast]
section = "bar"
line = { from = [0.4, -0.5, 0], to = [0.4, 0, 0] }
elements = 3
order = 2
[[support]]
at = "spoke.start"
fix = "all"
[body.falling]
mass = 1
inertia = [1, 1, 1]
at = [1, 0.2, 0]
[body.bob]
mass = 0.3
inertia = [1e-3, 1e-3, 1e-3]
at = [0.3, -0.1, 0]
velocity = [1.5, 0, 0]
angular_velocity = [0, 0, 5]
[joint.hook]
type = "sleeve"
between = ["spoke", "bob"]
at = [0.3, 0, 0]
[joint.tip]
type = "sleeve"
between = ["spoke", "mast.end"]
[joint.middle]
type = "sleeve"
between = ["spoke", "rail@0.5"]
[joint.eye]
type = "sleeve"
between = ["spoke", "ground"]
at = [0.9, 0, 0]
[joint.second_eye]
type = "sleeve"
between = ["spoke", "ground"]
at = ["place", 0, 0]
[analysis]
kind = "dynamic"
end_time = 0.3
time_step = 0.005
[output]
every = 10
"""
folder = None


def setUpModule():
    global folder
    temporary = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(temporary.cleanup)
    folder = Path(temporary.name)
    (folder / "sleeves.toml").write_text(SLEEVES)
    subprocess.run([GXROD, "run", "sleeves.toml", "--quiet"], cwd=folder, check=True, capture_output=True)


def distance_to_line(place, points):
    """From a place to the nearest of the straight lines between points [n,3]."""
    starts, steps = points[:-1], np.diff(points, axis=0)
    shares = np.clip(np.sum((place - starts) * steps, axis=1) / np.sum(steps**2, axis=1), 0.0, 1.0)
    return np.linalg.norm(place - starts - shares[:, None] * steps, axis=1).min()


class Sleeves(unittest.TestCase):
    NAMES = ["hook", "tip", "middle", "eye", "second_eye"]

    def make(self, frames):
        return results.read_results(folder / "sleeves.vtkhdf", lambda run: mechanism.make_mechanism(run, frames, 0.1))

    def test_they_are_on_the_rod_in_every_frame(self):
        made = self.make(list(range(7)))
        with h5py.File(folder / "sleeves.vtkhdf") as file:
            points = file["VTKHDF/Points"][()].reshape(7, -1, 3)
            spoke = np.flatnonzero(file["VTKHDF/PointData/rod"][()] == 1)
            np.testing.assert_allclose([time for _, time in made.beads], file["VTKHDF/Steps/Values"][()])
        for (places, _), frame in zip(made.beads, points):
            self.assertEqual(places.shape, (5, 3))
            for name, place in zip(self.NAMES, places):
                # The rod is drawn straight between its nodes, the line of a sleeve is smooth.
                self.assertLess(distance_to_line(place, frame[spoke]), 1e-3, name)
        self.assertGreater(np.linalg.norm(made.beads[-1][0] - made.beads[0][0], axis=1)[:3].min(), 1e-3, "one does not move")

    def test_the_points_that_slide_carry_them(self):
        [(places, _)] = self.make([6]).beads
        with h5py.File(folder / "sleeves.vtkhdf") as file:
            data = {name: file[f"VTKHDF/PointData/{name}"][()] for name in ("rod", "arc_length")}
            count = len(data["rod"])
            last = lambda name: file[f"VTKHDF/{name}"][-count:]
            points, across = last("Points"), last("PointData/axis_y")
            bob = np.flatnonzero(data["rod"] == -1)[1]
            np.testing.assert_allclose(places[0], points[bob] + 0.1 * across[bob], atol=1e-9)
            for place, rod, length in ((places[1], 2, 0.5), (places[2], 0, 0.3)):
                [node] = np.flatnonzero((data["rod"] == rod) & np.isclose(data["arc_length"], length))
                np.testing.assert_allclose(place, points[node], atol=1e-12)
            np.testing.assert_allclose(places[3:], [[0.9, 0, 0], [0.8, 0, 0]])
            self.assertGreater(np.linalg.norm(across[bob] - [0, 1, 0]), 0.1, "the bob does not turn")

    def test_the_last_ones_are_marked_and_arms_lead_to_them(self):
        made = self.make([0, 6])
        marks = {(kind, colour) for kind, _, colour in made.marks}
        self.assertEqual(marks, {("sleeve", mechanism.JOINT), ("sleeve", style.GREY)})
        np.testing.assert_array_equal([place for _, place, _ in made.marks], made.beads[-1][0])
        [(first, start), (_, end)] = made.links
        np.testing.assert_allclose(first, [[0.3, -0.1, 0], [0.3, 0, 0]], atol=1e-12)
        self.assertAlmostEqual(end - start, 0.3)
        self.assertEqual(mechanism.describe(made), "◉ sleeve, ○ in the colours of time: before, grey: on the ground")

    def test_pictures_have_them(self):
        """The points that slide alone have these two colours in this model."""
        for view in ("xy", "3d"):
            subprocess.run([GXROD_PLOT, "sleeves.vtkhdf", "--what", "shapes", "--view", view, "-o", "a.png"], cwd=folder, check=True,
                           capture_output=True, env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1"))
            pixels = (255 * image.imread(folder / "a.png")[..., :3]).round().astype(int)
            teal = [int(mechanism.JOINT[i : i + 2], 16) for i in (1, 3, 5)]
            self.assertGreater((np.abs(pixels - teal).max(axis=2) < 12).sum(), 200, view)

    def test_bodies_on_sleeves_have_axes_in_the_last_frame_alone(self):
        read = lambda run: (shapes.make_scene(run, list(range(7))), [run.trace(node) for node in run.bodies])
        scene, paths = results.read_results(folder / "sleeves.vtkhdf", read)
        count = lambda path: sum(np.linalg.norm(path - origin, axis=1).min() < 1e-12 for origin, _ in scene.triads)
        falling, bob = map(count, paths)
        self.assertEqual(bob, 1)
        self.assertGreater(falling, 1)


if __name__ == "__main__":
    unittest.main()
