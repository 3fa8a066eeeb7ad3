"""Obstacles and forces of contact on the page of gxrod report, in a browser."""

import unittest

import h5py
import numpy as np
import report_pages
from contact_results_test import CROSS, SLIDE
from report_pages import PageTest, set_up_pages

LIFTED = SLIDE.replace("friction = 0.3", 'friction = 0.3\nmove = { y = "0.5*t" }').replace("velocity = [0, 2, 0]", "velocity = [0, 0.1, 0]")
HELD = """[section.s]
shape = { circle = { radius = 0.02 } }
material = { E = 1e7, nu = 0.3, density = 1000 }
[rod.wire]
section = "s"
line = { from = [-0.5, 0, 0.5], to = [0.5, 0, 0.5] }
elements = 4
[[support]]
at = "wire.start"
fix = "all"
[obstacle.ball]
sphere = { centre = [0, 0, 0], radius = 0.2 }
[obstacle.drum]
cylinder = { from = [0, -0.5, 1], to = [0, 0.5, 1], radius = 0.3 }
[obstacle.vessel]
tube = { arc = { from = [-1, 0, 0.5], through = [0, 0, 0.55], to = [1, 0, 0.5] }, radius = 0.2, side = "inside" }
[[load]]
at = "wire.end"
force = [0, 0, "-0.01*t"]
[analysis]
kind = "static"
steps = 2
"""


def setUpModule():
    report_pages.DECKS = {"slide": SLIDE, "cross": CROSS, "moved": LIFTED, "held": HELD}
    set_up_pages()


class ContactPage(PageTest):
    def ask(self, what):
        return self.browser.run(f"const parts = document.getElementById('canvas').picture().parts; return {what}")

    def go_to(self, frame):
        self.browser.run("const slider = document.getElementById('time-slider'); slider.value = arguments[0];"
                         "slider.dispatchEvent(new Event('input'))", frame)
        self.browser.settle()

    def test_arrows_are_those_of_the_frame(self):
        self.open("slide")
        with h5py.File(self.folder / "slide.vtkhdf") as file:
            offsets, slides = file["contacts/offsets"][()], file["contacts/slides"][()]
            forces = file["contacts/normal_force"][()] + file["contacts/friction_force"][()]
        for frame in (1, len(offsets) - 2):
            self.go_to(frame)
            self.assertEqual(self.ask("parts.contacts.parts[0].count"), offsets[frame + 1] - offsets[frame])
            rows = slice(offsets[frame], offsets[frame + 1])
            drawn = np.reshape(self.ask("Array.from(parts.contacts.contacts.slice(7 * parts.contacts.offsets[%d], 7 * parts.contacts.offsets[%d]))" % (frame, frame + 1)), (-1, 7))
            order = np.argsort(-np.linalg.norm(forces[rows], axis=1), kind="stable")
            np.testing.assert_allclose(drawn[:, 3:6], forces[rows][order], rtol=1e-5, atol=1e-4)
            np.testing.assert_array_equal(drawn[:, 6], slides[rows][order])
        self.assertEqual(self.text("#contacts-legend"), "contact: holdsslides")

    def test_rods_push_each_other(self):
        self.open("cross")
        with h5py.File(self.folder / "cross.vtkhdf") as file:
            rows = np.diff(file["contacts/offsets"][()])
        self.go_to(len(rows) - 1)
        self.assertEqual(self.ask("parts.contacts.parts[0].count"), 2 * rows[-1])
        self.assertEqual(self.text("#contacts-legend"), "contact")
        self.assertEqual(self.ask("parts.obstacles.marks.length"), 0)

    def test_boxes_hide_them(self):
        self.open("slide")
        for name in ("obstacles", "contacts"):
            self.assertTrue(self.ask(f"parts.{name}.group.visible"))
            self.browser.run(f"document.getElementById('show-{name}').click()")
            self.assertFalse(self.ask(f"parts.{name}.group.visible"))
        self.assertTrue(self.browser.run("return document.getElementById('contacts-legend').hidden"))

    def test_moved_obstacles_are_where_they_are(self):
        self.open("moved")
        with h5py.File(self.folder / "moved.vtkhdf") as file:
            times = file["VTKHDF/Steps/Values"][()]
        for frame in (0, 3):
            self.go_to(frame)
            place = self.ask("parts.obstacles.marks[0].group.position.toArray()")
            np.testing.assert_allclose(place, [0, 0.5 * times[frame], 0], atol=1e-6)

    def test_every_shape_is_drawn_where_it_is(self):
        self.open("held")
        boxes = self.ask("parts.obstacles.marks.map(({ group }) => { const box = group.children[0].geometry.boundingBox;"
                         "return [...box.min.toArray(), ...box.max.toArray()] })")
        np.testing.assert_allclose(boxes[0], [-0.2, -0.2, -0.2, 0.2, 0.2, 0.2], atol=1e-3)
        np.testing.assert_allclose(boxes[1], [-0.3, -0.8, 0.7, 0.3, 0.8, 1.3], atol=1e-2)
        np.testing.assert_allclose(boxes[2][:3], [-1.02, -0.2, 0.3], atol=0.02)

    def test_nothing_is_loaded_and_no_errors_come(self):
        for name in ("slide", "cross", "moved", "held"):
            self.open(name)
            self.assertEqual(self.browser.take_errors(), [])


if __name__ == "__main__":
    unittest.main()
