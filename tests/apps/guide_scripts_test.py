"""The guide's Python scripts, run with the guide's own commands: pictures, and the numbers that they print."""

import os
import re
import runpy
import subprocess
import sys
import unittest

import h5py
import numpy as np
from matplotlib import colormaps, image
from program import SOURCE, ProgramTest

GUIDE = SOURCE / "docs" / "guide"
DECKS = {"cantilever": GUIDE / "scripts" / "cantilever.toml",
         **{name: SOURCE / "docs/examples" / name / f"{name}.toml"
            for name in ("planar_flight", "right_angle", "free_flight")}}
SHORTER = {"cantilever": ("rod.rule.elements=4", "analysis.end_time=1.5"), "planar_flight": (),
           "right_angle": ("analysis.end_time=3",), "free_flight": ("rod.flyer.elements=5", "analysis.time_step=0.05")}


class Scripts(ProgramTest):
    def run_deck(self, name, *settings):
        sets = [part for setting in (*SHORTER[name], *settings) for part in ("--set", setting)]
        self.gxrod("run", DECKS[name], "--quiet", "--force", *sets)
        return self.folder / f"{name}.vtkhdf"

    def draw(self, script, *changes):
        """Runs the guide's command for a script; gives what it prints and its picture."""
        guide = (GUIDE / "results.md").read_text(encoding="utf-8")
        command = re.search(rf"^python3 docs/guide/scripts/({script}\.py .*)$", guide, re.MULTILINE).group(1).split()
        done = subprocess.run([sys.executable, GUIDE / "scripts" / command[0], *command[1:], *changes], check=False,
                              cwd=self.folder, env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1"),
                              capture_output=True, text=True, timeout=120)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        picture = image.imread(self.folder / command[command.index("-o") + 1])[..., :3]
        self.assertGreater(picture.var(), 1e-3, "the picture is blank")
        return done.stdout, picture

    def test_deflected_shapes(self):
        self.run_deck("planar_flight")
        printed, picture = self.draw("deflected_shapes")
        self.assertEqual(printed, "10 shapes, at time 0, 0.5, 1.125, 1.625, 2.25, 2.75, 3.375, 3.875, 4.5, 5\n")
        for time in (0.0, 0.5, 0.9):
            colour = np.array(colormaps["viridis"](time)[:3])
            self.assertGreater((np.abs(picture - colour).max(axis=-1) < 0.03).sum(), 200, f"nothing at {time}")

    def test_deflected_shapes_go_through_the_nodes_in_their_order(self):
        path = self.run_deck("planar_flight", "rod.flyer.order=4", "rod.flyer.elements=3", "analysis.end_time=0.1")
        script = runpy.run_path(str(GUIDE / "scripts" / "deflected_shapes.py"))
        _, shapes, elements, _ = script["read_shapes"](path)
        self.assertEqual([len(element) for element in elements], [5, 5, 5])
        height = np.concatenate([shapes[0, element, 1] for element in elements])
        np.testing.assert_allclose(height[[0, 5, 10, 14]], np.array([0, 1, 2, 3]) * 8 / 3, atol=1e-12)
        self.assertGreaterEqual(np.diff(height).min(), 0.0)

    def test_histories(self):
        self.run_deck("right_angle")
        printed, some = self.draw("histories")
        self.assertEqual(printed, "drawn: tip/displacement tip/orientation clamp/reaction_moment\n")
        self.assertEqual(some.shape[0], 3 * 288 - 1)
        self.assertEqual(self.draw("histories", "--history", "tip/position")[1].shape[0], 288)

    def test_along_rod(self):
        results = self.run_deck("right_angle")
        printed, _ = self.draw("along_rod")
        largest, s, time = map(float, re.match(r"largest (\S+), at arc length (\S+) and time (\S+)\n", printed).groups())
        with h5py.File(results) as file:
            grid = file["VTKHDF"]
            frames = len(grid["Steps/Values"])
            moment = grid["CellData/moment"][()].reshape(frames, -1, 3)[:, :5, 1]  # the leg is the first rod
            self.assertAlmostEqual(time, grid["Steps/Values"][np.abs(moment).max(axis=1).argmax()])
        self.assertAlmostEqual(abs(largest), np.abs(moment).max(), delta=1e-4 * np.abs(moment).max())
        # Ten long, of five elements.
        self.assertEqual(s, [1, 3, 5, 7, 9][np.abs(moment).max(axis=0).argmax()])
        self.draw("along_rod", "--time", "1.5")

    def test_energy(self):
        results = self.run_deck("free_flight")
        printed, _ = self.draw("energy")
        with h5py.File(results) as file:
            ledger = file["ledger"]
            largest = np.max(ledger["kinetic_energy"][()] + ledger["strain_energy"][()])
            error = np.max(abs(ledger["energy_error"][()])) / largest
        self.assertEqual(printed, f"largest energy {largest:.6g}, largest error {error:.2g} of it\n")
        self.assertLess(error, 0.01)

    def test_spectrum_finds_the_frequency_of_a_cantilever(self):
        # Euler and Bernoulli: the first root of cos(x) cosh(x) = -1.
        height, length, E, density = 0.002, 0.5, 210e9, 7850.0
        exact = 1.8751040687**2 / (2 * np.pi) * np.sqrt(E * height**2 / 12 / density) / length**2
        adaptive = ("analysis.integrator=sdirk-4",
                    "analysis.adaptive={ tolerance = 1e-4, min_step = 1e-5, max_step = 0.01 }")
        for settings in ((), adaptive, (*adaptive, "output.history_interval=1e-3")):
            with self.subTest(settings):
                results = self.run_deck("cantilever", *settings)
                with h5py.File(results) as file:
                    steps = np.diff(file["histories/time"][()])
                self.assertEqual(np.ptp(steps) > 1e-4, bool(settings))
                printed, _ = self.draw("spectrum")
                found = float(re.match(r"dominant frequency (\S+), angular", printed).group(1))
                self.assertAlmostEqual(found / exact, 1.0, delta=1e-3)
        # Steps that were not recorded are left out.
        with h5py.File(self.folder / "cantilever.vtkhdf", "r+") as file:
            file["histories/tip/displacement"][:20] = np.nan
        printed, _ = self.draw("spectrum")
        found = float(re.match(r"dominant frequency (\S+), angular", printed).group(1))
        self.assertAlmostEqual(found / exact, 1.0, delta=1e-3)

    def test_spectrum_is_of_motions_only(self):
        self.gxrod("run", SOURCE / "docs/examples/roll_up/roll_up.toml", "--quiet")
        script = GUIDE / "scripts" / "spectrum.py"
        done = subprocess.run([sys.executable, "-B", script, "roll_up.vtkhdf", "end/position", "x", "-o", "a.png"],
                              check=False, cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 2)
        self.assertIn("a static analysis has no frequencies", done.stderr)

    BATCH = """deck = "roll_up.toml"
combine = "grid"
[vary]
"rod.strip.order" = [1, 2]
"rod.strip.elements" = [1, 10, 20]
"parameters.turns" = [0.9]
[collect]
end = { history = "middle", quantity = "position", component = "y", take = "final", reference = "(1 - cos(0.9*pi))/(1.8*pi)" }
"""

    def test_plot_batch(self):
        deck = (SOURCE / "docs/examples/roll_up/roll_up.toml").read_text(encoding="utf-8")
        self.write("roll_up.toml", deck)
        self.write("plan.toml", self.BATCH)
        self.gxrod("batch", "plan.toml", "--quiet", code=3)
        drawn = "python3 docs/guide/scripts/plot_batch.py plan -o plan.png --x rod.strip.elements --y end"
        printed = self.run_command(f"{drawn} --by rod.strip.order --log x y").stdout.splitlines()
        self.assertEqual(printed[-1], "5 cases drawn, 1 not done")
        slopes = dict(re.fullmatch(r"end, (\d): slope (-\S+)", line).groups() for line in printed[:-1])
        # The chords of a circle are shorter than it by an error of order 2, parabolas by one of order 4.
        self.assertAlmostEqual(float(slopes["1"]), -2.0, delta=0.1)
        self.assertLess(float(slopes["2"]), -3.8)

        def count_red():
            picture = image.imread(self.folder / "plan.png")[..., :3]
            return (np.abs(picture - [1.0, 0.0, 0.0]).max(axis=-1) < 0.1).sum()

        self.assertGreater(count_red(), 10, "no cross for the case that is not done")
        self.run_command(f"{drawn} steps --by rod.strip.order --points")
        self.assertEqual(image.imread(self.folder / "plan.png").shape[0], 7 * 120)

    def test_plot_batch_names_the_columns(self):
        self.write("roll_up.toml", (SOURCE / "docs/examples/roll_up/roll_up.toml").read_text(encoding="utf-8"))
        self.write("plan.toml", self.BATCH.replace("[1, 2]", "[2]").replace("[1, 10, 20]", "[10]"))
        self.gxrod("batch", "plan.toml", "--quiet")
        done = self.run_command("python3 docs/guide/scripts/plot_batch.py plan -o plan.png --x elements "
                                "--y end  # exit code 2")
        self.assertIn("no column elements; there are case, rod.strip.order, rod.strip.elements, parameters.turns, ", done.stderr)


if __name__ == "__main__":
    unittest.main()
