"""The page that gxrod verify DECK -o writes, in a browser."""

import unittest

from browser import LAPTOP, PHONE, Browser
from program import SPINNING_BODY, ProgramTest
from report_pages import EVIL_TEXT
from verify_deck_test import SWING


class VerifyPage(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def show(self, text, *options):
        (self.folder / "deck.toml").write_text(text)
        self.gxrod("verify", "deck.toml", "-o", "page.html", *options)
        self.browser.resize(LAPTOP)
        self.browser.open(self.folder / "page.html")

    def texts(self, selector):
        return self.browser.run("return [...document.querySelectorAll(arguments[0])].map(e => e.textContent)", selector)

    def test_shows_what_was_found(self):
        self.show(SWING)
        self.assertEqual(self.texts("h1"), ["A beam that swings"])
        self.assertEqual(self.texts("#status"), ["not all is right to 1 %"])
        self.assertIn("gxrod verify deck.toml · dynamic · 11 runs", self.texts("#subtitle")[0])
        self.assertTrue(self.texts("#judgement li")[0].startswith("Right to 1 % of their largest change: "))
        self.assertEqual(self.texts("#errors tbody th"), ["tip position", "tip moment", "root reaction force"])
        self.assertIn("the same to the last bit", self.texts("#properties td.words"))
        self.assertEqual(len(self.texts("#runs tbody tr")), 11)
        self.assertIn("tip position: estimated error, relative to its change", self.texts("#charts h3"))
        self.browser.wait(lambda: self.browser.run("return document.querySelectorAll('#charts canvas').length") > 1)
        for size in (PHONE, LAPTOP):
            self.browser.resize(size, size == PHONE)
            self.browser.settle()
            self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), size[0])
        self.assertEqual(self.browser.take_errors(), [])
        self.assertTrue(all(request.startswith(("file:", "data:")) for request in self.browser.take_requests()))

    def test_what_is_right_is_green(self):
        self.show(SWING, "--set", "rod.beam.order=3", "--levels", "1")
        self.assertEqual(self.texts("#status"), ["right to 1 %"])
        self.assertEqual(self.browser.run("return document.getElementById('status').dataset.status"), "complete")
        self.assertEqual(self.texts("#errors td.wrong"), [])
        # Too little is known for orders.
        self.assertIn("–", self.texts("#errors tbody tr:first-child td"))

    def test_what_is_not_known_is_not_green(self):
        self.show(SWING, "--set", "analysis.time_step=1", "--set", "load[0].force=[0, '300*sin(t)^2', 0]")
        self.assertEqual(self.texts("#status"), ["errors are not known"])
        self.assertEqual(self.texts("#errors td.right"), [])
        self.assertEqual(self.texts("#errors td.wrong"), ["?", "?", "?"])
        self.assertEqual(self.browser.take_errors(), [])

    def test_a_body_has_no_mesh(self):
        self.show(SPINNING_BODY)
        self.assertEqual(self.browser.take_errors(), [])
        self.assertIn("half the step", self.texts("#runs tbody th"))

    def test_texts_stay_texts(self):
        self.show(SPINNING_BODY.replace("A body that spins", EVIL_TEXT.replace("\\", "\\\\").replace('"', '\\"')), "--levels", "1")
        self.assertEqual(self.texts("h1"), [EVIL_TEXT])
        self.assertEqual(self.browser.take_errors(), [])

    def test_a_page_is_not_overwritten_unasked(self):
        (self.folder / "deck.toml").write_text(SPINNING_BODY)
        (self.folder / "page.html").write_text("mine")
        self.assertIn("page.html", self.gxrod("verify", "deck.toml", "-o", "page.html", code=4).stderr)
        self.assertEqual((self.folder / "page.html").read_text(), "mine")
        self.gxrod("verify", "deck.toml", "-o", "page.html", "--force", "--levels", "1")
        self.assertIn("gxrod verify", (self.folder / "page.html").read_text())

    def test_of_a_deck_that_fails(self):
        (self.folder / "deck.toml").write_text(SWING.replace("3*sin(t)^2", "1e9*t"))
        self.gxrod("verify", "deck.toml", "-o", "page.html", "--set", "analysis.newton.max_iterations=2", code=3)
        self.browser.open(self.folder / "page.html")
        self.assertEqual(self.texts("#status"), ["does not reach its end"])
        self.assertEqual(self.browser.take_errors(), [])


if __name__ == "__main__":
    unittest.main()
