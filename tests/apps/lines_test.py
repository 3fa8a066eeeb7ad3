"""What is known along lines and at their ends: touch-down, ranges, tensions of walls, forces of the ground; as a user sees it."""

import csv
import unittest

import h5py
import numpy as np

from program import ProgramTest

DEPTH, SPAN, LENGTH, WEIGHT, EA, DIAMETER, STIFFNESS = 100.0, 300.0, 335.0, 1000.0, 5e8, 0.14, 1e7
DECK = """gravity = [0, 0, -9.81]
[fluid]
density = 1025
surface = 0
[seabed]
z = -100
stiffness = 1e7
[section.chain]
stiffness = { EA = 5e8, GAy = 2e8, GAz = 2e8, GJ = 10, EIy = 10, EIz = 10 }
inertia = { rhoA = RHOA, rhoIy = 0.2, rhoIz = 0.2 }
fluid = { outer_diameter = 0.14, drag = { normal = 1.3, tangential = 0.4 } }
[rod.mooring]
section = "chain"
catenary = { from = [0, 0, -99.93], to = [300, 0, -2], length = 335, bed = true }
elements = 120
order = 2
[[support]]
at = "mooring.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "mooring.end"
fix = ["y", "rx", "rz"]
[[support]]
at = "mooring.end"
move = { x = "2*sin(0.6*t)*min(t/5, 1)^2" }
fix = "z"
stages = "sway"
[[support]]
at = "mooring.end"
fix = ["x", "z"]
stages = "hang"
[output]
line_ends = ["mooring"]
[[history]]
name = "ground"
at = "mooring"
quantities = ["touch_down_start", "touch_down_end", "touch_down_end_position"]
[[history]]
name = "middle"
at = "mooring@0.004166666666666667"
quantities = ["wall_tension", "effective_tension"]
[[history]]
name = "lies"
at = "mooring@0.1"
quantities = ["bed_force"]
[[stage]]
name = "hang"
kind = "static"
steps = 1
[[stage]]
name = "sway"
kind = "dynamic"
end_time = 6
time_step = 0.1
integrator = "generalized-alpha"
""".replace("RHOA", repr(WEIGHT / 9.81 + 1025 * np.pi * 0.07**2))
PLAIN = """[section.beam]
stiffness = { EA = 1e4, GAy = 6e3, GAz = 5e3, GJ = 80, EIy = 100, EIz = 140 }
[rod.beam]
section = "beam"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam.end"
force = [0, 3, -4]
[analysis]
kind = "static"
steps = 2
[output]
line_ends = ["beam"]
"""


def lying_length():
    """How much of an elastic line without bending lies on hard, smooth ground."""
    height = DEPTH - 0.5 * DIAMETER - 2.0

    def reach(horizontal, suspended):
        vertical = WEIGHT * suspended
        size = np.hypot(horizontal, vertical)
        x = horizontal / WEIGHT * np.arcsinh(vertical / horizontal) + horizontal * suspended / EA
        z = (size - horizontal) / WEIGHT + WEIGHT * suspended**2 / (2 * EA)
        lying = LENGTH - suspended
        return lying * (1 + horizontal / EA) + x, z

    low, high = 50.0, LENGTH
    for _ in range(200):  # the suspended length, with the force that reaches the span
        suspended = 0.5 * (low + high)
        weak, strong = 1e3, 1e8
        for _ in range(200):
            horizontal = np.sqrt(weak * strong)
            weak, strong = (horizontal, strong) if reach(horizontal, suspended)[0] < SPAN else (weak, horizontal)
        low, high = (suspended, high) if reach(horizontal, suspended)[1] < height else (low, suspended)
    return LENGTH - suspended, horizontal


PIPE = """[parameters]
v = 1.0
[section.pipe]
stiffness = { EA = 1e7, GAy = 1e7, GAz = 1e7, GJ = 1, EIy = 1, EIz = 1 }
inertia = { rhoA = RHOA, rhoIy = 1e-9, rhoIz = 1e-9 }
fluid = { outer_diameter = 0.02, contents = { density = DENSITY, inner_diameter = 0.01, velocity = "v" } }
[rod.pipe]
section = "pipe"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 16
order = 3
SUPPORTS
[[stage]]
name = "flow"
kind = "static"
[[stage]]
name = "onset"
kind = "eigenvalues"
count = 2
sweep = { key = "parameters.v", from = FROM, to = TO, count = 9 }
"""
PINNED = """[[support]]
at = "pipe.start"
fix = ["position", "rx", "ry"]
[[support]]
at = "pipe.end"
fix = ["y", "z", "rx", "ry"]
"""
CLAMPED = '[[support]]\nat = "pipe.start"\nfix = "all"\n'
INLET = CLAMPED + '[[history]]\nname = "inlet"\nat = "pipe.start"\nquantities = ["reaction_force"]\n'
ROPE = """[section.rope]
stiffness = { EA = 5e4, GAy = 2e4, GAz = 2e4, GJ = 10, EIy = 10, EIz = 10 }
inertia = { rhoA = 1, rhoIy = 1e-4, rhoIz = 1e-4 }
law = { tension_strain = { TABLE } }
[rod.rope]
section = "rope"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 4
[[support]]
at = "rope.start"
fix = "all"
[[support]]
at = "rope.end"
fix = ["y", "z", "rx", "ry", "rz"]
[[load]]
at = "rope.end"
force = ["1500*sin(pi*min(2*t, 1)) - 0.01*t", 0, 0]
[analysis]
kind = "static"
steps = 40
[[history]]
name = "end"
at = "rope.end"
quantities = ["force", "strain"]
"""
TABLE = "table = [[0, 0], [0.01, 200], [0.03, 1000], [0.04, 2000]]"


def pipe(supports, mass, own, first, last):
    return PIPE.replace("SUPPORTS", supports).replace("DENSITY", repr(4 * mass / np.pi / 0.01**2)).replace("RHOA", repr(own)).replace(
        "FROM", repr(first)).replace("TO", repr(last))


def flutter_of_cantilever(beta, speed, omega):
    """Where w'''' + u² w'' + 2 √β u iω w' - ω² w = 0 of a cantilever has a real ω: (u, ω), from a guess."""
    def determinant(x):
        r = np.roots([1, 0, x[0]**2, 2j * np.sqrt(beta) * x[0] * x[1], -x[1]**2])
        return np.linalg.det(np.array([np.ones(4), r, r**2 * np.exp(r), r**3 * np.exp(r)])) / np.prod([r[i] - r[j] for i in range(4) for j in range(i)])

    x = np.array([speed, omega], float)
    for _ in range(50):
        columns = [(determinant(x + h) - determinant(x - h)) / 2e-6 for h in 1e-6 * np.eye(2)]
        value = determinant(x)
        x -= np.linalg.solve([[c.real for c in columns], [c.imag for c in columns]], [value.real, value.imag])
    return x


class Lines(ProgramTest):
    def run_deck(self, text, name="line"):
        self.write(f"{name}.toml", text)
        self.told = self.gxrod("run", f"{name}.toml", "--force").stdout
        file = h5py.File(self.folder / f"{name}.vtkhdf")
        self.addCleanup(file.close)
        return file

    def read(self, name):
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def test_mooring(self):
        file = self.run_deck(DECK)
        times = file["histories/time"][()]
        settled = np.flatnonzero(times <= 0)[-1]
        self.assertIn("mooring lies on the ground up to s = ", self.told)

        lying, horizontal = lying_length()
        end = file["histories/ground/touch_down_end"][()]
        tension = file["histories/mooring_start/effective_tension"][settled]
        self.assertAlmostEqual(tension / horizontal, 1.0, delta=1e-3)
        # A line rises from where it is pressed in to the surface of the ground over √(2 H depth/w).
        depth = WEIGHT / (STIFFNESS * DIAMETER)
        self.assertAlmostEqual(end[settled] - np.sqrt(2 * horizontal * depth / WEIGHT), lying, delta=0.15)
        self.assertTrue((file["histories/ground/touch_down_start"][()] == 0.0).all())
        np.testing.assert_allclose(file["histories/ground/touch_down_end_position"][:, 2], -99.93, atol=1e-6)
        # It follows the motion between nodes, 1.4 apart.
        moving = np.diff(end[settled:])
        self.assertGreater(np.ptp(end[settled:]), 5.0)
        self.assertLess(np.abs(moving).max(), 1.39)
        self.assertGreater((np.abs(moving) > 1e-9).mean(), 0.9)

        # Frames have what histories have at the same places.
        cells, points = int(file["VTKHDF/NumberOfCells"][0]), int(file["VTKHDF/NumberOfPoints"][0])
        walls = file["VTKHDF/CellData/wall_tension"][()].reshape(-1, cells)
        forces = file["VTKHDF/CellData/force"][()].reshape(-1, cells, 3)
        frame_times = file["VTKHDF/Steps/Values"][()]
        rows = [int(np.abs(times - time).argmin()) for time in frame_times[1:]]
        pressure = file["histories/middle/wall_tension"][()] - file["histories/middle/effective_tension"][()]
        np.testing.assert_allclose((walls - forces[..., 0])[1:, 0], pressure[rows], rtol=1e-9)
        beds = file["VTKHDF/PointData/bed_force"][()].reshape(-1, points, 3)
        node = int(np.flatnonzero(np.isclose(file["VTKHDF/PointData/arc_length"][()], 33.5))[0])
        np.testing.assert_allclose(beds[1:, node], file["histories/lies/bed_force"][()][rows], rtol=1e-9, atol=1e-6)

        # Tables say what the numbers say.
        self.gxrod("export", "line.vtkhdf", "--ranges", "ranges", "--stage", "sway")
        table = self.read("ranges/range_mooring.csv")
        timed = frame_times >= 0
        for name, values in (("effective_tension", forces[timed][..., 0]), ("wall_tension", walls[timed])):
            column = lambda ending: [float(row[name + ending]) for row in table]
            np.testing.assert_array_equal(column("_least"), values.min(axis=0))
            np.testing.assert_array_equal(column("_largest"), values.max(axis=0))
            np.testing.assert_allclose(column("_mean"), values.mean(axis=0), rtol=1e-12)
            np.testing.assert_array_equal(column("_time_of_largest"), frame_times[timed][values.argmax(axis=0)])
        told = self.gxrod("line-ends", "line.vtkhdf", "--csv", "ends.csv", "--from", "1", "--to", "4").stdout
        self.assertIn("mooring.start", told)
        window = (times >= 1 - 1e-9) & (times <= 4 + 1e-9)
        rows = {(row["point"], row["quantity"]): row for row in self.read("ends.csv")}
        top = file["histories/mooring_end"]
        axis = top["axis_x"][()]
        for quantity, values in (("effective_tension", top["effective_tension"][()]), ("shear_force", top["shear_force"][()]),
                                 ("declination", np.degrees(np.arccos(axis[:, 2])))):
            row = rows["mooring.end", quantity]
            for key, number in (("static", values[settled]), ("least", values[window].min()), ("largest", values[window].max()),
                                ("mean", values[window].mean()), ("time_of_largest", times[window][values[window].argmax()])):
                self.assertAlmostEqual(float(row[key]), number, delta=1e-9 * max(1.0, abs(number)))
        row = rows["mooring", "touch_down_end"]
        self.assertAlmostEqual(float(row["largest"]), end[window].max(), delta=1e-9)
        self.gxrod("report", "line.vtkhdf", "--force")
        page = (self.folder / "line.html").read_text(encoding="utf-8")
        self.assertIn('"title":"Ends of lines"', page)
        self.assertIn(f'{float(rows["mooring.end", "effective_tension"]["static"]):.6g}', page)
        for quantity, component in (("shear_force", "force"), ("bending_moment", "moment")):
            spatial = top[f"{component}_spatial"][()]
            across = np.linalg.norm(spatial - (spatial * axis).sum(axis=1)[:, None] * axis, axis=1)
            np.testing.assert_allclose(top[quantity][()], across, atol=1e-9 * np.abs(spatial).max())

    def test_without_water(self):
        file = self.run_deck(PLAIN)
        self.assertNotIn("wall_tension", file["VTKHDF/CellData"])
        self.assertNotIn("bed_force", file["VTKHDF/PointData"])
        self.assertNotIn("wall_tension", file["histories/beam_start"])
        self.gxrod("line-ends", "line.vtkhdf", "--csv", "ends.csv")
        rows = {(row["point"], row["quantity"]): row for row in self.read("ends.csv")}
        self.assertAlmostEqual(float(rows["beam.end", "shear_force"]["static"]), 5.0, delta=0.03)
        self.assertAlmostEqual(float(rows["beam.start", "bending_moment"]["largest"]), 10.0, delta=0.05)
        self.assertAlmostEqual(float(rows["beam.end", "azimuth"]["static"]), np.degrees(3 * 4 / 2 / 140), delta=0.01)

    def onset(self, text):
        onset = self.run_deck(text, "pipe")["stages/onset/onset"]
        return onset["value"][0], onset["omega"][0]

    def test_flow_in_pipes(self):
        speed, _ = self.onset(pipe(PINNED, 2.0, 1.0, 1.0, 2.6))
        self.assertAlmostEqual(speed / (np.pi / np.sqrt(2)), 1.0, delta=1e-6)
        for beta, guess in ((0.2, (5.6, 13.7)), (0.5, (9.3, 26.5))):
            exact, omega = flutter_of_cantilever(beta, *guess)
            speed, found = self.onset(pipe(CLAMPED, beta, 1 - beta, 0.9 * guess[0] / np.sqrt(beta), 1.1 * guess[0] / np.sqrt(beta)))
            self.assertAlmostEqual(speed * np.sqrt(beta) / exact, 1.0, delta=1e-5)
            self.assertAlmostEqual(found / omega, 1.0, delta=1e-5)

    def test_thrust_of_flow(self):
        # The support of a quarter bend, held at its inlet, turns the momentum m v² from x to y.
        bend = pipe(INLET, 2.0, 1.0, 1.0, 2.0).split("[[stage]]")[0] + '[analysis]\nkind = "static"\nsteps = 2\n'
        bend = bend.replace("v = 1.0", "v = 0.01").replace(
            "line = { from = [0, 0, 0], to = [1, 0, 0] }", "arc = { centre = [0, 1, 0], from = [0, 0, 0], angle = 1.5707963267948966, axis = [0, 0, 1] }")
        force = self.run_deck(bend, "bend")["histories/inlet/reaction_force"][-1]
        np.testing.assert_allclose(force, [-2e-4, 2e-4, 0], atol=1e-7)

    def test_ropes(self):
        file = self.run_deck(ROPE.replace("TABLE", TABLE))
        strain, force = file["histories/end/strain"][:, 0], file["histories/end/force"][:, 0]
        np.testing.assert_allclose(force, np.interp(strain, [-1, 0, 0.01, 0.03, 0.04], [-2e4, 0, 200, 1000, 2000]), atol=1e-9)
        self.assertAlmostEqual(file["ledger/dissipated_energy"][-1], 0.0, delta=1e-9)
        stretched = self.run_deck(ROPE.replace("TABLE", TABLE + ", unloading_stiffness = 1.5e5"), "stretched")
        strain, force = stretched["histories/end/strain"][:, 0], stretched["histories/end/force"][:, 0]
        top = int(force.argmax())
        np.testing.assert_allclose(force[top:20], force[top] - 1.5e5 * (strain[top] - strain[top:20]), atol=1e-6)
        # All of the work but that of unloading stays in the rope: per length ∫ N dε - N²/2E.
        work = 1.0 + 12.0 + 0.5 * (strain[top] - 0.03) * (1000 + force[top])
        self.assertAlmostEqual(stretched["ledger/dissipated_energy"][-1], 10 * (work - 0.5 * force[top]**2 / 1.5e5), delta=1e-6)
        for table, fault in (("table = [[0, 0]]", "table[0]: expected a row of positive strain after this one"),
                             ("table = [[0.01, 1], [0.02, 2]]", "table[0]: expected a row [0, 0]"),
                             ("table = [[0, 0], [0.01, 10], [0.02, 5]]", "the tension must not fall from row to row: 5 follows 10"),
                             (TABLE + ", unloading_stiffness = 10", "the steepest slope of the table")):
            self.write("wrong.toml", ROPE.replace("TABLE", table))
            self.assertIn(fault, self.gxrod("check", "wrong.toml", code=2).stderr)

    def test_a_rope_that_hangs(self):
        weight = (300 - 1025 * np.pi * 0.1**2) * 9.81
        text = """gravity = [0, 0, -9.81]
[fluid]
density = 1025
surface = 0
[section.rope]
stiffness = { EA = 2e7, GAy = 1e6, GAz = 1e6, GJ = 10, EIy = 10, EIz = 10 }
inertia = { rhoA = 300, rhoIy = 0.2, rhoIz = 0.2 }
fluid = { outer_diameter = 0.2 }
law = { tension_strain = { table = [[0, 0], [0.01, 2e5], [0.03, 1e6], [0.04, 2e6]] } }
[rod.rope]
section = "rope"
catenary = { from = [0, 0, -100], to = [150, 0, -0.01], length = 182 }
elements = 60
order = 2
[[support]]
at = "rope.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "rope.end"
fix = ["position", "rx", "rz"]
[output]
line_ends = ["rope"]
[analysis]
kind = "static"
steps = 1
"""
        points, weights = np.polynomial.legendre.leggauss(4)
        s = (np.arange(200)[:, None] + 0.5 * (1 + points)).ravel() * 182 / 200
        share = np.tile(0.5 * weights * 182 / 200, 200)

        def miss(x):
            vertical = x[1] + weight * s
            tension = np.hypot(x[0], vertical)
            stretched = share * (1 + np.interp(tension, [0, 2e5, 1e6, 2e6], [0, 0.01, 0.03, 0.04])) / tension
            return np.array([(stretched * x[0]).sum() - 150, (stretched * vertical).sum() - 99.99])

        x = np.array([3e5, 5e4])
        for _ in range(30):
            x -= np.linalg.solve(np.transpose([(miss(x + h) - miss(x)) / 10 for h in 10 * np.eye(2)]), miss(x))
        file = self.run_deck(text, "rope")
        self.assertAlmostEqual(file["histories/rope_start/effective_tension"][-1] / np.hypot(*x), 1, delta=1e-5)
        self.assertAlmostEqual(file["histories/rope_end/effective_tension"][-1] / np.hypot(x[0], x[1] + 182 * weight), 1, delta=1e-6)

    def test_faults(self):
        def told(text):
            self.write("wrong.toml", text)
            return self.gxrod("check", "wrong.toml", code=2).stderr

        self.assertIn('output.line_ends: no rod "bam"; did you mean "beam"?', told(PLAIN.replace('line_ends = ["beam"]', 'line_ends = "bam"')))
        taken = PLAIN + '[[history]]\nname = "beam_end"\nat = "beam.end"\nquantities = ["position"]\n'
        self.assertIn('output.line_ends: a [[history]] has the name "beam_end", which is that of beam.end; give it another', told(taken))
        # Without water and ground a rod is not a thing of a history.
        whole = PLAIN + '[[history]]\nname = "h"\nat = "beam"\nquantities = ["touch_down_end"]\n'
        self.assertIn('history[0].at: "beam" is a rod; expected a point of it', told(whole))
        self.assertIn("only rods as a whole have it", told(whole.replace('at = "beam"', 'at = "beam.end"')))
        contact = DECK.replace('"touch_down_start", ', '"contact_force", ')
        self.assertIn("the deck has no [contact]", told(contact))
        self.write("beam.toml", PLAIN.replace('line_ends = ["beam"]', "every = 1"))
        self.gxrod("run", "beam.toml", "--force")
        self.assertIn("has no ends of lines (run it with line_ends", self.gxrod("line-ends", "beam.vtkhdf", code=4).stderr)
        self.assertIn("has no step from 7 to 1", self.gxrod("export", "beam.vtkhdf", "--ranges", "r", "--from", "7", code=4).stderr)
        self.assertIn("has no stage storm (its deck has no stages)", self.gxrod("export", "beam.vtkhdf", "--ranges", "r", "--stage", "storm", code=4).stderr)


if __name__ == "__main__":
    unittest.main()
