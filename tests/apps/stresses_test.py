"""Stresses in results: histories, frames, envelopes over all steps and the sections they are of; as a user sees them."""

import unittest

import h5py
import numpy as np

from program import ProgramTest

STEEL = "material = { E = 2.1e11, nu = 0.3, density = 7850 }"
LIMITED = '[material.steel]\nE = 2.1e11\nnu = 0.3\ndensity = 7850\nyield_stress = 235e6\n'
CANTILEVER = """[section.beam]
SHAPE
[rod.beam]
section = "beam"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 8
order = 2
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam.end"
force = [0, 0, -1]
[analysis]
kind = "static"
steps = 1
[output]
stresses = "von-mises"
[[history]]
name = "root"
at = "beam.start"
quantities = ["force", "moment", "stress", "von_mises", "principal_stress", "stress_place"]
"""
# A rod that is let go, so that its root sees the most half a period later.
FALL = CANTILEVER.replace('kind = "static"\nsteps = 1', 'kind = "dynamic"\nend_time = 0.2\nsteps = 200').replace(
    "stresses = ", "every = 50\nstresses = ").replace("[0, 0, -1]", "[0, 0, -100]")


def deck(shape, text=CANTILEVER):
    return text.replace("SHAPE", shape)


def circle(radius=0.02):
    return f"shape = {{ circle = {{ radius = {radius} }} }}\n{STEEL}"


def measure(operators, resultants):
    """The von Mises stress of each point."""
    xx, yy, zz, yz, xz, xy = (operators.reshape(-1, 6, 6).astype(float) @ resultants).T
    return np.sqrt(((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) / 2 + 3 * (yz**2 + xz**2 + xy**2))


class Stresses(ProgramTest):
    def run_deck(self, text, *options):
        self.write("beam.toml", text)
        done = self.gxrod("run", "beam.toml", "--force", *options)
        file = h5py.File(self.folder / "beam.vtkhdf")
        self.addCleanup(file.close)
        return file, done

    def faults(self, text):
        self.write("beam.toml", text)
        return self.gxrod("check", "beam.toml", code=2).stderr

    def test_the_root_of_a_cantilever_has_the_stresses_of_its_closed_forms(self):
        cases = {
            "circle": (circle(), 2 / (np.pi * 0.02**3 / 4), 0.02),
            "tube": (f"shape = {{ tube = {{ outer_radius = 0.03, inner_radius = 0.025 }} }}\n{STEEL}",
                     2 / (np.pi * (0.03**4 - 0.025**4) / 4 / 0.03), 0.03),
            "rectangle": (f"shape = {{ rectangle = {{ width_y = 0.03, height_z = 0.06 }} }}\n{STEEL}",
                          2 / (0.03 * 0.06**2 / 6), 0.03),
        }
        for name, (shape, largest, top) in cases.items():
            with self.subTest(name):
                file, _ = self.run_deck(deck(shape))
                root = file["histories/root"]
                self.assertAlmostEqual(root["von_mises"][-1] / largest, 1, delta=2e-4)
                self.assertAlmostEqual(abs(root["stress"][-1, 0]) / largest, 1, delta=2e-4)
                self.assertAlmostEqual(abs(root["stress_place"][-1, 1]), top, delta=1e-6)
                self.assertAlmostEqual(np.abs(root["principal_stress"][-1]).max() / largest, 1, delta=2e-4)

    def test_a_point_of_the_section_has_its_own_stress(self):
        shape = f"shape = {{ rectangle = {{ width_y = 0.03, height_z = 0.06 }} }}\n{STEEL}"
        for place, component, expected in (("[0, 0.03]", 0, 2 / (0.03 * 0.06**2 / 6)), ("[0, -0.03]", 0, -2 / (0.03 * 0.06**2 / 6)),
                                           ("[0.015, 0]", 0, 0)):
            file, _ = self.run_deck(deck(shape) + f"point = {place}\n")
            stress = file["histories/root/stress"][-1]
            self.assertAlmostEqual(stress[component], expected, delta=1e-3 * 2 / (0.03 * 0.06**2 / 6))
            self.assertEqual(file["histories/root"].attrs["point"][0], "[")
        # Shear along z at the axis: with nu = 0 the parabola, 3/2 V/A, for any width.
        file, _ = self.run_deck(deck(shape).replace("nu = 0.3", "nu = 0") + "point = [0, 0]\n")
        self.assertAlmostEqual(file["histories/root/stress"][-1, 4] / (-1.5 / (0.03 * 0.06)), 1, delta=1e-4)

    def test_envelopes_are_the_worst_of_all_steps(self):
        file, done = self.run_deck(deck(circle(), FALL))
        envelope, sections = file["envelopes"], file["sections"]
        self.assertEqual(list(sections["name"].asstr()), ["beam"])
        self.assertEqual(len(envelope["rod"]), 3 * 8)
        np.testing.assert_allclose(envelope["arc_length"][:3], [0, 0.125, 0.25], atol=1e-12)
        root = file["histories/root"]
        largest = root["von_mises"][:].max()
        self.assertEqual(envelope["von_mises/value"][0], largest)
        self.assertEqual(envelope["von_mises/time"][0], file["histories/time"][root["von_mises"][:].argmax()])
        self.assertIn(f"largest von Mises stress {largest:.6g} on beam, s = 0", done.stdout)
        # By the file alone.
        operators = sections["0/stress_operator"][:][sections["0/is_singular"][:] == 0]
        for place, resultants in enumerate(envelope["von_mises/resultants"][:]):
            expected = measure(operators, resultants).max()
            self.assertAlmostEqual(envelope["von_mises/value"][place] / expected, 1, delta=1e-6)
        # Frames show some of the steps, at the middles of elements.
        cells = file["VTKHDF/CellData"]
        frames = cells["von_mises"][:].reshape(-1, 8)
        self.assertTrue((frames.max(axis=0) <= envelope["von_mises/value"][1::3] * (1 + 1e-9)).all())
        forces = np.hstack([cells["force"][:], cells["moment"][:]])
        np.testing.assert_allclose(cells["von_mises"][:], [measure(operators, one).max() for one in forces], rtol=1e-6)
        self.assertTrue((cells["section"][:] == 0).all())
        self.assertTrue(np.isnan(envelope["exposure/value"][:]).all())

    def test_cells_of_a_section_cover_it(self):
        file, _ = self.run_deck(deck(circle()))
        section = file["sections/0"]
        y, z = section["nodes"][:][section["cells"][:]].transpose(2, 0, 1)
        area = sum(np.roll(y, -1, axis=1)[i] @ z[i] - y[i] @ np.roll(z, -1, axis=1)[i] for i in range(len(y))) / -2
        self.assertAlmostEqual(area / (np.pi * 0.02**2), 1, delta=0.02)  # straight sides between corners
        at = section["points"][:][section["cell_points"][:]]
        np.testing.assert_allclose(at, section["nodes"][:][section["cells"][:]], atol=1e-12)
        self.assertEqual(section.attrs["source"], "circle")

    def test_a_resumed_run_has_the_envelopes_of_one_that_never_stopped(self):
        long = deck(circle(), FALL)
        self.write("whole.toml", long)
        self.gxrod("run", "whole.toml")
        self.write("part.toml", long.replace("end_time = 0.2\nsteps = 200", "end_time = 0.1\nsteps = 100"))
        self.gxrod("run", "part.toml")
        self.gxrod("resume", "part.vtkhdf", "--set", "analysis.end_time=0.2", "--set", "analysis.steps=200")
        with h5py.File(self.folder / "whole.vtkhdf") as whole, h5py.File(self.folder / "part.vtkhdf") as part:
            for name in ("value", "time", "point", "layer", "resultants"):
                np.testing.assert_array_equal(whole[f"envelopes/von_mises/{name}"][:], part[f"envelopes/von_mises/{name}"][:])

    def test_stresses_cannot_begin_or_end_within_a_run(self):
        text = deck(circle(), FALL)
        self.write("with.toml", text)
        self.write("without.toml", text.replace('stresses = "von-mises"\n', ""))
        self.gxrod("run", "with.toml")
        self.gxrod("run", "without.toml")
        longer = ("--set", "analysis.end_time=0.3", "--set", "analysis.steps=300")
        self.assertIn("output.stresses cannot be left out",
                      self.gxrod("resume", "with.vtkhdf", "--deck", "without.toml", *longer, code=4).stderr)
        self.assertIn("the file has steps without stresses",
                      self.gxrod("resume", "without.vtkhdf", "--deck", "with.toml", *longer, code=4).stderr)

    def test_exposure_is_by_yield_stress_and_a_failure_is_a_warning(self):
        walls = LIMITED + """[layup.sheet]
plies = [["steel", 3e-3, 0]]
[section.beam]
walls = { corners = [[-0.03, -0.03], [0.03, -0.03], [0.03, 0.03], [-0.03, 0.03]], closed = true, layup = "sheet" }
"""
        text = CANTILEVER.replace("[section.beam]\nSHAPE\n", walls).replace(
            "walls = {", "shape.walls = {").replace("[0, 0, -1]", "[0, 0, -1e3]")
        file, done = self.run_deck(text)
        envelope = file["envelopes"]
        np.testing.assert_allclose(envelope["exposure/value"][:] * 235e6, envelope["von_mises/value"][:], rtol=1e-9)
        self.assertNotIn("warning", done.stderr)
        _, done = self.run_deck(text.replace("-1e3", "-4e4"))
        self.assertRegex(done.stderr, r"warning: exposure \d+\.\d+ on beam, s = 0, .*: the material fails there, and the run "
                                      "takes it as elastic")

    def test_a_tapered_rectangle_has_the_stress_of_each_place(self):
        shape = 'shape = { rectangle = { width_y = 0.03, height_z = "0.06*(1 - s/4)" } }\n' + STEEL
        file, _ = self.run_deck(deck(shape))
        s = file["envelopes/arc_length"][:]
        expected = (2 - s) / (0.03 * (0.06 * (1 - s / 4))**2 / 6)
        found = file["envelopes/von_mises/value"][:]
        root = expected.max()
        inside = s < 1.7  # beyond it shear is larger than bending
        np.testing.assert_allclose(found[inside] / root, expected[inside] / root, atol=5e-4)
        self.assertIn("beam along beam, s = 0", list(file["sections/name"].asstr()))

    def test_between_two_stations_stresses_are_of_both(self):
        text = CANTILEVER.replace("[section.beam]\nSHAPE", f"""[section.thick]
shape = {{ rectangle = {{ width_y = 0.03, height_z = 0.06 }} }}
{STEEL}
[section.thin]
shape = {{ rectangle = {{ width_y = 0.03, height_z = 0.05 }} }}
{STEEL}""").replace('section = "beam"', 'sections = [[0, "thick"], [1, "thin"]]')
        file, _ = self.run_deck(text)
        s = file["envelopes/arc_length"][:]
        inertia = [0.03 * height**3 / 12 for height in (0.06, 0.05)]
        curvature = (2 - s) / (2.1e11 * ((1 - s / 2) * inertia[0] + s / 2 * inertia[1]))
        expected = 2.1e11 * curvature * ((1 - s / 2) * 0.03 + s / 2 * 0.025)
        inside = s < 1.7
        np.testing.assert_allclose(file["envelopes/von_mises/value"][:][inside], expected[inside], rtol=5e-4)

    def test_a_tube_under_pressure_has_lame_s_stresses(self):
        """A pipe upright in water, full of mud under pressure, with its own weight, pulled and bent at its top; gravity grows twice."""
        a, b, p0, mud, water, surface = 0.08, 0.1, 3e6, 1300.0, 1025.0, 20.0
        places = {"inside": (0.08, 0.0), "outside": (0.0, -0.1), "between": (0.064, 0.064)}
        file, _ = self.run_deck(f"""gravity = {{ acceleration = [0, 0, -9.81], factor = {{ hang = "t", heavier = "1 + t" }} }}
[fluid]
density = {water}
surface = {surface}
[material.steel]
E = 2.1e11
nu = 0.3
density = 7850
yield_stress = 235e6
elastic = true
[section.pipe]
shape = {{ tube = {{ outer_radius = {b}, inner_radius = {a} }} }}
material = "steel"
fluid = {{ contents = {{ density = {mud}, pressure = {p0} }} }}
[rod.pipe]
section = "pipe"
line = {{ from = [0, 0, 0], to = [0, 0, 30] }}
y_axis = [1, 0, 0]
elements = 10
order = 2
[[support]]
at = "pipe.start"
fix = "all"
[[load]]
at = "pipe.end"
force = [1500, 800, 2e5]
moment = [0, 0, 3e3]
[[stage]]
name = "hang"
kind = "static"
steps = 2
[[stage]]
name = "heavier"
kind = "static"
steps = 2
""" + "".join(f'[[history]]\nname = "{name}"\nat = "pipe@0.3"\npoint = [{y}, {z}]\nquantities = ["position", "force", "moment", "stress", "von_mises", "principal_stress", "stress_place", "exposure"]\n'
              for name, (y, z) in places.items()) + '[[history]]\nname = "worst"\nat = "pipe@0.3"\nquantities = ["von_mises", "stress_place"]\n')
        area, inertia = np.pi * (b**2 - a**2), np.pi / 4 * (b**4 - a**4)
        largest = 0.0
        for name in places:
            get = lambda quantity, name=name: file[f"histories/{name}/{quantity}"][-1]
            (N, Vy, Vz), (T, My, Mz), (y, z) = get("force"), get("moment"), get("stress_place")
            head = 2 * 9.81 * (surface - get("position")[2])
            inside, outside = p0 + mud * head, water * head
            r = np.hypot(y, z)
            mean, change = (inside * a**2 - outside * b**2) / (b**2 - a**2), (inside - outside) * a**2 * b**2 / (b**2 - a**2) / r**2
            wall = N + inside * np.pi * a**2 - outside * np.pi * b**2
            axial = wall / area + My * z / inertia - Mz * y / inertia
            stress = get("stress")
            across, turn = np.array([[stress[1], stress[3]], [stress[3], stress[2]]]), np.array([[y, -z], [z, y]]) / r
            np.testing.assert_allclose(turn.T @ across @ turn, np.diag([mean - change, mean + change]), rtol=0, atol=5e-5 * abs(axial))
            self.assertLess(abs(stress[0] - axial), 5e-5 * abs(axial))  # the cells of the section
            shear = stress[4]**2 + stress[5]**2
            mises = np.sqrt(((axial - mean - change)**2 + (axial - mean + change)**2 + (2 * change)**2) / 2 + 3 * shear)
            np.testing.assert_allclose(get("von_mises"), mises, rtol=1e-4)
            np.testing.assert_allclose(get("exposure"), get("von_mises") / 235e6, rtol=1e-12)
            self.assertGreater(change, 1e6)
            largest = max(largest, float(mises))
        self.assertGreaterEqual(file["histories/worst/von_mises"][-1], largest * (1 - 1e-12))

    def test_what_has_no_stress_is_said(self):
        numbers = "stiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }"
        faults = self.faults(deck(numbers))
        self.assertIn("output.stresses: no rod has stresses: beam (its section has numbers and no shape)", faults)
        self.assertIn('"stress": the section has numbers and no shape', faults)
        law = "shape = { circle = { radius = 0.02 } }\nmaterial = { E = 2.1e11, nu = 0.3, yield_stress = 2e8 }"
        faults = self.faults(deck(law))
        self.assertIn("beam (its section has a law, ", faults)
        file, done = self.run_deck(deck(law.replace("2e8", "2e8, elastic = true")))
        np.testing.assert_allclose(file["envelopes/exposure/value"][:] * 2e8, file["envelopes/von_mises/value"][:], rtol=1e-9)
        self.assertIn("largest exposure", done.stdout)
        self.assertIn('"von_mises": the section has a law, ', faults)
        wet = deck("shape = { tube = { outer_radius = 0.02, inner_radius = 0.01 } }\nfluid = { outer_diameter = 0.06, drag = 1 }\n" + STEEL)
        wet += "[fluid]\ndensity = 1000\nsurface = 10\n"
        pressure = "is under the pressure of water, and hollow: it displaces more than its material fills"
        self.assertIn('"von_mises": the section ' + pressure, self.faults("gravity = [0, 0, -9.81]\n" + wet))
        self.assertIn("output.stresses: no rod has stresses: beam (its section " + pressure,
                      self.faults("gravity = [0, 0, -9.81]\n" + wet))
        full = wet.replace("drag = 1", "contents = { density = 1000 }")
        self.assertIn("is under the pressure of its contents, and no round tube that they fill", self.faults("gravity = [0, 0, -9.81]\n" + full))
        dry = full.replace("outer_diameter = 0.06, ", "").replace("[fluid]\ndensity = 1000\nsurface = 10\n", "[seabed]\nz = -1\nstiffness = 1e6\n")
        self.assertIn("is under the pressure of its contents, which is found in water or air alone; expected [fluid] or [air]",
                      self.faults("gravity = [0, 0, -9.81]\n" + dry))
        tube = wet.replace("outer_diameter = 0.06, ", "")
        self.assertIn("no rod has stresses: beam (its section is a tube under pressure, whose stresses a [[history]] of a point has)",
                      self.faults("gravity = [0, 0, -9.81]\n" + tube))
        self.assertIn('expected one of "von-mises", "tsai-wu", "hashin", "max-stress", found "von-mieses"; did you mean "von-mises"?',
                      self.faults(deck(circle()).replace('"von-mises"', '"von-mieses"')))
        self.assertIn('"exposure": no material of the section has yield_stress or strength',
                      self.faults(deck(circle()).replace('"stress_place"', '"exposure"')))
        self.assertIn("history[0].point: goes with stress, von_mises, principal_stress or exposure, which are not among",
                      self.faults(deck(circle()).replace('"force", "moment", "stress", "von_mises", "principal_stress", '
                                                         '"stress_place"', '"force"') + "point = [0, 0]\n"))

    def test_a_solid_rod_in_water_is_pressed_from_all_sides(self):
        # A bar that hangs upright in deep water, closed at its end: p all around at its lower end, its weight less buoyancy above.
        text = "gravity = [0, 0, -9.81]\n" + deck("shape = { circle = { radius = 0.02 } }\nfluid = { drag = 1 }\n" + STEEL).replace(
            "to = [2, 0, 0]", "to = [0, 0, -2]").replace('[[load]]\nat = "beam.end"\nforce = [0, 0, -1]\n', "") + "[fluid]\ndensity = 1000\nsurface = 1000\n"
        file, _ = self.run_deck(text)
        pressure, pull = 1000 * 9.81 * 1000, (7850 - 1000) * 9.81 * 2
        stress = file["histories/root/stress"][-1]
        np.testing.assert_allclose(stress, [pull - pressure, -pressure, -pressure, 0, 0, 0], atol=2e-4 * pressure)
        np.testing.assert_allclose(stress[0] - stress[1], pull, rtol=1e-3)
        np.testing.assert_allclose(file["histories/root/von_mises"][-1], pull, rtol=1e-3)
        np.testing.assert_allclose(file["histories/root/principal_stress"][-1], [pull - pressure, -pressure, -pressure], rtol=1e-3)

    def test_rods_without_stress_are_a_note(self):
        text = deck(circle()) + """[section.other]
stiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }
[rod.other]
section = "other"
line = { from = [0, 1, 0], to = [1, 1, 0] }
elements = 2
[[support]]
at = "other.start"
fix = "all"
"""
        file, _ = self.run_deck(text)
        self.assertEqual(set(file["envelopes/rod"][:]), {0})
        self.assertEqual(list(file["VTKHDF/CellData/section"][:]), [0] * 8 + [-1] * 2)
        self.assertTrue(np.isnan(file["VTKHDF/CellData/von_mises"][-2:]).all())
        done = self.gxrod("check", "beam.toml")
        self.assertIn("stresses along rods, exposure by von-mises", done.stdout)
        self.assertIn("output.stresses: not those of other (its section has numbers and no shape)", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
