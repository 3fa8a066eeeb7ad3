"""Units in the pictures of gxrod-plot, above all of histories of joints and gears."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from program import GXROD, GXROD_PLOT, SOURCE

sys.path.insert(0, str(SOURCE / "apps" / "python"))
sys.dont_write_bytecode = True

from gxrod.plot import histories, results, style, units  # noqa: E402

# A motor turns a wheel by a gear, and the wheel drives a rack.
GEARS = """units = "mm N s"
[body.motor]
mass = 0.5
inertia = [0.02, 0.02, 0.02]
at = [0, 0, 0]
[body.wheel]
mass = 4
inertia = [0.5, 0.3, 0.3]
at = [0, 0.3, 0]
[body.rack]
mass = 1
inertia = [0.1, 0.1, 0.1]
at = [0, 0.6, 0]
[joint.motor_shaft]
type = "hinge"
between = ["ground", "motor"]
axis = [1, 0, 0]
drive = 1
[joint.wheel_shaft]
type = "hinge"
between = ["ground", "wheel"]
axis = [1, 0, 0]
[joint.guide]
type = "slider"
between = ["ground", "rack"]
axis = [0, 0, 1]
[gear.pair]
joints = ["motor_shaft", "wheel_shaft"]
ratio = 0.5
[gear.pinion]
joints = ["wheel_shaft", "guide"]
ratio = -0.3
[analysis]
kind = "dynamic"
end_time = 0.2
time_step = 0.02
[[history]]
name = "wheel"
at = "pair"
quantities = ["drive"]
[[history]]
name = "rack"
at = "pinion"
quantities = ["drive"]
[[history]]
name = "shaft"
at = "motor_shaft"
quantities = ["angle", "angle_rate", "force", "moment", "force_a", "moment_a"]
[[history]]
name = "guide"
at = "guide"
quantities = ["slide", "slide_rate"]
"""
DECKS = {"gears": GEARS, "unnamed": GEARS.replace('units = "mm N s"\n', "")}
folder = None


def setUpModule():
    global folder
    temporary = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(temporary.cleanup)
    folder = Path(temporary.name)
    for name, deck in DECKS.items():
        (folder / f"{name}.toml").write_text(deck)
        subprocess.run([GXROD, "run", f"{name}.toml", "--quiet"], cwd=folder, check=True, capture_output=True)


def draw(name, *arguments):
    """The texts of a picture: comments in its SVG."""
    subprocess.run([GXROD_PLOT, f"{name}.vtkhdf", "-o", "a.svg", *arguments], cwd=folder, check=True, capture_output=True,
                   env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1"))
    return re.findall(r"<!-- (.*?) -->", (folder / "a.svg").read_text(encoding="utf-8"))


class Units(unittest.TestCase):
    def test_products_of_what_the_label_names(self):
        for label, dimension, expected in (
            ("m kg s", "force·length", "N·m"), ("m kg s", "length/time²", "m/s²"), ("m kg s", "angle/time", "rad/s"),
            ("mm t s", "force", "N"), ("mm N s", "mass·length/time", "N·s"), ("cm kg s", "force", "kg·cm/s²"),
            ("m, kN", "force·length", "kN·m"), ("m kN", "length/time", "length/time"),
            ("m kg s", "1", ""), ("", "angle", "rad"), ("m kg s", "mass·length²/time", "kg·m²/s"), ("any", "angle/length", "rad/length"),
            ("m m s", "length", "length"), ("s", "1/time", "1/time")):
            with self.subTest(label=label, dimension=dimension):
                self.assertEqual(units.unit_of(dimension, units.read_units(label)), expected)


class Labels(unittest.TestCase):
    TITLES = {"shaft: angle": "rad", "shaft: angle rate": "rad/s", "shaft: force": "N", "shaft: moment": "N·mm",
              "shaft: force, joint axes": "N", "shaft: moment, joint axes": "N·mm", "guide: slide": "mm", "guide: slide rate": "mm/s",
              "wheel: drive": "N·mm", "rack: drive": "N"}

    def labels(self, name):
        """{title: label of the axis up} of all panels."""
        figure = results.read_results(folder / f"{name}.vtkhdf", self.fill)
        return figure, {axes.get_title("left"): axes.get_ylabel() for axes in figure.axes}

    def fill(self, run):
        panels = histories.history_panels(results.choose_histories(run, []))
        figure = style.new_figure(12.5, 2.3 * histories.row_count(panels))
        histories.draw_histories(figure, run, panels)
        return figure

    def test_histories_of_joints_and_gears_have_units(self):
        self.assertEqual(self.labels("gears")[1], self.TITLES)

    def test_and_dimensions_where_the_deck_names_none(self):
        expected = {"N": "force", "N·mm": "force·length", "mm": "length", "mm/s": "length/time", "rad": "rad", "rad/s": "rad/time"}
        self.assertEqual(self.labels("unnamed")[1], {title: expected[unit] for title, unit in self.TITLES.items()})

    def test_legends_do_not_cover_titles(self):
        figure, _ = self.labels("gears")
        figure.canvas.draw()
        for axes in figure.axes:
            if legend := axes.get_legend():
                title = axes.title if axes.get_title() else axes._left_title
                self.assertFalse(legend.get_window_extent().overlaps(title.get_window_extent()), title.get_text())

    def test_curves_over_each_other_have_units(self):
        texts = draw("gears", "--x", "shaft/angle", "--y", "time", "rack/drive")
        for text in ("shaft: angle (rad)", "time (s)", "rack: drive (N)"):
            self.assertIn(text, texts)
        self.assertIn("N·mm", draw("gears", "--what", "ledger"))
        self.assertIn("time (s)", draw("gears", "--x", "time", "--y", "rack/drive"))
        self.assertIn("time", draw("unnamed", "--x", "time", "--y", "rack/drive"))


if __name__ == "__main__":
    unittest.main()
