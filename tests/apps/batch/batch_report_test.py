"""gxrod report of the folder of a batch: the page in a browser, and the pages of cases that it leads to."""

import base64
import csv
import io
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import tempfile
import unittest
import urllib.parse

import numpy as np
from batch_folders import BatchFolder
from browser import LAPTOP, PHONE, Browser
from PIL import Image
from program import GXROD, SPINNING_BODY, ProgramTest
from report_pages import EVIL_NAME, EVIL_TEXT, MARK
from saving import CATCH, READ, Picture

WHY = "step 12 at t = 0.12: Newton's method did not converge, residual largest at arm.end"
SCHEMES = ("newmark-simplified", "sdirk-4")


def make_grid(folder):
    """Three parameters of a grid: EI, time step and scheme; errors fall with the 2nd and 4th power of the step."""
    batch = BatchFolder(folder, ["parameters.EI", "analysis.time_step", "analysis.integrator"], ["tip", "error"])
    for stiffness in (100, 200, 500):
        for step in (0.1, 0.01, 0.001, 0.0001):
            for scheme in SCHEMES:
                has_failed = stiffness == 100 and step == 0.1
                error = -3.0 * step ** (2 if scheme == SCHEMES[0] else 4)
                batch.add([stiffness, step, scheme], ["nan", "nan"] if has_failed else [20 / stiffness + step, error],
                          status="failed" if has_failed else "done", reason=WHY if has_failed else "",
                          warning="the energy does not balance" if stiffness == 500 and step == 0.1 else "",
                          seconds=0.25 / step)
    return batch.write(cases=26)


def make_sample(folder):
    """A Latin hypercube of 300 cases; every 50th took too long."""
    random = np.random.default_rng(1)
    batch = BatchFolder(folder, ["parameters.E", "parameters.length"], ["tip"], "latin-hypercube")
    for number in range(300):
        modulus, length = random.normal(210e9, 5e9), random.uniform(0.9, 1.1)
        is_late = number % 50 == 0
        batch.add([repr(modulus), repr(length)], ["nan" if is_late else length ** 3 / modulus * 1e12],
                  status="time limit" if is_late else "done", reason="took longer than 600 s" if is_late else "")
    return batch.write()


def make_large(folder):
    batch = BatchFolder(folder, ["parameters.a", "parameters.b"], ["value"])
    for i in range(100):
        for j in range(100):
            batch.add([0.01 * i, 0.02 * j - 1], [0.01 * i * (0.02 * j - 1)], steps=i * j,
                      **({"status": "failed", "reason": f"{WHY} {i}"} if i + j > 190 else {}))
    return batch.write()


def make_evil(folder):
    batch = BatchFolder(folder, [EVIL_TEXT, "scheme"], [EVIL_NAME], plan=EVIL_TEXT, plan_text=f"# {EVIL_TEXT}",
                        title=EVIL_TEXT, decks=[{"name": EVIL_NAME, "sha256": "", "text": EVIL_TEXT, "meshes_sha256": {}}])
    for i in range(2):
        batch.add([i, EVIL_TEXT], [i], warning=EVIL_TEXT)
    batch.add([2, EVIL_NAME], ["nan"], status="crashed", reason=EVIL_TEXT)
    return batch.write()


LONG_NAMES = ("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "runge-kutta-4", "sdirk-4")


def make_names(folder):
    """Names that have no room in a row."""
    batch = BatchFolder(folder, ["analysis.integrator"], ["tip"])
    for number, name in enumerate(LONG_NAMES):
        batch.add([name], [number])
    return batch.write()


def make_mesh(folder):
    """A mesh refined for two orders, the key with two values first; values that differ in their eighth digit, and one that is constant."""
    batch = BatchFolder(folder, ["rod.a.order", "rod.a.elements"], ["constant", "close", "tip"])
    for order in (1, 2):
        for elements in (2, 4, 8, 16, 32):
            batch.add([order, elements], [7, 1000000 + 0.01 * elements, -elements**-2.0 * order], warning="long " * 200 if elements == 4 else "")
    return batch.write()


def make_steps(folder):
    """A sweep by equal differences with many values, and no plan of sampling."""
    batch = BatchFolder(folder, ["parameters.mass"], ["tip"])
    for i in range(31):
        batch.add([round(0.07 + 0.013 * i, 6)], [3e-7 * i**2 + 2e-5])
    return batch.write()


BATCHES = {"mesh": make_mesh, "steps": make_steps, "grid": make_grid, "names": make_names, "sample": make_sample, "large": make_large, "evil": make_evil}


def setUpModule():
    temporary = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(temporary.cleanup)
    BatchPageTest.folder = pathlib.Path(temporary.name)
    for name, make in BATCHES.items():
        subprocess.run([GXROD, "report", make(BatchPageTest.folder / name)], check=True, capture_output=True)
    BatchPageTest.browser = Browser()
    unittest.addModuleCleanup(BatchPageTest.browser.close)


class BatchPageTest(unittest.TestCase):
    folder = None
    browser = None

    def open(self, name, size=LAPTOP, scheme="light"):
        self.browser.resize(size, mobile=size == PHONE)
        self.browser.prefer(scheme)
        self.browser.open(self.folder / name / "report.html")
        self.browser.settle()

    def tearDown(self):
        self.assertEqual(self.browser.take_errors(), [])

    def run_script(self, script, *arguments):
        return self.browser.run(script, *arguments)

    def text(self, selector):
        return self.run_script("return document.querySelector(arguments[0]).textContent", selector)

    def choose(self, menu, value):
        self.run_script("""
            const menu = document.querySelector(arguments[0]);
            menu.value = arguments[1];
            menu.dispatchEvent(new Event('change'));""", menu, value)
        self.browser.settle()

    def tick(self, box):
        self.run_script("document.querySelector(arguments[0]).click()", box)
        self.browser.settle()

    def filter(self, text):
        self.run_script("""
            const field = document.getElementById('text-filter');
            field.value = arguments[0];
            field.dispatchEvent(new Event('input'));""", text)
        self.browser.settle()

    def headings(self):
        return self.run_script("return [...document.querySelectorAll('#table th')].map((th) => th.textContent)")

    def sort_by(self, name):
        self.run_script("""
            [...document.querySelectorAll('#table th button')].find((b) => b.textContent === arguments[0]).click()""", name)
        self.browser.settle()

    def column(self, name):
        """What is drawn of a column of the table, from its top."""
        return self.run_script("""
            const at = [...document.querySelectorAll('#table th')].findIndex((th) => th.textContent === arguments[0]);
            return [...document.querySelectorAll('#table tr[data-row]')].map((row) => row.children[at].textContent)""", name)

    def menu(self, selector):
        return self.run_script("""
            const menu = document.querySelector(arguments[0]);
            return { value: menu.value, options: [...menu.options].map((option) => option.textContent) }""", selector)

    def pixels(self):
        png = self.browser.driver.find_element("css selector", "#plot").screenshot_as_png
        return np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)

    def place(self, left, bottom):
        """Pixels of the page of a place in the chart, from its left and lower edge."""
        box = self.run_script("""
            const box = document.querySelector('#plot .u-over').getBoundingClientRect();
            return [box.left, box.bottom, box.width, box.height]""")
        return box[0] + left * box[2], box[1] - bottom * box[3]

    def point_at(self, x, y, click=False):
        kinds = ("mouseMoved", "mousePressed", "mouseReleased") if click else ("mouseMoved",)
        for kind in kinds:
            self.browser.driver.execute_cdp_cmd("Input.dispatchMouseEvent", {
                "type": kind, "x": x, "y": y, "button": "none" if kind == "mouseMoved" else "left", "clickCount": 1})
        self.browser.settle()

    def tip(self):
        return self.run_script("const tip = document.querySelector('.tip'); return tip.hidden ? null : tip.innerText")


def count_red(pixels):
    red, green, blue = pixels[:, :, 0], pixels[:, :, 1], pixels[:, :, 2]
    return ((red > 170) & (green < 80) & (blue < 80)).sum()


class Heading(BatchPageTest):
    def test_counts_the_cases_by_status(self):
        self.open("grid")
        self.assertEqual(self.text("#title"), "A rod of many kinds")
        self.assertEqual(self.text("#status"), "2 failed")
        subtitle = self.text("#subtitle")
        seconds = 6 * 0.25 * sum(1 / step for step in (0.1, 0.01, 0.001, 0.0001))
        for words in ("26 cases: 22 done, 2 failed", "2 not run yet", "2 with a warning", "plan sweep.toml", "grid",
                      f"{seconds / 3600:.3g} h of computing", "gxrod 0.1.0"):
            self.assertIn(words, subtitle)
        self.assertNotIn("seed", subtitle)
        self.open("sample")
        self.assertIn("294 done, 6 time limit", self.text("#subtitle"))
        self.assertIn("latin-hypercube, seed 7", self.text("#subtitle"))

    def test_shows_plan_and_deck(self):
        self.open("grid")
        self.assertEqual(self.text("#plan pre code"), 'deck = "rod.toml"\ncombine = "grid"\n')
        self.assertEqual(self.text("#deck pre code"), "title = 'A rod'\n")
        self.assertIn("Nothing is left out", self.text("#about"))


class Table(BatchPageTest):
    def test_sorts_numbers_as_numbers_and_what_is_missing_last(self):
        self.open("grid")
        self.assertEqual(self.headings(), ["case", "status", "EI", "analysis.time_step", "analysis.integrator", "tip", "error",
                                           "reason", "warning", "t reached", "steps", "iterations", "rejected", "seconds"])
        self.assertEqual(self.column("case"), [str(i + 1) for i in range(24)])
        self.sort_by("seconds")
        self.assertEqual(self.column("seconds")[::6], ["2.5", "25", "250", "2500"])
        self.sort_by("seconds")
        self.assertEqual(self.column("seconds")[::6], ["2500", "250", "25", "2.5"])
        for _ in range(2):
            self.sort_by("tip")
            self.assertEqual(self.column("case")[-2:], ["1", "2"])
            self.assertEqual(self.column("tip")[-2:], ["–", "–"])
        self.sort_by("analysis.integrator")
        self.assertEqual(self.column("analysis.integrator"), [SCHEMES[0]] * 12 + [SCHEMES[1]] * 12)
        self.assertEqual(self.run_script("return document.querySelectorAll('#table th[aria-sort=ascending]').length"), 1)

    def test_filters_by_words_comparisons_and_status(self):
        self.open("grid")
        self.filter("EI>=200 time_step  sdirk")
        self.assertEqual(self.column("case"), [])
        self.filter("EI >= 200 sdirk analysis.time_step<0.005")
        self.assertEqual(self.text("#shown-count"), "4 of 24 cases")
        self.assertEqual(set(self.column("EI")), {"200", "500"})
        self.assertEqual(set(self.column("analysis.integrator")), {"sdirk-4"})
        self.assertEqual(set(self.column("analysis.time_step")), {"0.001", "1·10⁻⁴"})
        self.assertIn("4 of 24", self.text("#notes"))
        self.filter("newton's METHOD")
        self.assertEqual(self.column("case"), ["1", "2"])
        self.filter("")
        self.assertEqual(self.menu("#status-filter")["options"],
                         ["every status", "done (22)", "failed (2)", "all that failed", "with a warning (2)"])
        self.choose("#status-filter", "failed")
        self.assertEqual(self.column("status"), ["failed", "failed"])
        self.assertEqual(self.column("reason"), [WHY, WHY])
        self.choose("#status-filter", "!warning")
        self.assertEqual(set(self.column("warning")), {"the energy does not balance"})
        self.filter("nothing like this")
        self.assertIn("No case passes the filter", self.text("#notes"))

    def test_of_ten_thousand_draws_the_rows_in_sight(self):
        self.open("large")
        self.assertEqual(self.text("#shown-count").replace("\u202f", ""), "10000 cases")
        drawn = lambda: self.run_script("return document.querySelectorAll('#table tr[data-row]').length")
        self.assertTrue(20 < drawn() < 120, drawn())
        self.run_script("const table = document.getElementById('table'); table.scrollTop = table.scrollHeight")
        self.browser.settle()
        self.assertEqual(self.column("case")[-1], "10000")
        self.assertTrue(20 < drawn() < 120, drawn())
        self.sort_by("value")
        self.assertEqual(self.run_script("return document.getElementById('table').scrollTop"), 0)
        self.assertEqual(self.column("value")[0], "−0.99")
        self.filter("b=0")
        self.assertEqual(self.text("#shown-count").replace("\u202f", ""), "100 of 10000 cases")

    def test_saves_the_rows_shown(self):
        self.open("grid")
        self.choose("#status-filter", "failed")
        self.sort_by("case")
        self.sort_by("case")
        saved = self.run_script("""
            let saved;
            const make = URL.createObjectURL;
            URL.createObjectURL = (blob) => make.call(URL, (saved = blob));
            HTMLAnchorElement.prototype.click = function () { this.dataset.clicked = true; };
            document.getElementById('save-rows').click();
            return saved.text();""")
        with open(self.folder / "grid" / "index.csv") as file:
            rows = {row["case"]: row for row in csv.DictReader(file)}
        read = list(csv.DictReader(io.StringIO(saved)))
        self.assertEqual([row["case"] for row in read], ["2", "1"])
        for row in read:
            for name, text in row.items():
                expected = rows[row["case"]][name]
                self.assertEqual(float(text) if name == "time" else text, float(expected) if name == "time" else expected, name)


class Chart(BatchPageTest):
    def test_begins_with_the_first_column_over_the_first_parameter(self):
        self.open("grid")
        for menu, value in (("#kind", "lines"), ("#value", "tip"), ("#across", "parameters.EI"), ("#by", "analysis.time_step")):
            self.assertEqual(self.menu(menu)["value"], value)
        self.assertEqual(self.menu("[data-fixes='analysis.integrator']"),
                         {"value": "", "options": ["all", *SCHEMES]})
        keys = self.run_script("return [...document.querySelectorAll('.key')].map((key) => key.textContent)")
        self.assertEqual(keys, ["1·10⁻⁴", "0.001", "0.01", "0.1"])
        self.assertIn("2 cases that failed", self.text("#notes"))
        self.assertGreater(count_red(self.pixels()), 20, "no cross")
        self.open("sample")
        self.assertEqual(self.menu("#kind"), {"value": "points", "options": ["lines", "points", "histogram"]})

    def test_shows_the_case_at_the_pointer_and_chooses_it(self):
        self.open("grid")
        # EI from 100 to 500 has a twentieth of its span to spare on each side; crosses are 8 pixels above the edge.
        x, y = self.place(0.05 / 1.1, 0)
        self.point_at(x, y - 8)
        self.assertIn("case 1", self.tip())
        for words in ("EI 100", "analysis.time_step 0.1", f"failed: {WHY}"):
            self.assertIn(words, self.tip())
        pointed = lambda kind: self.run_script(
            "return [...document.querySelectorAll(`#table tr.${arguments[0]}`)].map((row) => row.cells[0].textContent)", kind)
        self.assertEqual(pointed("pointed"), ["1"])
        self.assertEqual(pointed("chosen"), [])
        self.point_at(x, y - 8, click=True)
        self.assertEqual(pointed("chosen"), ["1"])
        self.assertIn(WHY, self.text("#chosen"))
        self.point_at(5, 5)
        self.assertIsNone(self.tip())
        self.assertEqual((pointed("pointed"), pointed("chosen")), ([], ["1"]))
        # And from the table to the chart.
        self.run_script("""document.querySelectorAll('#table tr[data-row]')[16].dispatchEvent(
            new PointerEvent('pointerover', { bubbles: true }))""")
        shown = self.run_script("""
            const box = document.querySelector('.ring:not(.chosen)').getBoundingClientRect();
            return [box.left + 0.5 * box.width, box.top + 0.5 * box.height]""")
        np.testing.assert_allclose(shown[0], self.place(1.05 / 1.1, 0)[0], atol=1.5)

    def test_reveals_a_chosen_row_that_is_out_of_sight(self):
        self.open("large")
        self.choose("#kind", "heat")
        self.point_at(*self.place(0.505, 0.505), click=True)
        self.assertIn("case 5051", self.tip())
        self.assertEqual(self.run_script("return document.querySelector('#table tr.chosen').cells[0].textContent"), "5051")
        top, height, first = self.run_script("""
            const table = document.getElementById('table');
            const row = document.querySelector('#table tr.chosen').getBoundingClientRect();
            const box = table.getBoundingClientRect();
            return [row.top - box.top, box.height, row.height]""")
        self.assertTrue(0 <= top <= height - first, (top, height))

    def test_draws_sizes_on_logarithmic_axes_and_labels_slopes(self):
        self.open("grid")
        self.choose("#value", "error")
        self.choose("#across", "analysis.time_step")
        self.choose("#by", "analysis.integrator")
        self.choose("[data-fixes='parameters.EI']", "2")
        ticked = lambda box: self.run_script("return document.querySelector(arguments[0]).checked", box)
        self.assertEqual((ticked("#log-value"), ticked("#log-across")), (True, True))
        keys = self.run_script("return [...document.querySelectorAll('.key')].map((key) => key.textContent)")
        self.assertEqual(keys, ["newmark-simplifiedslope 2", "sdirk-4slope 4"])
        axes = lambda: self.run_script("return document.getElementById('plot').getAttribute('aria-label')")
        self.assertEqual(axes(), "|error|, logarithmic, over analysis.time_step, logarithmic")
        # From 3e-16 to 3e-2 and from 1e-4 to 1e-1, with a twentieth more to each side.
        self.point_at(*self.place(1.05 / 1.1, 1.05 / 1.1))
        self.assertIn("error −0.03", self.tip())
        self.tick("#log-value")
        self.assertEqual(axes(), "error, over analysis.time_step, logarithmic")
        self.assertEqual(self.run_script("return document.querySelectorAll('.key .value').length"), 0)

    def test_hides_a_line_by_its_key(self):
        self.open("grid")
        before = self.pixels()
        self.tick(".key:nth-of-type(4)")
        changed = np.abs(self.pixels() - before).max(axis=2) > 40
        self.assertGreater(changed.sum(), 100)
        self.tick(".key:nth-of-type(4)")
        np.testing.assert_array_equal(self.pixels(), before)

    def test_of_heat_has_a_rectangle_a_case_and_holds_other_parameters(self):
        self.open("grid")
        self.choose("#kind", "heat")
        held = self.menu("[data-fixes='analysis.integrator']")
        self.assertEqual((held["value"], held["options"]), ("0", list(SCHEMES)))
        disabled = self.run_script("return [...document.querySelectorAll('#across option:disabled')].map((o) => o.value)")
        self.assertEqual(disabled, ["tip", "error", "case", "time", "steps", "newton_iterations", "rejected_steps", "seconds"])
        # Columns are EI = 100, 200, 500 from the left, rows the time steps from below.
        self.point_at(*self.place(0.5, 0.625))
        for words in ("EI 200", "analysis.time_step 0.01", "newmark-simplified", "tip 0.11"):
            self.assertIn(words, self.tip())
        self.point_at(*self.place(1 / 6, 0.875))
        self.assertIn(WHY, self.tip())
        self.assertEqual(self.text("#notes"), "Red crosses: 1 case that failed.")
        ticks = self.run_script("return [...document.querySelectorAll('#bar-ticks span')].map((span) => Number(span.textContent))")
        np.testing.assert_allclose([ticks[0], ticks[2]], [20 / 500 + 1e-4, 20 / 100 + 0.01], rtol=5e-3)
        colour = lambda left, bottom: self.colour_at(*self.place(left, bottom))
        self.assertGreater(np.abs(colour(0.2, 0.2) - colour(0.9, 0.2)).max(), 60)
        self.choose("#by", "analysis.integrator")
        self.assertIn("data-fixes=\"analysis.time_step\"", self.run_script("return document.getElementById('others').innerHTML"))

    def colour_at(self, x, y):
        picture = Image.open(io.BytesIO(self.browser.driver.get_screenshot_as_png())).convert("RGB")
        return np.asarray(picture.getpixel((int(x), int(y)))).astype(int)

    def test_of_samples_shows_their_statistics(self):
        self.open("sample")
        with open(self.folder / "sample" / "index.csv") as file:
            values = [float(row["tip"]) for row in csv.DictReader(file) if row["status"] == "done"]
        expected = {"mean": statistics.mean(values), "deviation": statistics.stdev(values), "least": min(values),
                    "largest": max(values), "median": statistics.median(values), "low": np.quantile(values, 0.05),
                    "high": np.quantile(values, 0.95)}
        for _ in range(2):
            for name, number in expected.items():
                self.assertAlmostEqual(float(self.text(f"#statistics [data-of={name}] b")), number, delta=1e-4 * number)
            self.assertIn("294 cases", self.text("#statistics"))
            self.assertIn("6 without a value", self.text("#statistics"))
            self.choose("#kind", "histogram")
        counts = []
        for part in np.linspace(0.06, 0.94, 80):
            self.point_at(*self.place(part, 0.3))
            words = (self.tip() or "0 case\n").split("\n")
            if not counts or counts[-1] != words:
                counts.append(words)
        self.assertEqual(sum(int(words[0].split()[0]) for words in counts), 294)
        with open(self.folder / "sample" / "index.csv") as file:
            long = [row for row in csv.DictReader(file) if float(row["parameters.length"]) > 1 and row["status"] == "done"]
        self.filter("length>1")
        self.assertEqual(self.text("#statistics strong"), f"{len(long)} cases")

    def test_takes_texts_as_categories(self):
        self.open("grid")
        self.choose("#across", "analysis.integrator")
        self.assertTrue(self.run_script("return document.getElementById('log-across').closest('label').hidden"))
        self.choose("[data-fixes='parameters.EI']", "2")
        self.choose("#by", "")
        self.choose("[data-fixes='analysis.time_step']", "3")
        # Both schemes have the same tip, half way up.
        for left, scheme in ((0.25, SCHEMES[0]), (0.75, SCHEMES[1])):
            self.point_at(*self.place(left, 0.5))
            self.assertIn(scheme, self.tip())
        self.choose("#kind", "heat")
        self.point_at(*self.place(0.75, 0.1))
        self.assertIn("sdirk-4", self.tip())


    def test_names_every_category(self):
        for size in (LAPTOP, PHONE):
            self.open("names", size)
            self.run_script("""
                window.written = [];
                const { fillText } = CanvasRenderingContext2D.prototype;
                CanvasRenderingContext2D.prototype.fillText = function (text, ...others) {
                    const { a, b, c, d, e, f } = this.getTransform();
                    window.written.push([text, (a * others[0] + c * others[1] + e) / devicePixelRatio, this.textAlign, b !== 0]);
                    fillText.call(this, text, ...others);
                };""")
            self.choose("#kind", "lines")
            self.choose("#kind", "points")
            written = {text: rest for text, *rest in self.run_script("return window.written")}
            for name in LONG_NAMES:
                self.assertIn(name, written)
                left, side, is_slanted = written[name]
                self.assertTrue(is_slanted)
                # Slanted names end at their place, and begin within the picture.
                self.assertEqual(side, "right")
                self.assertGreater(left, 0)


class Safety(BatchPageTest):
    def test_nothing_of_a_batch_runs(self):
        self.open("evil")
        self.assertEqual(self.text("#title"), EVIL_TEXT)
        self.assertIn(EVIL_TEXT, self.text("#plan"))
        self.assertIn(EVIL_TEXT, self.text("#deck"))
        self.assertIn(EVIL_TEXT, self.text("#table"))
        self.assertIn(EVIL_NAME, self.text("#table"))
        self.run_script("document.querySelectorAll('#table tr[data-row]')[2].cells[1].click()")
        self.assertIn(EVIL_TEXT, self.text("#chosen"))
        for kind in ("points", "heat", "histogram"):
            self.choose("#kind", kind)
            self.point_at(*self.place(0.5, 0.5))
        self.assertIsNone(self.run_script("return document.documentElement.dataset.evil ?? null"))
        self.assertEqual(self.run_script("return document.images.length"), 0)
        self.assertEqual(self.browser.take_errors(), [])
        self.run_script(f"""
            document.body.append(document.createRange().createContextualFragment(
                "<script>{MARK}</script><img src='http://127.0.0.1:9/x.png' onerror='{MARK}'>"));""")
        self.browser.settle()
        self.assertIsNone(self.run_script("return document.documentElement.dataset.evil ?? null"))
        self.assertNotEqual(self.browser.take_errors(), [])

    def test_asks_for_nothing(self):
        self.open("grid")
        self.choose("#kind", "histogram")
        page = (self.folder / "grid" / "report.html").as_uri()
        requests = self.browser.take_requests()
        self.assertIn(page, requests)
        self.assertEqual([url for url in requests if url != page and not url.startswith("data:")], [])


class Ticks(BatchPageTest):
    def picture(self):
        self.run_script(CATCH)
        self.run_script("document.querySelector('.stage [data-format=SVG]').click()")
        [[name, data]] = self.browser.driver.execute_async_script(READ)
        self.assertTrue(name.endswith(".svg"))
        return Picture(base64.b64decode(data))

    def assert_honest(self, ticks, is_log):
        """Labels are all different, and their numbers are where they stand."""
        self.assertGreater(len(ticks), 2)
        places, numbers, texts = zip(*ticks)
        self.assertEqual(len(set(texts)), len(texts), texts)
        values = np.log(numbers) if is_log else np.array(numbers)
        slope, start = np.polyfit(values, places, 1)
        np.testing.assert_allclose(slope * values + start, places, atol=1.1)  # labels stand at whole pixels

    def test_a_sweep_by_ratios_is_logarithmic_with_its_own_values(self):
        self.open("mesh")
        for menu, value in (("#across", "rod.a.elements"), ("#by", "rod.a.order"), ("#value", "close"), ("#kind", "lines")):
            self.assertEqual(self.menu(menu)["value"], value)
        self.assertTrue(self.run_script("return document.getElementById('log-across').checked"))
        picture = self.picture()
        across = picture.ticks("middle")
        self.assertEqual([text for _, _, text in across], ["2", "4", "8", "16", "32"])
        self.assert_honest(across, is_log=True)
        self.assert_honest(picture.ticks("end"), is_log=False)
        self.choose("#value", "tip")
        self.assert_honest(self.picture().ticks("end"), is_log=False)
        for words in ("rod.a.elements, logarithmic", "tip"):
            self.assertIn(words, self.picture().texts)

    def test_steps_are_of_1_2_or_5(self):
        for size in (LAPTOP, PHONE, (400, 800), (1280, 800)):
            self.open("steps", size)
            self.assertFalse(self.run_script("return document.getElementById('log-across').checked"))
            picture = self.picture()
            for anchor in ("middle", "end"):
                ticks = picture.ticks(anchor)
                self.assert_honest(ticks, is_log=False)
                numbers = sorted(number for _, number, _ in ticks)
                steps = np.diff(numbers)
                np.testing.assert_allclose(steps, steps[0], rtol=1e-9)
                self.assertIn(f"{steps[0]:.6e}"[0], "125")
                self.assertAlmostEqual(numbers[0] / steps[0], round(numbers[0] / steps[0]), delta=1e-6)

    def test_the_rows_shown_are_saved_as_a_table_of_latex(self):
        self.open("grid")
        self.choose("#status-filter", "failed")
        self.run_script(CATCH)
        self.run_script("document.getElementById('save-latex').click()")
        [[name, data]] = self.browser.driver.execute_async_script(READ)
        self.assertEqual(name, "grid.tex")
        lines = base64.b64decode(data).decode().splitlines()
        rows = [line for line in lines if line.endswith("\\\\")]
        self.assertEqual(len(rows), 3)
        self.assertIn("Newton's method did not converge, residual largest at arm.end", rows[1])
        self.assertEqual({row.count(" & ") for row in rows}, {rows[0].count(" & ")})
        self.assertIn("time\\_step", rows[0])

    def test_a_long_warning_is_in_full_where_its_case_is_chosen(self):
        for size in (LAPTOP, (400, 800)):
            self.open("mesh", size)
            self.run_script("[...document.querySelectorAll('#table tr[data-row]')].find((row) => row.cells[0].textContent === '2').click()")
            self.browser.settle()
            self.assertEqual(self.text("#chosen").count("long"), 200)
            self.assertLessEqual(self.run_script("const c = document.getElementById('chosen'); return c.scrollWidth - c.clientWidth"), 0)
            self.assertLessEqual(self.run_script("return document.documentElement.scrollWidth"), size[0])
            self.tick("#table tr.chosen td")


class Looks(BatchPageTest):
    def brightness(self):
        colour = self.run_script("return getComputedStyle(document.body).backgroundColor")
        return np.mean([float(x) for x in colour[colour.index("(") + 1:-1].split(",")[:3]])

    def test_light_and_dark(self):
        self.open("grid", scheme="light")
        self.assertGreater(self.brightness(), 200)
        self.assertGreater(np.median(self.pixels()), 200)
        self.browser.prefer("dark")
        self.browser.settle()
        self.assertLess(self.brightness(), 60)
        dark = self.pixels()
        self.assertLess(np.median(dark), 60)
        self.open("grid", scheme="dark")
        np.testing.assert_array_equal(dark, self.pixels())
        self.tick("#theme")
        self.assertGreater(np.median(self.pixels()), 200)

    def test_a_phone_does_not_scroll_sideways(self):
        self.open("grid", PHONE)
        for tab in ("cases", "plan", "deck", "about"):
            self.run_script("document.querySelector(`[aria-controls=${arguments[0]}]`).click()", tab)
            width = self.run_script("return Math.max(document.documentElement.scrollWidth, document.body.scrollWidth)")
            self.assertLessEqual(width, PHONE[0], tab)


class Links(ProgramTest):
    """Pages of cases whose results were kept."""

    def setUp(self):
        super().setUp()
        deck = self.folder / self.write("body.toml", SPINNING_BODY)
        self.batch = BatchFolder(self.folder / "a batch, 1#2", ["parameters.torque"], ["spin"])
        for torque in (0.5, 1, 2):
            self.batch.run(deck, f"parameters.torque={torque}", values=[torque], collected=[torque])
        self.batch.add([4], [4])
        self.root = self.batch.write(cases=5)

    def pages(self):
        return sorted(path.name for path in (self.root / "reports").glob("*"))

    def links(self, page):
        """Files to which the page leads, as a browser sees it."""
        browser = Browser()
        self.addCleanup(browser.close)
        browser.resize(LAPTOP)
        browser.open(page)
        urls = browser.run("return [...document.querySelectorAll('#table a')].map((a) => a.href)")
        for url in urls[:1]:
            browser.run("document.querySelector('#table a').click()")
            browser.wait(lambda: browser.run("return document.title").startswith("A body that spins"))
            browser.wait(lambda: browser.run("return document.documentElement.dataset.ready") == "true")
            self.assertEqual(browser.run("return location.href"), url)
        self.assertEqual(browser.take_errors(), [])
        return [pathlib.Path(urllib.parse.unquote(urllib.parse.urlparse(url).path)) for url in urls]

    def test_are_written_next_to_the_page_and_go_with_the_folder(self):
        done = self.gxrod("report", self.root)
        self.assertIn("3 written, 0 kept", done.stdout)
        self.assertIn("4 of 5 cases have ended", done.stdout)
        self.assertEqual(self.pages(), ["0001.html", "0002.html", "0003.html"])
        self.assertTrue(all(path.stat().st_size < 3e6 for path in (self.root / "reports").glob("*")))
        moved = self.folder / "moved"
        shutil.move(self.root, moved)
        self.assertEqual(self.links(moved / "report.html"), [moved / "reports" / f"000{i}.html" for i in (1, 2, 3)])

    def test_are_found_from_a_page_elsewhere(self):
        (self.folder / "there").mkdir()
        self.gxrod("report", self.root, "-o", "there/page.html")
        self.assertFalse((self.root / "report.html").exists())
        self.assertEqual(self.links(self.folder / "there" / "page.html"),
                         [self.root / "reports" / f"000{i}.html" for i in (1, 2, 3)])

    def linked(self, page="report.html"):
        text = (self.root / page).read_text()
        start = text.index('id="report">') + len('id="report">')
        return json.loads(text[start:text.index("</script>", start)])["pages"]["cases"]

    def test_are_those_asked_for_and_only_what_exists_is_linked(self):
        self.gxrod("report", self.root, "--cases", "none")
        self.assertEqual((self.linked(), (self.root / "reports").exists()), ([], False))
        self.gxrod("report", self.root, "--cases", "2..9", "--force")
        self.assertEqual((self.linked(), self.pages()), ([2, 3], ["0002.html", "0003.html"]))
        done = self.gxrod("report", self.root, "--cases", "1", "--force")
        self.assertIn("1 written, 0 kept", done.stdout)
        self.assertEqual(self.linked(), [1, 2, 3])
        for words in ("2..1", "0..3", "some", "1..", "..", "1..2x"):
            self.assertIn("expected all, none, or numbers", self.gxrod("report", self.root, "--cases", words, code=2).stderr)
        self.assertIn("is for the folder of a batch",
                      self.gxrod("report", self.root / "cases" / "0001.vtkhdf", "--cases", "all", code=2).stderr)

    def test_newer_than_the_results_are_kept_and_older_ones_are_not(self):
        self.gxrod("report", self.root)
        old, new = (self.root / "reports" / name for name in ("0001.html", "0002.html"))
        os.utime(old, (1e9, 1e9))
        stamp = new.stat().st_mtime_ns
        done = self.gxrod("report", self.root, "--force")
        self.assertIn("1 written, 2 kept", done.stdout)
        self.assertGreater(old.stat().st_mtime, 1.1e9)
        self.assertEqual(new.stat().st_mtime_ns, stamp)
        # Old pages that are not rewritten are not linked.
        os.utime(old, (1e9, 1e9))
        self.gxrod("report", self.root, "--force", "--cases", "none")
        self.assertEqual(self.linked(), [2, 3])

    def test_of_results_that_cannot_be_shown_are_listed(self):
        (self.root / "cases" / "0002.vtkhdf").write_bytes(b"no results")
        (self.root / "cases" / "0003.vtkhdf").unlink()
        done = self.gxrod("report", self.root)
        self.assertIn("0002.vtkhdf: cannot be read as results", done.stderr)
        self.assertIn("results of 1 case are in the table, but not in the folder", done.stderr)
        self.assertEqual(self.linked(), [1])

    def test_the_batch_page_is_not_overwritten(self):
        self.gxrod("report", self.root)
        self.assertIn("report.html: exists already (--force overwrites it)", self.gxrod("report", self.root, code=4).stderr)
        table = (self.root / "index.csv").read_text()
        done = self.gxrod("report", self.root, "--force", "-o", self.root / "index.csv", code=4)
        self.assertIn("not named .html", done.stderr)
        self.assertEqual((self.root / "index.csv").read_text(), table)

    def test_a_broken_batch_is_reported(self):
        done = self.gxrod("report", ".", code=4)
        self.assertIn("is a folder without batch.json", done.stderr)
        self.assertIn("gxrod batch", done.stderr)
        with open(self.root / "index.csv", "a") as file:
            file.write("5,x\n")
        self.assertIn("index.csv:6: ", self.gxrod("report", self.root, code=4).stderr)
        self.assertFalse((self.root / "report.html").exists())
        (self.root / "batch.json").write_text("{}")
        self.assertIn("batch.json", self.gxrod("report", self.root, code=4).stderr)


if __name__ == "__main__":
    unittest.main()
