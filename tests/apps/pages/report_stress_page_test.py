"""Stresses on the page of gxrod report, in a browser: colours of rods, sections, envelopes and the table of rods."""

import base64
import io
import re
import unittest

import gxrod_stress
import h5py
import numpy as np
import report_pages
from PIL import Image
from report_pages import PageTest, set_up_pages
from saving import CATCH, READ, SVG, Picture


def setUpModule():
    report_pages.DECKS = {"frame": gxrod_stress.FRAME, "plain": gxrod_stress.FRAME.replace('stresses = "von-mises"', "")}
    set_up_pages()


class StressPage(PageTest):
    def open_stress(self):
        self.open("frame")
        self.browser.run("document.querySelector('[aria-controls=stress]').click()")
        self.browser.settle()

    def show_section(self):
        self.browser.run("document.querySelector('.section').scrollIntoView()")
        self.browser.settle()
        self.browser.settle()

    def choose(self, label, value):
        self.browser.run("const menu = document.querySelector(`#stress select[aria-label=${arguments[0]}]`); menu.value = arguments[1];"
                         "menu.dispatchEvent(new Event('change'))", label, value)
        self.browser.settle()

    def rows(self):
        return self.browser.run("return [...document.querySelectorAll('.utilisation tbody tr')].map(row => [...row.children].map(cell => cell.textContent))")

    def panel(self, what):
        return self.browser.run(f"const panel = document.querySelector('.section').panel(); return {what}")

    def test_the_table_has_the_worst_of_each_rod(self):
        self.open_stress()
        with h5py.File(self.folder / "frame.vtkhdf") as file:
            names = [name.decode() for name in file["rods/name"][()]]
            rods, exposure = file["envelopes/rod"][()], file["envelopes/exposure/value"][()]
        worst = {name: np.nanmax(exposure[rods == row]) for row, name in enumerate(names) if np.isfinite(exposure[rods == row]).any()}
        shown = self.rows()
        self.assertEqual([row[0] for row in shown], sorted(worst, key=lambda name: -worst[name]))
        for name, value, *_ in shown:
            self.assertEqual(value, f"{worst[name]:.4g}")
        over = self.browser.run("return [...document.querySelectorAll('.utilisation td.bad')].map(cell => cell.textContent)")
        self.assertEqual(len(over), sum(value > 1 for value in worst.values()))
        self.assertGreater(len(over), 0)
        self.assertIn(f"{len(over)} rod", self.text(".utilisation .note"))

    def test_the_section_shows_stresses_of_the_frame(self):
        self.open_stress()
        self.show_section()
        self.choose("Rod", "0")
        with h5py.File(self.folder / "frame.vtkhdf") as file:
            cells = file["VTKHDF/CellData"]
            count = len(cells["rod"])
            own = np.flatnonzero(cells["rod"][()] == 0)
            middles, sections = cells["arc_length"][()][own], cells["section"][()][own]
            for frame, s in ((3, 0.1), (6, 2.9)):
                self.slide(frame)
                self.panel(f"panel.place.choose(0, {s})")
                self.browser.settle()
                cell = own[np.abs(middles - s).argmin()]
                row = frame * count + cell
                resultants = np.concatenate([cells["force"][row], cells["moment"][row]])
                group = file[f"sections/{sections[np.abs(middles - s).argmin()]}"]
                stress = group["stress_operator"][()].reshape(-1, 6, 6).astype(float) @ resultants
                for measure, expected in (("sigma_xx", stress[:, 0]), ("tau", np.hypot(stress[:, 4], stress[:, 5]))):
                    self.choose("Stress", measure)
                    shown = np.array(self.panel("Array.from(panel.values)"))
                    np.testing.assert_allclose(shown, expected, atol=1e-5 * np.abs(expected).max())
                self.choose("Stress", "von_mises")
                point = self.panel("panel.found")
                y, z = group["points"][point]
                self.assertAlmostEqual(self.panel("Math.max(...panel.values)") / cells["von_mises"][row], 1.0, 5)
                self.assertIn("N/m²", self.text(".extreme"))
                numbers = [float(text.replace("−", "-")) for text in re.search(r"at \((.*?), (.*?)\)", self.text(".extreme")).groups()]
                np.testing.assert_allclose(numbers, [y, z], atol=1e-3 * 0.1)

    def test_a_row_leads_to_its_place_and_the_clock_ends_that(self):
        self.open_stress()
        self.show_section()
        self.browser.run("document.querySelectorAll('.utilisation tbody tr')[0].click()")
        self.browser.settle()
        [name, value, *_] = self.rows()[0]
        self.assertIn("worst of all steps", self.text(".section .place output"))
        with h5py.File(self.folder / "frame.vtkhdf") as file:
            envelope = file["envelopes"]
            row = np.nanargmax(envelope["exposure/value"][()])
            expected = envelope["von_mises/value"][row]
        self.assertAlmostEqual(self.panel("Math.max(...panel.values)") / expected, 1.0, 4)
        self.browser.run("document.querySelectorAll('.utilisation tbody tr')[1].click()")
        self.browser.settle()
        ring, place = self.browser.run("""
            const { plot, figure, attention } = document.querySelector("#stress .figure").chart();
            const { m41, m42 } = new DOMMatrix(getComputedStyle(plot.rings.chosen).transform);
            const { left, top } = figure.find(plot, attention.chosen);
            return [[m41, m42], [left, top]];""")
        np.testing.assert_allclose(ring, place, atol=0.5)
        self.slide(1)
        self.assertNotIn("worst", self.text(".section .place output"))

    def test_the_envelope_is_that_of_the_file(self):
        self.open_stress()
        rod = self.browser.run("return Number(document.querySelector('#stress select[aria-label=Rod]').value)")
        line = self.browser.run("return document.querySelector('#stress .figure').figure().line.map(({ x, y }) => [x, y])")
        with h5py.File(self.folder / "frame.vtkhdf") as file:
            own = file["envelopes/rod"][()] == rod
            expected = np.column_stack([file["envelopes/arc_length"][()][own], file["envelopes/exposure/value"][()][own]])
        self.assertEqual(len(line), len(expected))
        np.testing.assert_allclose(np.sort(np.array(line), axis=0), np.sort(expected, axis=0), rtol=1e-5, atol=1e-7)

    def test_rods_are_coloured_by_stress(self):
        self.open("frame")
        for name in ("von_mises", "exposure"):
            self.browser.run("const menu = document.getElementById('quantity'); menu.value = arguments[0]; menu.dispatchEvent(new Event('change'))", name)
            self.slide(5)
            values = np.array(self.browser.run("return Array.from(document.getElementById('canvas').picture().values)"), dtype=float)
            with h5py.File(self.folder / "frame.vtkhdf") as file:
                count = len(file["VTKHDF/CellData/rod"])
                expected = file[f"VTKHDF/CellData/{name}"][5 * count : 6 * count]
            np.testing.assert_allclose(values, expected, rtol=1e-6)
            self.assertTrue(self.browser.run("return document.getElementById('component').hidden"))
        self.assertEqual(self.browser.take_errors(), [])

    def test_a_click_on_a_rod_chooses_a_place(self):
        self.open_stress()
        self.show_section()
        x, y = self.browser.run("""
            const { motion, stage, data } = document.getElementById("canvas").picture();
            const canvas = document.getElementById("canvas");
            const cell = data.cellRods.lastIndexOf(1);
            const node = data.connectivity[data.offsets[cell]];
            const point = stage.centre.clone().fromArray(motion.positions, 3 * node).project(stage.camera);
            return [0.5 * (1 + point.x) * canvas.clientWidth, 0.5 * (1 - point.y) * canvas.clientHeight];""")
        for kind in ("pointerdown", "pointerup"):
            self.browser.run("const canvas = document.getElementById('canvas'); const box = canvas.getBoundingClientRect();"
                             "canvas.dispatchEvent(new PointerEvent(arguments[0], { clientX: box.left + arguments[1], clientY: box.top + arguments[2], pointerId: 1 }))",
                             kind, x, y)
        self.browser.settle()
        self.assertEqual(self.panel("panel.place.rod"), 1)
        with h5py.File(self.folder / "frame.vtkhdf") as file:
            middle = file["VTKHDF/CellData/arc_length"][()][file["VTKHDF/CellData/rod"][()] == 1][-1]
            length = file["rods/length"][1]
        self.assertAlmostEqual(self.panel("panel.place.s"), 2 * middle - length, delta=0.02 * length)

    def test_sections_and_tables_are_saved(self):
        self.open_stress()
        self.show_section()
        self.browser.run(CATCH)
        self.browser.run("document.querySelector('.section [data-format=SVG]').click();"
                         "document.querySelectorAll('.utilisation .save button').forEach((key) => key.click())")
        files = {name.rsplit(".")[-1]: base64.b64decode(data) for name, data in self.browser.driver.execute_async_script(READ)}
        picture = Picture(files["svg"])
        [image] = [element for element in picture.root.iter(f"{SVG}image")]
        pixels = np.asarray(Image.open(io.BytesIO(base64.b64decode(image.get("href").split(",")[1]))).convert("RGBA")).astype(int)
        self.assertGreater((pixels[..., 3] == 255).mean(), 0.01)
        ticks = self.browser.run("return [...document.querySelectorAll('.section-ticks span')].map((tick) => tick.textContent)")
        for words in (*ticks, "y", "z"):
            self.assertIn(words, picture.texts)
        table = files["csv"].decode().splitlines()
        self.assertEqual(len(table), 1 + len(self.rows()))
        self.assertEqual(files["tex"].decode().count("\\\\"), 1 + len(self.rows()))

    def test_pages_without_stresses_have_no_tab(self):
        self.open("plain")
        self.assertFalse(self.browser.run("return document.querySelector('[aria-controls=stress]') !== null"))
        text = (self.folder / "plain.html").read_text(encoding="utf-8")
        for name in ("data-section-", "data-envelope-", "data-von_mises", "cell_scalars"):
            self.assertNotIn(f'id="{name}' if name.startswith("data") else f'"{name}":', text)


if __name__ == "__main__":
    unittest.main()
