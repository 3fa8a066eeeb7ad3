"""gxrod report: the page, in a browser."""

import io
import pathlib
import subprocess
import tempfile
import time
import unittest

import h5py
import numpy as np
from browser import LAPTOP, PHONE, Browser
from PIL import Image
from program import GXROD, SPINNING_BODY, ProgramTest

ROD = """title = "A swinging rod"
units = "m kg s"
[section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 20, EIy = 20, EIz = 40 }
inertia = { rhoA = 1, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.arm]
section = "s"
line = { from = [0, 0, 0], to = [4, 0, 1] }
elements = 6
order = 2
[[support]]
at = "arm.start"
fix = "position"
[[load]]
at = "arm.end"
force = [0, "4*sin(2*t)", "-3"]
[analysis]
kind = "dynamic"
end_time = 2.0
time_step = 0.02
[output]
every = 5
[[history]]
name = "tip"
at = "arm.end"
quantities = ["position", "velocity"]
"""
STATIC = ROD.replace('"dynamic"\nend_time = 2.0\ntime_step = 0.02', '"static"\nsteps = 8').replace(
    'fix = "position"', 'fix = "all"').replace("every = 5", "every = 1").replace('"4*sin(2*t)"', "2").replace(
    ', "velocity"', "")
# From t = 0.5 the force is a billion times too large.
FAILING = ROD.replace('"4*sin(2*t)"', '"t < 0.5 ? 1 : 1e10"')
MARK = "document.documentElement.dataset.evil = 1"
EVIL_TEXT = f"</script><script>{MARK}</script><img src=x onerror='{MARK}'>"
EVIL = ROD.replace("A swinging rod", EVIL_TEXT).replace("m kg s", EVIL_TEXT) + f"# {EVIL_TEXT} <!-- <script>\n"
EVIL_NAME = f"<img src=x onerror={MARK.replace(' ', '')}>"
DECKS = {"rod": ROD, "static": STATIC, "failing": FAILING, "body": SPINNING_BODY, EVIL_NAME: EVIL}


def setUpModule():
    """Runs the decks and makes their pages, once for all tests; starts the browser."""
    temporary = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(temporary.cleanup)
    Page.folder = pathlib.Path(temporary.name)
    for name, deck in DECKS.items():
        (Page.folder / f"{name}.toml").write_text(deck)
        run = subprocess.run([GXROD, "run", f"{name}.toml", "--quiet"], cwd=Page.folder, capture_output=True, text=True)
        assert run.returncode == (3 if name == "failing" else 0), run.stderr
        if name == EVIL_NAME:
            with h5py.File(Page.folder / f"{name}.vtkhdf", "r+") as file:
                file.move("histories/tip", f"histories/{EVIL_NAME}")
        subprocess.run([GXROD, "report", f"{name}.vtkhdf"], cwd=Page.folder, check=True, capture_output=True)
    Page.browser = Browser()
    unittest.addModuleCleanup(Page.browser.close)


class Page(unittest.TestCase):
    """Tests of what a page shows."""

    folder = None
    browser = None

    def open(self, name, size=LAPTOP, scheme="light"):
        self.browser.resize(size, mobile=size == PHONE)
        self.browser.prefer(scheme)
        self.browser.open(self.folder / f"{name}.html")
        self.browser.settle()

    def text(self, selector):
        return self.browser.run("return document.querySelector(arguments[0]).textContent", selector)

    def picture(self):
        """Pixels of the 3D view, without what lies over it."""
        png = self.browser.driver.find_element("css selector", "#canvas").screenshot_as_png
        pixels = np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)
        height, width, _ = pixels.shape
        return pixels[int(0.3 * height):int(0.85 * height), int(0.12 * width):int(0.95 * width)]

    def hide_all_but_parts(self):
        """Leaves only rods and bodies in the picture."""
        for name in ("grid", "reference", "shapes", "supports", "loads"):
            self.browser.run("document.getElementById(arguments[0]).click()", f"show-{name}")
        self.browser.settle()

    def slide(self, frame):
        self.browser.run("const s = document.getElementById('time-slider'); s.value = arguments[0];"
                         "s.dispatchEvent(new Event('input'))", frame)
        self.browser.settle()

    def assert_drawn(self, pixels, part=0.001):
        background = np.median(pixels.reshape(-1, 3), axis=0)
        drawn = (np.abs(pixels - background).max(axis=2) > 40).mean()
        self.assertGreater(drawn, part, "the picture is blank")

    def cursor(self, chart=0):
        """Where the line of the present time is in a chart, as a part of its width."""
        return self.browser.run("""
            const over = document.querySelectorAll('.chart .u-over')[arguments[0]];
            return new DOMMatrix(getComputedStyle(over.querySelector('.now')).transform).m41 / over.clientWidth;""", chart)


class Picture(Page):
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

    def test_shows_bodies(self):
        self.open("body")
        self.hide_all_but_parts()
        self.assert_drawn(self.picture(), 0.02)
        self.assertEqual(self.browser.take_errors(), [])


class Charts(Page):
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


class Looks(Page):
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


class Words(Page):
    def test_a_failed_run_tells_why_and_marks_where(self):
        self.open("failing")
        self.assertIn("failed", self.text("#status"))
        with h5py.File(self.folder / "failing.vtkhdf") as file:
            self.assertIn(file.attrs["reason"], self.text("#warnings"))
            self.assertGreater(len(file.attrs["reason_nodes"]), 0)
        self.assertIn("where it failed", self.text("#failure"))
        pixels = self.picture()
        red = (pixels[:, :, 0] > 200) & (pixels[:, :, 1] < 70) & (pixels[:, :, 2] < 70)
        self.assertGreater(red.sum(), 50, "no mark")
        self.open("rod")
        self.assertEqual(self.text("#warnings"), "")

    def test_tells_the_model_and_the_deck(self):
        self.open("rod")
        model = self.text("#model")
        for words in ("nodes13", "elements6", "unknowns75", "newmark-simplified", "rhoA", "arm.startx y z"):
            self.assertIn(words, model)
        deck = self.browser.run("return document.querySelector('#deck code + *, #deck pre code').textContent")
        self.assertEqual(deck, ROD)
        self.assertIn("Nothing is left out", self.text("#about"))

    def test_nothing_of_a_deck_runs(self):
        self.open(EVIL_NAME)
        self.browser.wait(lambda: self.text("#title") == EVIL_TEXT)
        self.assertIn(EVIL_TEXT, self.text("#deck"))
        self.assertIn(EVIL_NAME, self.text("#subtitle"))
        self.assertIn("<img", self.text("#charts"))
        self.assertIsNone(self.browser.run("return document.documentElement.dataset.evil ?? null"))
        self.assertEqual(self.browser.run("return document.images.length"), 0)
        self.assertEqual(self.browser.take_errors(), [])
        # Even a script or an image that did get in would not load.
        self.browser.run(f"""
            document.body.append(document.createRange().createContextualFragment(
                "<script>{MARK}</script><img src='http://127.0.0.1:9/x.png' onerror='{MARK}'>"));""")
        self.browser.settle()
        self.assertIsNone(self.browser.run("return document.documentElement.dataset.evil ?? null"))
        self.assertNotEqual(self.browser.take_errors(), [])

    def test_asks_for_nothing(self):
        self.open("rod")
        self.slide(3)
        requests = self.browser.take_requests()
        page = (self.folder / "rod.html").as_uri()
        self.assertIn(page, requests)
        self.assertEqual([url for url in requests if url != page and not url.startswith("data:")], [])
        refused = self.browser.driver.execute_async_script(
            "const done = arguments[0]; fetch('http://127.0.0.1:9/').catch((error) => done(String(error)))")
        self.assertIn("TypeError", refused)
        self.assertIn("Content Security Policy", " ".join(self.browser.take_errors()))


class Budget(Page):
    def test_is_kept_and_what_was_left_out_is_told(self):
        run = ["run", "body.toml", "--quiet", "--force", "-o", "long.vtkhdf", "--set", "analysis.steps=20000"]
        subprocess.run([GXROD, *run, "--set", "output.every=4"], cwd=self.folder, check=True)
        report = subprocess.run([GXROD, "report", "long.vtkhdf", "--budget", "1"], cwd=self.folder, check=True,
                                capture_output=True, text=True)
        self.assertLessEqual((self.folder / "long.html").stat().st_size, 1e6)
        self.assertIn("Of 5001 frames, one in", report.stdout)
        self.assertIn("of 20001 steps", report.stdout)
        self.open("long")
        self.assertIn("Of 5001 frames, one in", self.text("#left-out"))
        self.assertIn("of 20001 steps", self.text("#left-out"))
        self.assertFalse(self.browser.run("return document.getElementById('thinned').hidden"))
        self.slide(10 ** 6)
        self.assertEqual(self.text("#time-text"), "t = 1")
        self.assertEqual(self.browser.take_errors(), [])


class Program(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("body.toml", SPINNING_BODY)
        self.gxrod("run", "body.toml", "--quiet")

    def test_refuses_to_overwrite(self):
        self.assertIn("body.html (", self.gxrod("report", "body.vtkhdf").stdout)
        done = self.gxrod("report", "body.vtkhdf", code=4)
        self.assertIn("body.html: exists already (--force overwrites it)", done.stderr)
        self.gxrod("report", "body.vtkhdf", "--force")
        self.gxrod("report", "body.vtkhdf", "-o", "other.html")
        done = self.gxrod("report", "body.vtkhdf", "-o", "body.vtkhdf", "--force", code=4)
        self.assertIn("is the results file itself", done.stderr)
        h5py.File(self.folder / "body.vtkhdf").close()

    def test_tells_what_is_no_results_file(self):
        for name, said in (("none.vtkhdf", "there is no such file"), (".", "is a folder"),
                           ("body.toml", "cannot be read as results of gxrod")):
            self.assertIn(said, self.gxrod("report", name, "-o", "x.html", code=4).stderr)
        done = self.gxrod("report", "body.vtkhdf", "-o", "no/such/folder.html", code=4)
        self.assertIn("cannot be written", done.stderr)
        self.assertIn("--budget", self.gxrod("report", "body.vtkhdf", "--budget", "0.1", code=2).stderr)

    def test_takes_a_running_job(self):
        run = subprocess.Popen([GXROD, "run", "body.toml", "--quiet", "-o", "long.vtkhdf", "--set",
                                "analysis.steps=5000000"], cwd=self.folder)
        try:
            time.sleep(1.0)  # five times the longest before the first frame is in the file
            for _ in range(4):
                done = self.gxrod("report", "long.vtkhdf", "--force", "--budget", "2")
                self.assertIn("had not ended", done.stderr)
            self.assertIsNone(run.poll())
        finally:
            run.kill()
            run.wait()
        self.gxrod("report", "long.vtkhdf", "--force", "--budget", "2")


if __name__ == "__main__":
    unittest.main()
