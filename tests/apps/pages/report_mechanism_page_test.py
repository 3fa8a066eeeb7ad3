"""Joints, sleeves, springs and bushings in the page of gxrod report, in a browser."""

import pathlib
import subprocess
import tempfile
import unittest

import h5py
import numpy as np
from browser import Browser
from program import GXROD
from report_pages import PageTest

# A crank that a motor turns, a link, a block on a guide; a spring between the block and the ground; a pad on a bushing.
CRANK = """title = "A crank"
units = "m kg s"
[body.crank]
mass = 1
inertia = [1e-3, 2e-3, 2e-3]
at = [0, 0, 0]
[body.link]
mass = 1
inertia = [1e-4, 8e-3, 8e-3]
at = [0.25, 0, 0]
[body.block]
mass = 1
inertia = [1e-3, 1e-3, 1e-3]
at = [0.4, 0, 0]
[body.pad]
mass = 1
inertia = [1e-3, 1e-3, 1e-3]
at = [0.2, 0.3, 0]
velocity = [0, 0.1, 0]
[joint.shaft]
type = "hinge"
between = ["ground", "crank"]
axis = [0, 0, 1]
move = "40*t^2"
[joint.pin]
type = "ball"
between = ["crank", "link"]
at = [0.1, 0, 0]
[joint.wrist]
type = "universal"
between = ["link", "block"]
at = [0.4, 0, 0]
axis = [0, 0, 1]
axis_b = [0, 1, 0]
[joint.guide]
type = "slider"
between = ["block", "ground"]
axis = [1, 0, 0]
friction = { force = 0.1 }
[spring.cord]
between = ["ground", "block"]
at_a = [0.7, 0, 0]
at_b = [0.42, 0, 0]
stiffness = 10
length = 0.2
[bushing.mount]
between = ["ground", "pad"]
stiffness = { x = 1e3, y = 1e3, z = 1e3, rx = 10, ry = 10, rz = 10 }
[analysis]
kind = "dynamic"
end_time = 0.3
time_step = 0.002
[output]
every = 5
[[history]]
name = "shaft"
at = "shaft"
quantities = ["gap", "moment_a", "force", "drive", "angle_rate", "angle"]
[[history]]
name = "guide"
at = "guide"
quantities = ["friction", "slide"]
"""
KINDS = {"ball": "", "hinge": "axis", "cylinder": "axis", "slider": "axis", "universal": "axis axis_b", "screw": "axis lead",
         "plane": "axis", "weld": "", "distance": "at_a"}
KEYS = {"axis": "axis = [0, 1, 0]\n", "axis_b": "axis_b = [1, 0, 0]\n", "lead": "lead = 0.05\n", "at_a": "at_a = [{x}, 0.2, 0.1]\n"}


def make_kinds_deck():
    """A body on a joint of each kind, next to each other."""
    deck = 'gravity = [0.1, -1, -2]\n'
    for i, (kind, keys) in enumerate(KINDS.items()):
        at = "" if kind == "distance" else f"at = [{i}, 0.1, 0]\n"
        deck += (f"[body.b{i}]\nmass = 1\ninertia = [0.01, 0.02, 0.03]\nat = [{i}, 0, 0]\n"
                 f'[joint.{kind}]\ntype = "{kind}"\nbetween = ["ground", "b{i}"]\n{at}'
                 + "".join(KEYS[key].format(x=i) for key in keys.split()))
    return deck + '[analysis]\nkind = "dynamic"\nend_time = 0.2\ntime_step = 0.01\n'


# Points that slide along the second of two rods that start at one node.
BEADS = """units = "m kg s"
gravity = [0, -9.81, 0]
[section.bar]
stiffness = { EA = 1e3, GAy = 500, GAz = 500, GJ = 4, EIy = 5, EIz = 5 }
inertia = { rhoA = 1, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }
[rod.first]
section = "bar"
line = { from = [0, 0, 0], to = [0, 1, 0] }
elements = 4
[rod.second]
section = "bar"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
[rod.mast]
section = "bar"
line = { from = [0.6, 0, -0.3], to = [0.6, 0, 0.3] }
elements = 4
[[connect]]
points = ["first.start", "second.start"]
[[support]]
at = "first.start"
fix = "all"
[body.bead]
mass = 0.3
inertia = [1e-3, 1e-3, 1e-3]
at = [0.3, -0.1, 0]
[joint.ring]
type = "sleeve"
between = ["second", "bead"]
at = [0.3, 0, 0]
[joint.middle]
type = "sleeve"
between = ["second", "mast@0.5"]
[joint.eye]
type = "sleeve"
between = ["second", "ground"]
at = [0.9, 0, 0]
move = "0.01*t^3"
[analysis]
kind = "dynamic"
end_time = 0.1
time_step = 0.01
[[history]]
name = "pull" # of the "ring"
at = 'ring'
quantities = ["slide", "force"]
[[history]]
name = "ring"
at = "middle"
quantities = "force"
"""
DECKS = {"crank": CRANK, "kinds": make_kinds_deck(), "beads": BEADS}
PICTURE = "const { parts, stage } = document.getElementById('canvas').picture();"
FIND = ("const chart = [...document.querySelectorAll('.chart')].find((c) => "
        "c.querySelector('h3')?.textContent.startsWith(arguments[0]));")
MARK = PICTURE + "const mark = [...parts.joints.marks, ...parts.springs.marks].find(({ name }) => name === arguments[0]);"


def setUpModule():
    temporary = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(temporary.cleanup)
    PageTest.folder = pathlib.Path(temporary.name)
    for name, deck in DECKS.items():
        (PageTest.folder / f"{name}.toml").write_text(deck)
        for words in (f"run {name}.toml --quiet", f"report {name}.vtkhdf"):
            subprocess.run([GXROD, *words.split()], cwd=PageTest.folder, check=True, capture_output=True)
    PageTest.browser = Browser()
    unittest.addModuleCleanup(PageTest.browser.close)


def turn_matrix(vector):
    """The rotation of a rotation vector, as the exponential of its skew matrix, by its series."""
    x, y, z = vector
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix, term = np.eye(3), np.eye(3)
    for i in range(1, 40):
        term = term @ skew / i
        matrix += term
    return matrix


class MechanismTest(PageTest):
    def setUp(self):
        self.addCleanup(lambda: self.assertEqual(self.browser.take_errors(), []))

    def mark(self, name, expression):
        return self.browser.run(f"{MARK} return {expression};", name)

    def frame(self, index):
        """Positions and rotations of the bodies, in the order of the deck."""
        with h5py.File(self.folder / "crank.vtkhdf") as file:
            count = int(file["VTKHDF/NumberOfPoints"][0])
            rows = slice(index * count, (index + 1) * count)
            data = file["VTKHDF"]
            return data["Points"][rows], [turn_matrix(v) for v in data["PointData/rotation_vector"][rows]]

    def assert_at(self, found, expected):
        np.testing.assert_allclose(found, expected, atol=1e-6)


class Drawing(MechanismTest):
    def test_joints_are_where_bodies_carry_them(self):
        self.open("crank")
        self.slide(0)
        self.assert_at(self.mark("pin", "mark.place.toArray()"), [0.1, 0, 0])
        for frame in (0, 12, 30):
            self.slide(frame)
            points, turns = self.frame(frame)
            pin = points[0] + turns[0] @ [0.1, 0, 0]
            self.assert_at(self.mark("pin", "mark.place.toArray()"), pin)
            self.assert_at(pin, points[1] + turns[1] @ [-0.15, 0, 0])
            self.assert_at(self.mark("shaft", "mark.place.toArray()"), [0, 0, 0])
            self.assert_at(self.mark("wrist", "mark.place.toArray()"), points[2])
            # An arm goes from the crank's node to the pin; the shaft has none.
            ends = self.mark("pin", "mark.ends.map(({ start }) => start.toArray())")
            self.assert_at(ends, points[:2])
            self.assertEqual(self.mark("shaft", "mark.arms.map((arm) => arm !== null)"), [False, False])
            self.assertEqual(self.mark("pin", "mark.arms.map((arm) => arm !== null)"), [True, True])
            self.assertAlmostEqual(self.mark("pin", "mark.arms[1].scale.z"), 0.15, delta=1e-6)
        self.assertGreater(np.linalg.norm(points[0] + turns[0] @ [0.1, 0, 0] - [0.1, 0, 0]), 0.05, "nothing moves")

    def test_axes_turn_with_the_side_that_carries_them(self):
        """The universal joint's first axis is the link's; its cross has the axis that the block carries."""
        self.open("crank")
        self.slide(30)
        points, turns = self.frame(30)
        axis = "const x = mark.body.position.clone().set(1, 0, 0);"
        for name, part, expected in (("wrist", "body", turns[1] @ [0, 0, 1]), ("wrist", "cross", turns[2] @ [0, 1, 0]),
                                     ("shaft", "body", [0, 0, 1]), ("guide", "rail", [1, 0, 0])):
            found = self.browser.run(f"{MARK} {axis} return x.applyQuaternion(mark.{part}.quaternion).toArray();", name)
            self.assert_at(found, expected)

    def test_sliders_ride_on_rails_that_hold_their_way(self):
        self.open("crank")
        with h5py.File(self.folder / "crank.vtkhdf") as file:
            ways = file["VTKHDF/Points"][()].reshape(-1, 4, 3)[:, 2, 0]
        for frame in (0, 15, 30):
            self.slide(frame)
            self.assert_at(self.mark("guide", "mark.place.toArray()"), [ways[frame], 0, 0])
            self.assert_at(self.mark("guide", "mark.rail.position.toArray()"), [0.4, 0, 0])
        self.assertAlmostEqual(self.mark("guide", "mark.least"), ways.min() - 0.4, delta=1e-6)
        self.assertAlmostEqual(self.mark("guide", "mark.most"), ways.max() - 0.4, delta=1e-6)
        bar = self.mark("guide", "[mark.rail.children[0].position.x, mark.rail.children[0].scale.x]")
        self.assertLess(bar[0] - 0.5 * bar[1], ways.min() - 0.4)
        self.assertGreater(bar[0] + 0.5 * bar[1], ways.max() - 0.4)

    def test_springs_span_their_points_and_bushings_stand_between_theirs(self):
        self.open("crank")
        for frame in (0, 20, 30):
            self.slide(frame)
            points, turns = self.frame(frame)
            end = points[2] + turns[2] @ [0.02, 0, 0]
            self.assertAlmostEqual(self.mark("cord", "mark.line.scale.z"), np.linalg.norm(end - [0.7, 0, 0]), delta=1e-6)
            self.assert_at(self.mark("cord", "mark.line.position.toArray()"), [0.7, 0, 0])
            self.assert_at(self.mark("mount", "mark.box.position.toArray()"), 0.5 * (points[3] + [0.2, 0.3, 0]))

    def test_grounded_driven_and_other_joints_have_their_colours(self):
        self.open("crank")
        colour = lambda name: self.mark(name, "mark.material.color.getHexString()")
        self.assertEqual([colour(name) for name in ("shaft", "pin", "guide")], ["8e5bd0", "1d8a99", "7b8494"])

    def test_switches_hide_them(self):
        self.open("crank")
        self.hide_all_but_parts()
        for name in ("joints", "springs"):
            before = self.picture()
            self.browser.run(f"document.getElementById('show-{name}').click()")
            self.browser.settle()
            self.assertGreater((np.abs(before - self.picture()).max(axis=2) > 20).mean(), 5e-4, name)
        self.assertIn("violet ones are moved by a motor", self.text("#about"))

    def test_all_kinds_are_drawn(self):
        self.open("kinds")
        self.slide(20)
        kinds = self.browser.run(f"{PICTURE} return parts.joints.marks.map(({{ name, type, body }}) => [name, type, body.children.length]);")
        self.assertEqual([kind[:2] for kind in kinds], [[kind, kind] for kind in KINDS])
        self.assertTrue(all(children > 0 for _, _, children in kinds), kinds)
        self.assertTrue(self.browser.run("return document.getElementById('show-springs').closest('label').hidden"))
        self.assertFalse(self.browser.run("return document.getElementById('show-joints').closest('label').hidden"))

    def test_pointing_at_a_joint_names_it(self):
        self.open("crank")
        self.slide(20)
        point = """
            const canvas = document.getElementById('canvas');
            const at = mark.place.clone().project(stage.camera);
            const box = canvas.getBoundingClientRect();
            canvas.dispatchEvent(new PointerEvent('pointermove', { bubbles: true,
                clientX: box.left + 0.5 * (1 + at.x) * canvas.clientWidth + arguments[1],
                clientY: box.top + 0.5 * (1 - at.y) * canvas.clientHeight }));
            const tag = document.getElementById('name-tag');
            return tag.hidden ? '' : tag.textContent;"""
        self.assertEqual(self.browser.run(MARK + point, "pin", 4), "pin: ball")
        self.assertEqual(self.browser.run(MARK + point, "cord", 0), "cord: spring")
        self.assertEqual(self.browser.run(MARK + point, "cord", -2000), "")


class Charts(MechanismTest):
    def headings(self):
        return self.browser.run("return [...document.querySelectorAll('.chart h3')].map((h) => h.textContent)")

    def test_joints_have_theirs_in_order_and_with_units(self):
        self.open("crank")
        self.assertEqual([heading for heading in self.headings() if ":" in heading],
                         ["guide: slidem", "guide: frictionN", "shaft: anglerad", "shaft: angle raterad/s", "shaft: driveN·m",
                          "shaft: forceN, spatial axes", "shaft: momentN·m, joint axes of A", "shaft: gapm"])
        keys = FIND + "return [...chart.querySelectorAll('.key')].map((key) => key.childNodes[1].textContent);"
        self.assertEqual(self.browser.run(keys, "shaft: moment"), ["axis", "across 1", "across 2", "magnitude"])

    def test_angles_are_also_in_degrees(self):
        self.open("crank")
        self.slide(30)
        self.browser.run(FIND + "chart.scrollIntoView();", "shaft: angle")
        self.browser.wait(lambda: self.browser.run(FIND + "return chart.querySelector('.value').textContent", "shaft: angle"))
        value = self.browser.run(FIND + "return chart.querySelector('.value').textContent", "shaft: angle")
        angle, degrees = value.rstrip("°").split(" = ")
        self.assertAlmostEqual(float(angle), 40 * 0.3**2, delta=1e-3)
        self.assertAlmostEqual(float(degrees), np.degrees(40 * 0.3**2), delta=0.1)


class Tables(MechanismTest):
    FREE = {"ball": "all turns", "hinge": "turn about the axis", "cylinder": "turn about the axis, slide along it", "weld": "nothing",
            "slider": "slide along the axis", "universal": "turns about both axes", "screw": "turn about the axis, and a slide with it",
            "plane": "slides across the axis, turn about it", "distance": "all but the distance"}

    def tables(self):
        """{title: its rows, the heading first} of the model."""
        return dict(self.browser.run("""
            const cells = (row) => [...row.children].map((cell) => cell.textContent);
            const sections = [...document.querySelectorAll('#model section')];
            return sections.map((s) => [s.querySelector('h2').textContent, [...s.querySelectorAll('tr')].map(cells)]);"""))

    def largest(self, name, dataset):
        with h5py.File(self.folder / f"{name}.vtkhdf") as file:
            return np.linalg.norm(file[f"histories/{dataset}"][()], axis=1).max()

    def test_sleeves_are_among_the_joints(self):
        self.open("beads")
        tables = self.tables()
        self.assertEqual(list(tables)[-2:], ["Joints", "Supports"])
        heading, *rows = tables["Joints"]
        self.assertEqual(heading, ["", "type", "from", "to", "at", "axis", "leaves free", "largest force, N"])
        free = "all turns, slide along the rod"
        self.assertEqual([row[:-1] for row in rows], [["ring", "sleeve", "second", "bead", "(0.3, 0, 0)", "", free],
                                                      ["middle", "sleeve", "second", "mast@0.5", "(0.6, 0, 0)", "", free],
                                                      ["eye", "sleeve", "second", "ground", "(0.9, 0, 0)", "", f"{free}; moved by a motor"]])
        self.assertAlmostEqual(float(rows[0][-1]), self.largest("beads", "pull/force"), delta=1e-5)
        self.assertAlmostEqual(float(rows[1][-1]), self.largest("beads", "ring/force"), delta=1e-5)
        self.assertEqual(rows[2][-1], "")

    def test_joints_have_what_they_leave_free(self):
        self.open("kinds")
        heading, *rows = self.tables()["Joints"]
        self.assertEqual(heading[-1], "leaves free")
        self.assertEqual({row[0]: row[-1] for row in rows}, self.FREE)

    def test_joints_have_their_largest_forces(self):
        self.open("crank")
        heading, *rows = self.tables()["Joints"]
        self.assertEqual(heading[-3:], ["leaves free", "largest force, N", "largest moment, N·m"])
        self.assertEqual([row[0] for row in rows], ["shaft", "pin", "wrist", "guide"])
        self.assertEqual(rows[0][-3], "turn about the axis; moved by a motor")
        for text, dataset in zip(rows[0][-2:], ("shaft/force", "shaft/moment_a")):
            self.assertAlmostEqual(float(text) / self.largest("crank", dataset), 1.0, delta=1e-5)
        self.assertEqual([row[-2:] for row in rows[1:]], [["", ""]] * 3)


if __name__ == "__main__":
    unittest.main()
