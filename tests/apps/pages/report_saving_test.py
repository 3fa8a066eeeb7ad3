"""Figures of a report as SVG and PNG, tables as CSV and LaTeX."""

import base64
import csv
import io
import re
import unittest

import h5py
import numpy as np
from PIL import Image
from report_pages import EVIL_NAME, PageTest, set_up_pages
from saving import CATCH, READ, Picture


def setUpModule():
    set_up_pages()


class Saving(PageTest):
    def saved(self):
        """{name: bytes} of what was saved since the last call."""
        return {name: base64.b64decode(data) for name, data in self.browser.driver.execute_async_script(READ)}

    def open(self, *arguments, **options):
        super().open(*arguments, **options)
        self.browser.run(CATCH)

    def save_chart(self, title):
        self.browser.run("""
            window.chart = [...document.querySelectorAll('.chart')].find((c) => c.querySelector('h2, h3').textContent.startsWith(arguments[0]));
            chart.scrollIntoView()""", title)
        self.browser.wait(lambda: self.browser.run("return chart.querySelector('canvas') !== null"))
        self.browser.settle()
        self.browser.run("chart.querySelector('[data-format=SVG]').click()")
        [(name, data)] = self.saved().items()
        self.assertTrue(name.endswith(".svg"), name)
        return Picture(data)

    def test_a_history_is_drawn_as_the_file_has_it(self):
        self.open("rod")
        picture = self.save_chart("tip: position")
        with h5py.File(self.folder / "rod.vtkhdf") as file:
            times, values = file["histories/time"][()], file["histories/tip/position"][()]
        across, upwards = picture.ticks("middle"), picture.ticks("end")
        self.assertGreater(min(len(across), len(upwards)), 2)
        to_time = np.polyfit([place for place, _, _ in across], [number for _, number, _ in across], 1)
        to_value = np.polyfit([place for place, _, _ in upwards], [number for _, number, _ in upwards], 1)
        for colour, column in (("#2f6fd0", 0), ("#c9541c", 1), ("#23875a", 2)):
            [curve] = [curve for curve in picture.curves(colour) if len(curve) > 20]
            expected = np.interp(np.polyval(to_time, curve[:, 0]), times, values[:, column])
            # Labels stand at whole pixels, curves at hundredths.
            offset = np.polyval(to_value, curve[:, 1]) - expected
            self.assertLess(np.ptp(offset), 0.02 * abs(to_value[0]) * 100)
        for words in ("tip: position, m, spatial axes", "time t, s", "x", "y", "z"):
            self.assertIn(words, picture.texts)

    def test_it_stands_alone_and_is_light_in_a_dark_page(self):
        self.open("rod", scheme="dark")
        before = self.browser.run("return document.documentElement.dataset.theme")
        picture = self.save_chart("Energies")
        text = [element.tag for element in picture.root.iter()]
        self.assertNotIn("style", "".join(text))
        for element in picture.root.iter():
            for name, value in element.attrib.items():
                self.assertNotIn("var(", value, name)
                self.assertIsNone(re.search(r"oklch|color-mix|color\(", value), value)
        self.assertTrue(picture.curves("#2f6fd0"), {element.get("stroke") for element in picture.root.iter()})
        self.assertEqual(self.browser.run("return document.documentElement.dataset.theme"), before)
        self.assertEqual(self.browser.take_errors(), [])

    def test_along_a_rod_has_its_range(self):
        self.open("rod")
        picture = self.save_chart("Along a rod")
        fills = [element.get("fill-opacity") for element in picture.plot().iter() if element.get("fill") not in (None, "none")]
        self.assertIn("0.22", fills)
        self.assertTrue(any("range over all frames" in text for text in picture.texts))

    def test_the_picture_is_saved_with_its_legend(self):
        self.open("rod")
        self.browser.run("document.getElementById('save-picture').click()")
        self.browser.wait(lambda: self.browser.run("return saved.length") == 1)
        [(name, data)] = self.saved().items()
        self.assertRegex(name, r"^rod_t_[\d.]+\.png$")
        pixels = np.asarray(Image.open(io.BytesIO(data)).convert("RGB")).astype(int)
        height, width = self.browser.run("const c = document.getElementById('canvas'); return [c.height, c.width]")
        self.assertEqual(pixels.shape[:2], (height, width))
        self.assert_drawn(pixels[height // 3:])
        bar = pixels[34, 12:252]
        self.assertGreater(np.abs(np.diff(bar[[0, 120, 239]], axis=0)).max(), 60)

    def save_table(self, title):
        self.browser.run("document.querySelector('[aria-controls=model]').click()")
        for form in ("CSV", "LaTeX"):
            self.browser.run("""
                [...document.querySelectorAll('#model section')].find((s) => s.querySelector('h2').textContent === arguments[0])
                    .querySelector(`[data-format=${arguments[1]}]`).click()""", title, form)
        files = self.saved()
        [table] = [data.decode() for name, data in files.items() if name.endswith(".csv")]
        [latex] = [data.decode() for name, data in files.items() if name.endswith(".tex")]
        return list(csv.reader(io.StringIO(table))), latex

    def test_tables_have_all_digits_as_csv_and_booktabs_as_latex(self):
        self.open("blade")
        rows, latex = self.save_table("Sections")
        self.assertEqual(rows[0][1:4], ["EA", "GAy", "GAz"])
        self.assertEqual([row[0].rstrip(" *") for row in rows[1:]], ["s", "root", "tip", "root … tip along arm"])
        self.assertAlmostEqual(float(rows[2][1]), 1e6 * 0.1 * 0.4)
        lines = latex.splitlines()
        self.assertEqual([line for line in lines if line.endswith("rule")], ["\\toprule", "\\midrule", "\\bottomrule"])
        self.assertIn("\\begin{tabular}{lr", latex)
        counts = {line.count(" & ") for line in lines if line.endswith("\\\\")}
        self.assertEqual(counts, {len(rows[0]) - 1})
        self.assertIn("$40000$", latex)

    def test_texts_are_escaped(self):
        self.open(EVIL_NAME)
        _, latex = self.save_table("Rods")
        self.assertIn("\\end{tabular}", latex)
        said = self.browser.run("""
            const table = document.querySelector('#model table');
            table.querySelector('td').replaceChildren('a_b & 50 % #1 $x {y} ~^\\\\ λ³ = −2, 1,0 "q"');
            table.closest('section').querySelector('[data-format=LaTeX]').click();
            table.querySelector('td').exact = undefined;
            table.closest('section').querySelector('[data-format=CSV]').click();""")
        self.assertIsNone(said)
        table, latex = (data.decode() for name, data in sorted(self.saved().items()))
        self.assertIn(r"a\_b \& 50 \% \#1 \$x \{y\} \textasciitilde{}\textasciicircum{}\textbackslash{} $\lambda$$^{3}$ = $-$2", latex)
        self.assertIn('a_b & 50 % #1 $x {y} ~^\\ λ³ = −2, 1,0 "q"', next(csv.reader(io.StringIO(table)))[1])
        picture = self.save_chart("<img")
        self.assertIn(EVIL_NAME, " ".join(picture.texts))


if __name__ == "__main__":
    unittest.main()
