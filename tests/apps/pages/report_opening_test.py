"""Where the page of gxrod report opens: where something happens, or at the time of the address."""

import subprocess
import unittest

import h5py
import numpy as np
from program import GXROD, SOURCE
from report_pages import PageTest, set_up_pages

# A cantilever that is pulled back to where it was, with a history that never moves first.
RETURN = """title = "There and back"
[section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 20, EIy = 20, EIz = 40 }
[rod.arm]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[support]]
at = "arm.start"
fix = "all"
[[load]]
at = "arm.end"
force = [0, "sin(pi*t)", 0]
[analysis]
kind = "static"
steps = 10
[output]
every = 1
[[history]]
name = "foot"
at = "arm.start"
quantities = ["position"]
[[history]]
name = "tip"
at = "arm.end"
quantities = ["displacement"]
"""
# A ball that falls onto a floor.
DROP = """title = "A drop"
gravity = [0, 0, -9.81]
[body.ball]
mass = 1
inertia = [1, 1, 1]
at = [0, 0, 1]
[joint.rope]
type = "ball"
between = ["ball", "ground"]
at = [1, 0, 1]
breaks = { force = 15 }
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.01
[output]
every = 1
[[history]]
name = "rope"
at = "rope"
quantities = ["holds"]
"""
# Stages as the analysis, and another ball, whose rope rests in the second one.
REST = DROP[: DROP.index("[analysis]")] + """
[body.other]
mass = 1
inertia = [1, 1, 1]
at = [0, 5, 1]
[joint.aside]
type = "ball"
between = ["other", "ground"]
at = [1, 5, 1]
stages = "slow"
[[stage]]
name = "slow"
kind = "dynamic"
end_time = 0.1
time_step = 0.01
[[stage]]
name = "fast"
kind = "dynamic"
end_time = 1
time_step = 0.01
[output]
every = 1
[[history]]
name = "aside"
at = "aside"
quantities = ["holds"]
[[history]]
name = "rope"
at = "rope"
quantities = ["holds"]
"""
LONG = "A warning of many words about one thing after another, " * 12 + "x" * 300


def setUpModule():
    set_up_pages()
    for name, deck in (("return", RETURN), ("drop", DROP), ("rest", REST), ("sway", (SOURCE / "docs/examples/sway/sway.toml").read_text())):
        (PageTest.folder / f"{name}.toml").write_text(deck)
        for words in (f"run {name}.toml --quiet --force", f"report {name}.vtkhdf --force"):
            subprocess.run([GXROD, *words.split()], cwd=PageTest.folder, check=True, capture_output=True)


class Opening(PageTest):
    def times(self, name):
        with h5py.File(self.folder / f"{name}.vtkhdf") as file:
            steps = file["VTKHDF/Steps"]
            points = file["VTKHDF/Points"][()].reshape(len(steps["Values"]), -1, 3)
            return steps["Values"][()], np.linalg.norm(points - points[0], axis=2).max(axis=1)

    def opened_at(self):
        return int(self.browser.run("return document.getElementById('time-slider').value"))

    def say(self):
        return self.text("#opening")

    def go(self, name, address):
        self.open("body")
        self.browser.driver.get((self.folder / f"{name}.html").as_uri() + address)
        self.browser.wait(lambda: self.browser.run("return document.documentElement.dataset.ready") == "true")
        self.browser.settle()

    def test_a_motion_opens_where_it_has_moved_most(self):
        self.open("rod")
        times, moved = self.times("rod")
        frame = int(np.argmax(moved))
        self.assertEqual(self.opened_at(), frame)
        self.assertIn(f"opens at t = {times[frame]:g}: the frame that has moved most", self.say())

    def test_statics_open_at_their_last_state_unless_they_come_back(self):
        self.open("static")
        self.assertEqual(self.opened_at(), len(self.times("static")[0]) - 1)
        self.assertIn("opens at λ = 1: the last state", self.say())
        self.open("return")
        self.assertEqual(self.opened_at(), int(np.argmax(self.times("return")[1])))
        self.assertIn("opens at λ = 0.5: the frame that has moved most", self.say())

    def test_a_path_opens_where_it_becomes_unstable(self):
        self.open("sway")
        with h5py.File(self.folder / "sway.vtkhdf") as file:
            time = file["histories/time"][file["stages/path/critical_points/row"][0]]
        self.assertEqual(self.opened_at(), int(np.argmin(np.abs(self.times("sway")[0] - time))))
        self.assertIn("the first bifurcation", self.say())

    def test_a_joint_that_breaks_and_a_failure_open_there(self):
        for name in ("drop", "rest"):
            with self.subTest(name=name):
                self.open(name)
                with h5py.File(self.folder / f"{name}.vtkhdf") as file:
                    holds = file["histories/rope/holds"][()].ravel()
                    time = file["histories/time"][int(np.argmin(holds))]
                self.assertEqual((holds[0], holds[-1]), (1, 0))
                self.assertAlmostEqual(self.times(name)[0][self.opened_at()], time, delta=1e-9)
                self.assertIn("rope breaks", self.say())
        self.open("failing")
        self.assertEqual(self.opened_at(), len(self.times("failing")[0]) - 1)

    def test_the_address_says_when(self):
        times, _ = self.times("rod")
        self.go("rod", "#t=0.61")
        self.assertEqual(self.opened_at(), int(np.argmin(np.abs(times - 0.61))))
        self.assertIn("t = 0.61 of the address", self.say())
        self.assertEqual(self.browser.run("return document.querySelectorAll('.warning').length"), 0)
        self.browser.run("location.hash = '#t=1.2'")
        self.browser.wait(lambda: self.opened_at() == int(np.argmin(np.abs(times - 1.2))))

    def test_an_address_that_is_no_number_is_said(self):
        for address in ("#t=soon", "#t=%"):
            self.go("rod", address)
            self.assertEqual(self.opened_at(), int(np.argmax(self.times("rod")[1])))
            self.assertIn(f"The address has {address}; expected a number, as in #t=0.5", self.text("#warnings"))

    def test_histories_come_first_and_what_never_moves_last(self):
        self.open("return")
        titles = self.browser.run("return [...document.querySelectorAll('.chart:not(.along) h3')].map((h) => h.firstChild.textContent)")
        self.assertEqual(titles[:3], ["tip: displacement", "foot: position", "Energies"])

    def test_long_warnings_wrap_and_leave_room(self):
        self.make_changed_page("long", lambda file: (file.attrs.__setitem__("title", "y" * 400), file.attrs.__setitem__("status", "failed"),
                                                     file.attrs.__setitem__("reason", LONG * 6)))
        for size in ((400, 800), (1280, 800)):
            self.open("long", size)
            self.assertIn(LONG, self.text("#warnings"))
            self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), size[0])
            self.assertLessEqual(self.browser.run("const w = document.getElementById('warnings'); return w.scrollWidth - w.clientWidth"), 0)
            self.assertLess(self.browser.run("return document.getElementById('warnings').offsetHeight"), 0.3 * size[1])
            self.assertGreater(self.browser.run("return document.getElementById('canvas').clientHeight"), 0.2 * size[1])

    def test_nothing_leaves_a_narrow_page(self):
        for name in ("rod", "static", "frame", "blade", "sway", "failing"):
            self.open(name, (400, 800))
            for tab in self.browser.run("return [...document.querySelectorAll('[role=tab]')].map((tab) => tab.getAttribute('aria-controls'))"):
                self.browser.run("document.querySelector(`[aria-controls=${arguments[0]}]`).click()", tab)
                self.browser.settle()
                self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), 400, (name, tab))
                self.assertEqual(self.browser.run(BEYOND), [], (name, tab))


# Elements that are seen beyond the right edge, and not in something that scrolls.
BEYOND = """
    const scrolls = (e) => e !== document.body && (/auto|scroll|hidden/.test(getComputedStyle(e).overflowX) || scrolls(e.parentElement));
    return [...document.body.querySelectorAll('*')].filter((e) => e.checkVisibility() && e.getBoundingClientRect().width > 0 &&
        e.getBoundingClientRect().right > 401 && !scrolls(e.parentElement)).map((e) => e.outerHTML.slice(0, 80));"""

if __name__ == "__main__":
    unittest.main()
