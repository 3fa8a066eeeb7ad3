"""What results say of contact: /contacts, histories of rods, what the check says; as a user sees it."""

import base64
import re
import unittest

import h5py
import numpy as np

from program import ProgramTest

# A cable lies on the floor; its end is lifted.
REST = """gravity = [0, 0, -1]
plane = "xz"
[section.s]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 1, EIy = 1, EIz = 1 }
inertia = { rhoA = 1, rhoIy = 1e-6, rhoIz = 1e-6 }
radius = 0.01
[rod.cable]
section = "s"
line = { from = [0, 0, 0.010199], to = [3, 0, 0.010199] }
elements = 12
order = 2
[[support]]
at = "cable.start"
fix = "x"
[obstacle.floor]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
[analysis]
kind = "static"
steps = 4
[[history]]
name = "floor"
at = "floor"
quantities = ["contact_force", "least_gap"]
[[history]]
name = "cable"
at = "cable"
with = "floor"
quantities = ["contact_force", "least_gap"]
"""
# It slides across the floor until it rolls.
SLIDE = """gravity = [0, 0, -9.81]
[section.s]
shape = { circle = { radius = 0.05 } }
material = { E = 1e9, nu = 0.3, density = 1000 }
[rod.roller]
section = "s"
line = { from = [0, 0, 0.050979], to = [1, 0, 0.050979] }
elements = 4
order = 2
[[initial]]
on = "roller"
velocity = [0, 2, 0]
[obstacle.floor]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
friction = 0.3
[analysis]
kind = "dynamic"
end_time = 0.4
time_step = 2e-3
[output]
interval = 0.0503
history_interval = 0.0301
[[history]]
name = "floor"
at = "floor"
quantities = ["contact_force", "contact_friction"]
[[history]]
name = "roller"
at = "roller"
quantities = ["contact_force", "contact_friction", "least_gap"]
"""
# One wire is lowered onto another.
CROSS = """[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e9, nu = 0.3 }
[rod.lower]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 2
[rod.upper]
section = "s"
line = { from = [0.8, -0.6, 0.0205], to = [0.8, 0.4, 0.0205] }
elements = 8
order = 2
[[support]]
at = "lower.start"
fix = "all"
[[support]]
at = "upper.start"
fix = ["x", "y", "rotation"]
move = { z = "-0.1*t" }
[contact]
[analysis]
kind = "static"
steps = 10
[[history]]
name = "clamp"
at = "lower.start"
quantities = ["reaction_force"]
[[history]]
name = "lower"
at = "lower"
quantities = ["contact_force", "least_gap"]
[[history]]
name = "upper"
at = "upper"
with = "lower"
quantities = ["contact_force", "least_gap"]
"""

# A rod lies on two that are held, on an incline: in part it sticks, in part it slides.
RUB = """gravity = [2.427, 0, -9.505]
[section.s]
shape = { circle = { radius = 0.02 } }
material = { E = 2e9, nu = 0.3, density = 1000 }
[rod.top]
section = "s"
line = { from = [-0.5, 0, 0.0403917], to = [0.5, 0, 0.0403917] }
elements = 4
order = 2
[rod.left]
section = "s"
line = { from = [-0.25, -0.1, 0], to = [-0.25, 0.1, 0] }
elements = 2
[rod.right]
section = "s"
line = { from = [0.25, -0.1, 0], to = [0.25, 0.1, 0] }
elements = 2
[[support]]
at = "left.start"
fix = "all"
[[support]]
at = "left.end"
fix = "all"
[[support]]
at = "right.start"
fix = "all"
[[support]]
at = "right.end"
fix = "all"
[contact]
friction = 0.3
[analysis]
kind = "dynamic"
end_time = 0.4
time_step = 2e-3
[[history]]
name = "top"
at = "top"
quantities = ["contact_force", "contact_friction", "least_gap"]
"""


class ContactResults(ProgramTest):
    def simulate(self, deck, *options, name="deck"):
        self.write(f"{name}.toml", deck)
        self.gxrod("run", *options, f"{name}.toml")
        return self.folder / f"{name}.vtkhdf"

    def sums(self, file, column):
        """Of each frame, over its rows."""
        offsets = file["contacts/offsets"][()]
        values = file[f"contacts/{column}"][()]
        return np.array([values[a:b].sum(axis=0) for a, b in zip(offsets, offsets[1:])])

    def test_a_cable_at_rest_is_held_by_what_it_weighs(self):
        with h5py.File(self.simulate(REST)) as file:
            forces = self.sums(file, "normal_force")
            np.testing.assert_allclose(forces[-1], [0, 0, 3], atol=1e-6)
            np.testing.assert_allclose(file["histories/cable/contact_force"][()], -file["histories/floor/contact_force"][()], atol=1e-12)
            np.testing.assert_allclose(file["histories/cable/contact_force"][-1], forces[-1], atol=1e-12)
            self.assertEqual(file["histories/cable/least_gap"][-1], file["histories/floor/least_gap"][-1])
            self.assertEqual(file["histories/cable"].attrs["with"], "floor")
            nodal = file["VTKHDF/PointData/contact_force"][()].reshape(len(forces), -1, 3)
            np.testing.assert_allclose(nodal.sum(axis=1), forces, atol=1e-12)
            self.assertEqual([name.decode() for name in file["contacts/obstacle"][()]], ["floor"])
            rods, places = file["contacts/rods"][()], file["contacts/places"][()]
            self.assertTrue((rods == [0, -1]).all())
            last = places[file["contacts/offsets"][-2]:, 0]
            np.testing.assert_allclose(last, np.linspace(0, 1, 25), atol=1e-12)
            np.testing.assert_allclose(file["contacts/point"][-25:, 2], 0.5 * file["contacts/gap"][-25:], rtol=1e-9)

    def test_what_slides_holds_once_it_rolls(self):
        with h5py.File(self.simulate(SLIDE)) as file:
            times = file["VTKHDF/Steps/Values"][()]
            normal, friction = self.sums(file, "normal_force"), self.sums(file, "friction_force")
            offsets, slides = file["contacts/offsets"][()], file["contacts/slides"][()]
            weight = 9.81 * 1000 * np.pi * 0.05 ** 2
            rolls = 2 / (3 * 0.3 * 9.81)  # the time at which it does
            for frame, time in enumerate(times[1:], start=1):
                state = slides[offsets[frame]:offsets[frame + 1]]
                self.assertEqual(len(state), 9)
                self.assertTrue((state == (time < rolls)).all(), time)
                self.assertAlmostEqual(normal[frame, 2], weight, delta=1e-3 * weight)
                if time < rolls:
                    self.assertAlmostEqual(friction[frame, 1], -0.3 * weight, delta=1e-3 * weight)
                else:
                    self.assertLess(np.abs(friction[frame, 1]), 0.2 * weight)

    def test_histories_within_steps_are_those_of_the_end_of_the_step(self):
        with h5py.File(self.simulate(SLIDE)) as file:
            times, sampled = file["histories/time"][()], file["sampled/time"][()]
            for point in ("floor", "roller"):
                steps = file[f"histories/{point}/contact_force"][()]
                samples = file[f"sampled/{point}/contact_force"][()]
                following = np.searchsorted(times, sampled - 1e-9)
                np.testing.assert_array_equal(samples, steps[following])

    def test_wires_that_cross_push_each_other(self):
        with h5py.File(self.simulate(CROSS)) as file:
            forces = self.sums(file, "normal_force")
            self.assertLess(forces[-1, 2], -1e-3)
            np.testing.assert_allclose(file["histories/lower/contact_force"][-1], forces[-1], rtol=1e-12)
            np.testing.assert_allclose(file["histories/upper/contact_force"][-1], -forces[-1], rtol=1e-12)
            np.testing.assert_allclose(file["histories/clamp/reaction_force"][-1], -forces[-1], atol=1e-8)
            rods, places, point = (file[f"contacts/{name}"][-1] for name in ("rods", "places", "point"))
            self.assertEqual(list(rods), [0, 1])
            np.testing.assert_allclose(places, [0.8, 0.6], atol=0.05)
            np.testing.assert_allclose(point[:2], [0.8, 0], atol=0.05)
            gaps = file["histories/lower/least_gap"][()]
            self.assertAlmostEqual(gaps[0], 5e-4, delta=1e-12)
            np.testing.assert_array_equal(gaps, file["histories/upper/least_gap"][()])
            self.assertEqual(gaps[-1], file["contacts/gap"][-1])

    def check_equal(self, first, second):
        with h5py.File(first) as a, h5py.File(second) as b:
            names = []
            a.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
            self.assertIn("contacts/normal_force", names)
            for name in names:
                if not name.startswith(("restart", "deck", "solver")) and a[name].dtype.kind != "O":
                    self.assertEqual(a[name][()].tobytes(), b[name][()].tobytes(), name)

    def test_rods_on_rods_hold_and_slide(self):
        with h5py.File(self.simulate(RUB)) as file:
            offsets, slides = file["contacts/offsets"][()], file["contacts/slides"][()]
            held = [not slides[first:end].all() for first, end in zip(offsets[:-1], offsets[1:]) if end > first]
            self.assertGreater(sum(held), 10)  # and all slide at times
            self.assertLess(sum(held), len(held))
            normal, friction = self.sums(file, "normal_force"), self.sums(file, "friction_force")
            # Of pieces exactly; here normals that differ a little add up to less.
            np.testing.assert_array_less(np.linalg.norm(friction, axis=1), 0.3003 * np.linalg.norm(normal, axis=1) + 1e-9)
            np.testing.assert_allclose(file["histories/top/contact_friction"][-1], friction[-1], rtol=1e-9, atol=1e-12)
            self.assertLess(friction[-1, 0], -1.0)  # it is held

    def test_reports_have_meshes_and_know_of_friction(self):
        corners = ("0 0 0", "2 0 0", "0 2 0")
        self.write("floor.stl", "solid s\nfacet\nouter loop\n" + "".join(f"vertex {corner}\n" for corner in corners) +
                   "endloop\nendfacet\nendsolid s\n")
        meshed = SLIDE.replace("plane = { point = [0, 0, 0], normal = [0, 0, 1] }\nfriction = 0.3",
                               'mesh = { file = "floor.stl" }').replace("from = [0, 0", "from = [0.2, 0.2").replace(
                                   "to = [1, 0", "to = [0.6, 0.2").replace("end_time = 0.4", "end_time = 0.02")
        for deck, friction, blocks in ((RUB, True, 0), (meshed, False, 1)):
            self.simulate(deck, "--force")
            self.gxrod("report", "deck.vtkhdf", "--force", "-o", "page.html")
            page = (self.folder / "page.html").read_text(encoding="utf-8")
            self.assertIn(f'"has_contact_friction":{str(friction).lower()}', page)
            self.assertEqual(page.count('id="data-mesh-corners-0"'), blocks)
            triangles = re.findall(r'id="data-mesh-triangles-0">([^<]*)<', page)
            self.assertEqual([list(np.frombuffer(base64.b64decode(text), "<i4")) for text in triangles], blocks * [[0, 1, 2]])

    def test_threads_make_no_difference(self):
        for deck in (SLIDE, CROSS, RUB):
            self.check_equal(self.simulate(deck, "--threads", "1", "--force", name="one"),
                             self.simulate(deck, "--threads", "3", "--force", name="three"))

    def test_a_run_that_is_resumed_has_the_same_contacts(self):
        for deck in (SLIDE, RUB):
            self.check_resumed(deck)

    def check_resumed(self, deck):
        whole = self.simulate(deck, "--force", name="whole")
        part = self.simulate(deck.replace("end_time = 0.4", "end_time = 0.2"), "--force", name="part")
        self.gxrod("resume", "part.vtkhdf", "--set", "analysis.end_time=0.4")
        with h5py.File(whole) as a, h5py.File(part) as b:
            times, resumed = a["VTKHDF/Steps/Values"][()], b["VTKHDF/Steps/Values"][()]
            self.assertEqual(len(b["contacts/offsets"]), len(resumed) + 1)
            self.assertEqual(b["contacts/offsets"][-1], len(b["contacts/gap"]))
            for number, time in enumerate(times):
                other = int(np.abs(resumed - time).argmin())
                self.assertAlmostEqual(resumed[other], time, places=12)
                rows = [slice(*file["contacts/offsets"][k:k + 2]) for file, k in ((a, number), (b, other))]
                for name in ("rods", "places", "point", "normal_force", "friction_force", "gap", "slides"):
                    self.assertEqual(a[f"contacts/{name}"][rows[0]].tobytes(), b[f"contacts/{name}"][rows[1]].tobytes(), (name, time))

    def test_what_overlaps_stops_check_and_run(self):
        deck = SLIDE.replace("0.050979], to = [1, 0, 0.050979]", "0.04], to = [1, 0, 0.045]")
        self.write("deck.toml", deck)
        for verb in ("check", "run"):
            done = self.gxrod(verb, "deck.toml", code=2)
            self.assertEqual((done.stdout + done.stderr).count("roller@0 is 0.01 deep in obstacle \"floor\""), 1)

    def test_check_says_what_touches_at_the_start(self):
        self.write("deck.toml", SLIDE)
        done = self.gxrod("check", "deck.toml")
        self.assertEqual(done.stdout.count("within the skin at the start"), 1)
        self.assertIn("9 places of rods and obstacles; the least gap is 0.000979", done.stdout)


if __name__ == "__main__":
    unittest.main()
