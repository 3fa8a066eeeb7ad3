"""The picture, the charts and the looks of the page of gxrod report, in a browser."""

import io
import unittest

import h5py
import numpy as np
from browser import PHONE
from PIL import Image
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
        def come_back(file):
            file["VTKHDF/PointData/displacement"][-5 * 13:] = 0.0
        self.make_changed_page("back", come_back)
        self.open("back")
        position = lambda: int(self.browser.run("return document.getElementById('time-slider').value"))
        with h5py.File(self.folder / "back.vtkhdf") as file:
            moved = np.linalg.norm(file["VTKHDF/PointData/displacement"][:], axis=1).reshape(21, -1).max(axis=1)
        opened = position()
        self.assertEqual(opened, moved.argmax(), "it does not open where the rod has moved most")
        self.assertGreater(opened, 4)
        self.browser.run("document.getElementById('play').click()")
        self.browser.wait(lambda: 2 <= position() < opened)  # from the start
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

    def test_draws_centres_of_sections_and_tapers(self):
        self.open("rod")
        self.assertTrue(self.browser.run("return document.getElementById('show-centres').closest('label').hidden"))
        self.assertTrue(self.browser.run("return document.getElementById('centres-legend').hidden"))
        self.open("blade")
        self.assertEqual(self.text("#centres-legend"), "shear centretension centrecentre of massprincipal axes of bending")
        self.assertIn("Centres of sections", self.text("#model"))
        self.slide(0)
        # Where the tension centres are from the line, compared with the radii that are drawn, as in the section.
        first, last = self.browser.run("""
            const { rods, centres } = document.getElementById("canvas").picture().parts;
            const line = centres.lines.find(({ kind }) => kind === "tension").places.array;
            const at = [0, centres.places.length - 1].map((i) => {
                const { index, radii } = centres.places[i];
                const [x, y, z] = [0, 1, 2].map((k) => line[3 * i + k] - rods.frames[9 * index + k]);
                return { off: Math.hypot(x, y, z), radii };
            });
            return at;""")
        # Semi-axes 2 √(I/A) about the line, of the root 0.1 off it, of the tip turned by 0.3.
        turned = np.array([[np.cos(0.3) ** 2, np.sin(0.3) ** 2], [np.sin(0.3) ** 2, np.cos(0.3) ** 2]])
        tip = 2 * np.sqrt(turned @ (np.array([0.05, 0.1]) ** 2 / 12))
        root = 2 * np.sqrt(np.array([0.1, 0.4]) ** 2 / 12 + [0, 0.01])
        self.assertAlmostEqual(first["off"] / first["radii"][1], 0.1 / root[1], places=4)
        self.assertAlmostEqual(last["off"], 0.0, places=6)
        np.testing.assert_allclose(np.divide(last["radii"], first["radii"]), tip / root, rtol=1e-4)
        self.hide_all_but_parts()
        shown = self.picture()
        self.browser.run("document.getElementById('show-centres').click()")
        self.browser.settle()
        self.assertGreater((np.abs(shown - self.picture()).max(axis=2) > 40).mean(), 1e-4, "no centres are drawn")
        self.assertTrue(self.browser.run("return document.getElementById('centres-legend').hidden"))
        self.assertEqual(self.browser.take_errors(), [])

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

    def coloured(self, colour):
        """Where pixels of the whole canvas are of about a hue, as parts of its width and height: least and largest."""
        png = self.browser.driver.find_element("css selector", "#canvas").screenshot_as_png
        pixels = np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(float)
        wanted = np.array(colour) / np.linalg.norm(colour)
        norm = np.maximum(np.linalg.norm(pixels, axis=2), 1.0)
        near = (pixels @ wanted / norm > 0.985) & (pixels.max(axis=2) - pixels.min(axis=2) > 70)
        rows, columns = np.nonzero(near)
        self.assertGreater(len(rows), 20, "no pixel of that colour")
        return [columns.min() / near.shape[1], columns.max() / near.shape[1]], [rows.min() / near.shape[0], rows.max() / near.shape[0]]

    def test_shows_arrows_of_loads_whole(self):
        self.open("frame")
        self.browser.run("const c = document.getElementById('quantity'); c.value = ''; c.dispatchEvent(new Event('change'));"
                         "document.querySelector('.corner').hidden = true; document.querySelector('.top').style.visibility = 'hidden'")
        self.browser.settle()
        across, _ = self.coloured((224, 114, 42))
        self.assertLess(across[1], 0.98, "an arrow leaves the picture")
        self.assertGreater(across[1], 0.6)

    def test_keeps_the_legend_off_the_model(self):
        for name in ("frame", "rod"):
            self.open(name)
            legend = self.browser.run("const t = document.querySelector('.top').getBoundingClientRect();"
                                      "const c = document.getElementById('canvas').getBoundingClientRect();"
                                      "return (t.bottom - c.top) / c.height")
            self.hide_all_but_parts()
            self.browser.run("document.querySelector('.top').style.visibility = 'hidden';"
                             "document.querySelector('.corner').style.visibility = 'hidden'")
            self.browser.settle()
            png = self.browser.driver.find_element("css selector", "#canvas").screenshot_as_png
            pixels = np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)
            background = np.median(pixels.reshape(-1, 3), axis=0)
            rows = np.nonzero((np.abs(pixels - background).max(axis=2) > 40).any(axis=1))[0]
            self.assertGreater(rows.min() / len(pixels), legend - 0.01, name)

    def test_leaves_no_slit_where_rods_meet(self):
        """Around the corner of thick rods, lines from it to all sides but the inner one cross the rods' colour first."""
        self.open("frame")
        self.hide_all_but_parts()
        self.browser.run("const c = document.getElementById('quantity'); c.value = ''; c.dispatchEvent(new Event('change'));"
                         "const s = document.getElementById('scale'); s.value = '0'; s.dispatchEvent(new Event('change'));"
                         "const t = document.getElementById('thickness'); t.value = '2'; t.dispatchEvent(new Event('input'));"
                         "for (const o of document.querySelectorAll('.overlay')) o.style.visibility = 'hidden'")
        self.browser.settle()
        png = self.browser.driver.find_element("css selector", "#canvas").screenshot_as_png
        pixels = np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)
        rod = np.abs(pixels - np.median(pixels.reshape(-1, 3), axis=0)).max(axis=2) > 25
        rod[int(0.85 * len(rod)):] = False  # the axes in the corner
        rows, columns = np.nonzero(rod)
        top, left = rows.min(), columns.min()
        leg = rod[int(0.5 * (rows.min() + rows.max()))]
        width = leg.sum()
        self.assertGreater(width, 20)
        # The outer corner: of a square as wide as the rods, a quarter of a disc is covered, not just two of its sides.
        corner = rod[top:top + width // 2, left:left + width // 2]
        self.assertGreater(corner.mean(), 0.7, "there is a slit where the rods meet")

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
            const over = document.querySelectorAll('.chart:not(.along) .u-over')[1];
            const box = over.getBoundingClientRect();
            over.dispatchEvent(new PointerEvent('pointerdown', {clientX: box.left + 0.75 * box.width,
                clientY: box.top + 10, pointerId: 1, bubbles: true}));""")
        self.assertEqual(self.text("#frame-text"), "frame 16 of 21")
        self.assertAlmostEqual(self.cursor(), 0.75, delta=0.01)

    def test_show_the_value_at_the_time(self):
        self.open("rod")
        self.slide(12)
        with h5py.File(self.folder / "rod.vtkhdf") as file:
            expected = file["histories/tip/position"][60, 0]
        self.assertAlmostEqual(float(self.text(".chart:not(.along) .value")), expected, delta=1e-3 * expected)

    def test_are_there_for_all_that_was_recorded(self):
        self.open("rod")
        titles = self.browser.run("return [...document.querySelectorAll('.chart h3')].map((h) => h.firstChild.textContent)")
        self.assertEqual(titles, ["tip: position", "tip: velocity", "Energies", "Energy imbalance", "Linear momentum",
                                  "Angular momentum", "Step size", "Newton iterations"])
        self.open("static")
        titles = self.browser.run("return [...document.querySelectorAll('.chart h3')].map((h) => h.firstChild.textContent)")
        self.assertNotIn("Linear momentum", titles)
        self.assertEqual(self.text("#time-text"), "λ = 1")
        self.assertEqual(self.browser.take_errors(), [])


    def headings(self):
        return self.browser.run("return [...document.querySelectorAll('.chart h3')].map((h) => h.textContent)")

    def test_show_units_and_axes(self):
        self.open("frame")
        self.assertEqual([heading for heading in self.headings() if ":" in heading],
                         ["foot: reaction forceN, spatial axes", "foot: reaction momentN·mm, spatial axes",
                          "tip: displacementmm, axes of leg.end", "tip: positionmm, axes of leg.end"])
        self.assertIn("EnergiesN·mm", self.headings())
        self.assertEqual(self.text("#legend-text"), "element middles, over all frames, N·mm")
        self.assertIn("N·mm; over arc length, mm; element middles", self.text(".along"))

    def test_show_round_off_as_a_flat_line(self):
        """Of a force of 100 in the plane, what is left out of it is round-off: alone in its chart, it must not fill it."""
        self.open("frame")
        with h5py.File(self.folder / "frame.vtkhdf") as file:
            force = np.abs(file["histories/foot/reaction_force"][()]).max(axis=0)
        self.assertLess(force[2], 1e-6 * force[0])
        self.assertGreater(force[2], 0.0)
        find = ("const chart = [...document.querySelectorAll('.chart')].find((c) => "
                "c.querySelector('h3')?.textContent.startsWith('foot: reaction force'));")
        self.browser.run(f"{find} chart.scrollIntoView();")
        self.browser.wait(lambda: self.browser.run(f"{find} return Boolean(chart.querySelector('canvas'))"))
        heights = []
        for alone in range(3):
            # What is not of the background or of grey, in the part within the axes.
            heights.append(self.browser.run(f"""{find}
                [...chart.querySelectorAll('.key')].forEach((key, i) => {{
                    if ((key.getAttribute('aria-pressed') === 'true') !== (i === arguments[0])) key.click();
                }});
                return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {{
                    const canvas = chart.querySelector('canvas');
                    const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
                    let [top, bottom] = [canvas.height, 0];
                    for (let y = 0; y < canvas.height; y++) {{
                        for (let x = 0; x < canvas.width; x++) {{
                            const [r, g, b, a] = data.subarray(4 * (y * canvas.width + x));
                            if (a < 128 || Math.max(r, g, b) - Math.min(r, g, b) < 60) continue;
                            [top, bottom] = [Math.min(top, y), Math.max(bottom, y)];
                        }}
                    }}
                    done((bottom - top) / canvas.height);
                }})));""", alone))
        self.assertGreater(heights[0], 0.4, "the force is not drawn")
        self.assertGreater(heights[2], 0.0, "nothing is drawn")
        self.assertLess(heights[2], 0.08, "round-off is drawn at full height")


class AlongRod(PageTest):
    def choose(self, label, value):
        self.browser.run("const menu = document.querySelector(`.along [aria-label=${arguments[0]}]`); menu.value = arguments[1];"
                         "menu.dispatchEvent(new Event('change'))", label, value)
        self.browser.settle()

    def test_is_chosen_by_rod_quantity_and_component(self):
        self.open("frame")
        options = lambda label: self.browser.run(
            "return [...document.querySelector(`.along [aria-label=${arguments[0]}]`).options].map((o) => o.textContent)", label)
        self.assertEqual(options("Rod"), ["leg", "beam"])
        self.assertEqual(options("Component"), ["torque", "bending about y", "bending about z", "magnitude"])
        self.assertIn("λ = 1", self.text(".along"))
        before = self.canvas()
        self.choose("Rod", "1")
        other = self.canvas()
        self.assertGreater(np.abs(before - other).max(), 60)
        self.choose("Quantity", "displacement")
        self.assertIn("mm; over arc length, mm; nodes", self.text(".along"))
        self.slide(1)
        self.assertIn("λ = 0.25", self.text(".along"))
        self.assertGreater(np.abs(other - self.canvas()).max(), 60)
        self.assertEqual(self.browser.take_errors(), [])

    def canvas(self):
        png = self.browser.driver.find_element("css selector", ".along canvas").screenshot_as_png
        return np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)

    def test_has_the_range_over_time_and_the_present_values(self):
        self.open("rod")
        self.slide(7)
        # The plot's own numbers are those of the file.
        s, largest, least, present = self.browser.run("return document.querySelector('.along .chart-body').plotted().map((c) => [...c])")
        with h5py.File(self.folder / "rod.vtkhdf") as file:
            moment = file["VTKHDF/CellData/moment"][()].reshape(21, 6, 3)
            arc_length = file["VTKHDF/CellData/arc_length"][()]
        component = np.abs(moment).max(axis=(0, 1)).argmax()
        np.testing.assert_allclose(s, arc_length, rtol=1e-6)
        np.testing.assert_allclose(largest, moment[..., component].max(axis=0), rtol=1e-6, atol=1e-6)
        np.testing.assert_allclose(least, moment[..., component].min(axis=0), rtol=1e-6, atol=1e-6)
        np.testing.assert_allclose(present, moment[7, :, component], rtol=1e-6, atol=1e-6)

    def test_is_not_there_without_rods_or_their_model(self):
        self.open("body")
        self.assertFalse(self.browser.run("return Boolean(document.querySelector('.along'))"))


class Decks(PageTest):
    def test_show_headings_where_there_are_some(self):
        self.open("frame")
        self.browser.run("document.querySelector('[aria-controls=deck]').click()")
        headings = self.browser.run("return [...document.querySelectorAll('.toml-heading')].map((h) => h.textContent)")
        with open(self.folder / "frame.toml", encoding="utf-8") as deck:
            expected = [line.strip() for line in deck if line.startswith("[")]
        self.assertEqual(headings, expected)
        self.assertGreater(len(headings), 7)
        numbers = self.browser.run("return [...document.querySelectorAll('.toml-number')].map((n) => n.textContent)")
        self.assertEqual(numbers[:3], ["4e5", "0", "0"])
        self.assertIn("from", self.browser.run("return [...document.querySelectorAll('.toml-key')].map((n) => n.textContent)"))


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
