"""The page of gxrod report: what it shows, and that nothing of a deck runs in it."""

import subprocess
import unittest

import h5py
from program import GXROD
from report_pages import EVIL_NAME, EVIL_TEXT, MARK, ROD, PageTest, set_up_pages


def setUpModule():
    set_up_pages()


class Words(PageTest):
    def test_a_failed_run_says_why_and_marks_where(self):
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

    def test_shows_the_model_and_the_deck(self):
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


class Resumed(PageTest):
    def make_page(self):
        """Of a run to t = 1 that was resumed to t = 2 with another history, and without one of the first's quantities."""
        before = ROD.replace("end_time = 2.0", "end_time = 1.0")
        after = ROD.replace(', "velocity"]', "]").replace('"A swinging rod"', '"Resumed"')
        after += '[[history]]\nname = "mid_span"\nat = "arm@0.5"\nquantities = ["position"]\n'
        (self.folder / "resumed.toml").write_text(before)
        (self.folder / "after.toml").write_text(after)
        for words in ("run resumed.toml --quiet --force", "resume resumed.vtkhdf --quiet --deck after.toml",
                      "report resumed.vtkhdf --force"):
            subprocess.run([GXROD, *words.split()], cwd=self.folder, check=True, capture_output=True)
        return after

    def chart(self, title):
        """Number of the chart, scrolled into sight and so drawn."""
        number = self.browser.run("""
            const charts = [...document.querySelectorAll('.chart:not(.along)')];
            const number = charts.findIndex((chart) => chart.querySelector('h3').textContent.startsWith(arguments[0]));
            charts[number].scrollIntoView();
            return number;""", title)
        self.browser.wait(lambda: self.browser.run(
            "return document.querySelectorAll('.chart:not(.along)')[arguments[0]].querySelector('canvas') !== null", number))
        self.browser.settle()
        return number

    def drawn_columns(self, number, halves):
        """Pixels of coloured lines in the left and the right part of a chart, off its middle."""
        return self.browser.run("""
            const canvas = document.querySelectorAll('.chart:not(.along) canvas')[arguments[0]];
            const over = document.querySelectorAll('.chart:not(.along) .u-over')[arguments[0]];
            const scale = canvas.width / canvas.clientWidth;
            const context = canvas.getContext('2d');
            return arguments[1].map(([from, to]) => {
                const left = (over.offsetLeft + from * over.clientWidth) * scale;
                const width = (to - from) * over.clientWidth * scale;
                const { data } = context.getImageData(left, 0, width, canvas.height);
                let count = 0;
                for (let i = 0; i < data.length; i += 4) {
                    const colours = [data[i], data[i + 1], data[i + 2]];
                    count += data[i + 3] > 128 && Math.max(...colours) - Math.min(...colours) > 60;
                }
                return count;
            });""", number, halves)

    def values(self, number):
        return self.browser.run("""
            return [...document.querySelectorAll('.chart:not(.along)')[arguments[0]].querySelectorAll('.value')].map((v) => v.textContent)""",
            number)

    def test_steps_that_were_not_recorded_are_gaps(self):
        deck = self.make_page()
        self.open("resumed")
        self.assertEqual(self.text("#deck pre code"), deck)
        for title, is_recorded_first in (("mid_span: position", False), ("tip: velocity", True)):
            number = self.chart(title)
            left, right = self.drawn_columns(number, [[0.05, 0.48], [0.52, 0.95]])
            self.assertEqual((left > 100, right > 100), (is_recorded_first, not is_recorded_first), title)
            self.slide(0)
            self.assertEqual("–" not in self.values(number), is_recorded_first)
            self.slide(10 ** 6)
            self.assertEqual("–" not in self.values(number), not is_recorded_first)
            self.assertEqual({value == "–" for value in self.values(number)}, {is_recorded_first})
        left, right = self.drawn_columns(self.chart("tip: position"), [[0.05, 0.48], [0.52, 0.95]])
        self.assertGreater(min(left, right), 100)
        self.assertEqual(self.browser.take_errors(), [])


class Budget(PageTest):
    def test_is_kept_and_what_was_left_out_is_listed(self):
        run = ["run", "body.toml", "--quiet", "--force", "-o", "long.vtkhdf", "--set", "analysis.steps=20000"]
        subprocess.run([GXROD, *run, "--set", "output.every=4"], cwd=self.folder, check=True)
        report = subprocess.run([GXROD, "report", "long.vtkhdf", "--budget", "1.05"], cwd=self.folder, check=True,
                                capture_output=True, text=True)
        self.assertLessEqual((self.folder / "long.html").stat().st_size, 1.05e6)
        self.assertIn("Of 5001 frames, one in", report.stdout)
        self.assertIn("of 20001 steps", report.stdout)
        self.open("long")
        self.assertIn("Of 5001 frames, one in", self.text("#left-out"))
        self.assertIn("of 20001 steps", self.text("#left-out"))
        self.assertFalse(self.browser.run("return document.getElementById('thinned').hidden"))
        self.slide(10 ** 6)
        self.assertEqual(self.text("#time-text"), "t = 1")
        self.assertEqual(self.browser.take_errors(), [])


if __name__ == "__main__":
    unittest.main()
