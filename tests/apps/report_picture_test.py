"""The picture, the charts and the looks of the page of gxrod report, in a browser."""

import unittest

import h5py
import numpy as np
from browser import PHONE
from report_pages import PageTest, set_up_pages


def setUpModule():
    set_up_pages()


class Picture(PageTest):
    def test_moves_with_the_slider_and_without_errors(self):
        self.open("rod")
        self.hide_all_but_parts()
        pictures = []
        for frame in (0, 8, 20):
            self.slide(frame)
            pictures.append(self.picture())
            self.assert_drawn(pictures[-1])
            self.assertEqual(self.text("#frame-text"), f"frame {frame + 1} of 21")
        for one, other in ((0, 1), (1, 2), (0, 2)):
            changed = (np.abs(pictures[one] - pictures[other]).max(axis=2) > 40).mean()
            self.assertGreater(changed, 0.001, "the picture does not move")
        self.assertEqual(self.browser.take_errors(), [])

    def test_plays_and_pauses(self):
        self.open("rod")
        position = lambda: int(self.browser.run("return document.getElementById('time-slider').value"))
        self.assertEqual(position(), 0)
        self.browser.run("document.getElementById('play').click()")
        self.browser.wait(lambda: position() >= 2)
        self.browser.run("document.getElementById('play').click()")
        stopped = position()
        self.browser.settle()
        self.assertEqual(position(), stopped)
        self.assertEqual(self.browser.run("return document.getElementById('play').dataset.playing"), "false")

    def test_colours_by_every_quantity_and_magnifies(self):
        self.open("rod")
        self.hide_all_but_parts()
        self.slide(10)
        names = self.browser.run("return [...document.getElementById('quantity').options].map((o) => o.value)")
        self.assertEqual(names, ["", "displacement", "rotation_vector", "velocity", "angular_velocity", "force", "moment",
                                 "strain", "curvature"])
        choose = ("const menu = document.getElementById(arguments[0]); menu.value = arguments[1];"
                  "menu.dispatchEvent(new Event('change'))")
        last = None
        for name in names[1:]:
            self.browser.run(choose, "quantity", name)
            self.browser.settle()
            ticks = self.text("#legend-ticks")
            self.assertNotEqual((name, ticks), last)
            last = (name, ticks)
        with h5py.File(self.folder / "rod.vtkhdf") as file:
            largest = np.linalg.norm(file["VTKHDF/CellData/moment"][:], axis=1).max()
        self.browser.run(choose, "quantity", "moment")
        self.assertAlmostEqual(float(self.text("#legend-ticks span:last-child")), largest, delta=0.006 * largest)
        self.browser.run(choose, "quantity", "")
        self.slide(0)
        reference = self.picture()
        self.slide(10)
        self.browser.run(choose, "scale", "0")
        self.browser.settle()
        self.assertLess((np.abs(reference - self.picture()).max(axis=2) > 40).mean(), 1e-4)
        self.assertIn("0 times", self.text("#scale-note"))

    def test_turns(self):
        self.open("rod")
        self.hide_all_but_parts()
        before = self.picture()
        self.browser.run("document.getElementById('view-x').click()")
        self.browser.settle()
        self.assertGreater((np.abs(before - self.picture()).max(axis=2) > 40).mean(), 0.001)

    def test_shows_a_single_frame_without_steps(self):
        self.make_changed_page("single", lambda file: (
            file["VTKHDF/Steps"].attrs.modify("NSteps", 1),
            [data.resize(0, axis=0) for data in (file["histories/time"], file["histories/tip/position"])]))
        self.open("single")
        self.hide_all_but_parts()
        self.assert_drawn(self.picture())
        self.assertEqual(self.text("#frame-text"), "frame 1 of 1")
        self.assertIn("no step", self.text("#charts"))
        self.assertEqual(self.browser.take_errors(), [])

    def test_shows_frames_without_their_model(self):
        def change_deck(file):
            del file["deck/text"]
            file["deck/text"] = "[rod.of_another_version]"
        self.make_changed_page("other", change_deck)
        self.open("other")
        self.hide_all_but_parts()
        self.assert_drawn(self.picture())
        self.assertIn("Supports, loads, sections and shapes of bodies are not shown: ", self.text("#model"))
        self.assertEqual(self.browser.take_errors(), [])

    def test_shows_bodies(self):
        self.open("body")
        self.hide_all_but_parts()
        self.assert_drawn(self.picture(), 0.02)
        self.assertEqual(self.browser.take_errors(), [])


class Charts(PageTest):
    def test_follow_the_time_and_lead_it(self):
        self.open("rod")
        self.slide(5)
        self.assertAlmostEqual(self.cursor(), 0.25, delta=0.01)
        self.browser.run("""
            const over = document.querySelectorAll('.chart .u-over')[1];
            const box = over.getBoundingClientRect();
            over.dispatchEvent(new PointerEvent('pointerdown', {clientX: box.left + 0.75 * box.width,
                clientY: box.top + 10, pointerId: 1, bubbles: true}));""")
        self.assertEqual(self.text("#frame-text"), "frame 16 of 21")
        self.assertAlmostEqual(self.cursor(), 0.75, delta=0.01)

    def test_tell_the_value_at_the_time(self):
        self.open("rod")
        self.slide(12)
        with h5py.File(self.folder / "rod.vtkhdf") as file:
            expected = file["ledger/kinetic_energy"][60]
        self.assertAlmostEqual(float(self.text(".chart .value")), expected, delta=1e-3 * expected)

    def test_are_there_for_all_that_was_recorded(self):
        self.open("rod")
        titles = self.browser.run("return [...document.querySelectorAll('.chart h3')].map((h) => h.firstChild.textContent)")
        self.assertEqual(titles, ["Energies", "Energy imbalance", "tip: position", "tip: velocity", "Linear momentum",
                                  "Angular momentum", "Step size", "Newton iterations"])
        self.open("static")
        titles = self.browser.run("return [...document.querySelectorAll('.chart h3')].map((h) => h.firstChild.textContent)")
        self.assertNotIn("Linear momentum", titles)
        self.assertEqual(self.text("#time-text"), "λ = 1")
        self.assertEqual(self.browser.take_errors(), [])


class Looks(PageTest):
    def brightness(self):
        colour = self.browser.run("return getComputedStyle(document.body).backgroundColor")
        return np.mean([float(x) for x in colour[colour.index("(") + 1:-1].split(",")[:3]])

    def test_light_and_dark(self):
        self.open("rod", scheme="light")
        self.assertGreater(self.brightness(), 200)
        self.browser.prefer("dark")
        self.browser.settle()
        self.assertLess(self.brightness(), 60)
        self.assert_drawn(self.picture())
        self.browser.run("document.getElementById('theme').click()")
        self.assertGreater(self.brightness(), 200)
        self.browser.run("document.getElementById('theme').click()")
        self.browser.prefer("light")
        self.assertLess(self.brightness(), 60)

    def test_a_phone_does_not_scroll_sideways(self):
        self.open("failing", PHONE)
        for tab in ("charts", "model", "deck", "about"):
            self.browser.run("document.querySelector(`[aria-controls=${arguments[0]}]`).click()", tab)
            width = self.browser.run("return Math.max(document.documentElement.scrollWidth, document.body.scrollWidth)")
            self.assertLessEqual(width, PHONE[0], tab)
        self.slide(1)
        self.assert_drawn(self.picture())


if __name__ == "__main__":
    unittest.main()
