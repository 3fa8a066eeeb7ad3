"""Paths, modes, eigenvalues and answers in the page of gxrod report, in a browser."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

import h5py
import numpy as np
from browser import PHONE, Browser
from program import GXROD, SOURCE
from report_pages import PageTest

DECKS = ("sway", "sagging_cable", "damped_cantilever", "turning_blade", "campbell")
MOVE = """
    const over = document.querySelector(arguments[0] + ' .u-over');
    const box = over.getBoundingClientRect();
    const at = { clientX: box.left + arguments[1], clientY: box.top + arguments[2], bubbles: true };
    over.dispatchEvent(new PointerEvent('pointermove', at));
    if (arguments[3]) over.dispatchEvent(new MouseEvent('click', at));
    const tip = over.querySelector('.tip');
    return tip.hidden ? '' : tip.textContent;"""


def setUpModule():
    temporary = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(temporary.cleanup)
    PageTest.folder = pathlib.Path(temporary.name)
    for name in DECKS:
        shutil.copy(SOURCE / f"docs/examples/{name}/{name}.toml", PageTest.folder)
        for words in (f"run {name}.toml --quiet", f"report {name}.vtkhdf"):
            subprocess.run([GXROD, *words.split()], cwd=PageTest.folder, check=True, capture_output=True)
    PageTest.browser = Browser()
    unittest.addModuleCleanup(PageTest.browser.close)


class FoundTest(PageTest):
    def setUp(self):
        self.addCleanup(lambda: self.assertEqual(self.browser.take_errors(), []))

    def results(self, name):
        file = h5py.File(self.folder / f"{name}.vtkhdf")
        self.addCleanup(file.close)
        return file

    def tabs(self):
        return self.browser.run("return [...document.querySelectorAll('[role=tab]')].map((tab) => tab.textContent)")

    def press(self, selector, number=0):
        self.browser.run("document.querySelectorAll(arguments[0])[arguments[1]].click()", selector, number)
        self.browser.settle()

    def is_playing(self):
        return self.browser.run("return document.getElementById('play').dataset.playing") == "true"

    def pause(self):
        if self.is_playing():
            self.press("#play")


class Paths(FoundTest):
    def place_of_mark(self, number):
        return self.browser.run("""
            const figure = document.querySelector('#path .figure').figure();
            const canvas = document.querySelector('#path canvas');
            const over = document.querySelector('#path .u-over');
            const ratio = canvas.width / canvas.clientWidth;
            const mark = figure.marks[arguments[0]];
            return [mark.left / ratio - over.offsetLeft, mark.top / ratio - over.offsetTop];""", number)

    def test_is_full_where_it_is_stable_and_leads_to_the_shapes(self):
        self.open("sway")
        self.assertEqual(self.tabs()[:2], ["Path", "Charts"])
        file = self.results("sway")
        branches = self.browser.run("""
            const figure = document.querySelector('#path .figure').figure();
            return figure.branches.map(({ name, rows, isStable }, i) =>
                ({ name, rows, isStable, x: figure.places[i].map(({ x }) => x), y: figure.places[i].map(({ y }) => y) }));""")
        rows = file["histories/branch"][()]
        pivots = file["solver/negative_pivots"][()]
        bifurcation = int(file["stages/path/critical_points/row"][0])
        for number, branch in enumerate(branches):
            own = list(np.flatnonzero(rows == number))
            expected = own if number == 0 else [bifurcation, *own]
            self.assertEqual(branch["rows"], expected)
            np.testing.assert_allclose(branch["y"], file["histories/load_factor"][()][expected], rtol=1e-12)
            np.testing.assert_allclose(branch["x"], file["histories/crown/displacement"][:, 0][expected], rtol=1e-6, atol=1e-9)
            stable = list(pivots[own] <= 0)
            self.assertEqual(branch["isStable"], stable if number == 0 else [stable[0], *stable])
        self.assertEqual([branch["name"] for branch in branches], ["path", "path.1+", "path.1−"])
        # Pointing at the bifurcation says what it is, pressing it goes there.
        finding = file["stages/path/critical_points/finding"].asstr()[0]
        place = self.place_of_mark(0)
        self.assertIn(finding, self.browser.run(MOVE, "#path", *place, True))
        self.browser.settle()
        time = file["histories/time"][bifurcation]
        self.assertEqual(self.text("#time-text"), f"s = {float(f'{time:.5g}'):g}")
        self.assertIn("λ = 327.6", self.text("#frame-text"))
        frame = int(np.argmin(np.abs(file["VTKHDF/Steps/Values"][()] - time)))
        self.assertIn(f"frame {frame + 1} of", self.text("#frame-text"))

    def test_swings_in_the_shape_of_a_critical_point(self):
        self.open("sway")
        before = self.picture()
        self.press("#path .swing")
        self.pause()
        self.assertIn("bifurcation at λ = 327.6", self.text("#swing-note"))
        self.assertTrue(self.browser.run("return document.getElementById('colouring').hidden"))
        self.slide(0)
        one = self.picture()
        self.slide(36)  # half a period later
        other = self.picture()
        for first, second in ((before, one), (one, other)):
            self.assertGreater((np.abs(first - second).max(axis=2) > 40).mean(), 0.001, "the picture does not move")
        self.slide(72)
        self.assertLess((np.abs(one - self.picture()).max(axis=2) > 40).mean(), 1e-4, "a period later it is elsewhere")
        self.press("#back")
        self.assertLess((np.abs(before - self.picture()).max(axis=2) > 40).mean(), 1e-4, "the run does not come back")
        self.assertTrue(self.browser.run("return document.getElementById('swing-note').hidden"))

    def test_hides_branches_and_draws_other_quantities(self):
        self.open("sway")
        range_of = lambda: self.browser.run("return document.querySelector('#path .figure').figure().x.range")
        self.assertLess(range_of()[0], -80)
        labels = self.browser.run("const { x, y } = document.querySelector('#path .figure').figure(); return [x.label, y.label]")
        self.assertEqual(labels, ["crown: displacement x, length", "load factor λ"])
        self.press("#path .keys button", 2)  # path.1−
        self.assertGreater(range_of()[0], -80)
        self.browser.run("""
            const menu = document.querySelector('#path select[aria-label=Across]');
            menu.value = [...menu.options].find((option) => option.textContent === 'crown: displacement y, length').value;
            menu.dispatchEvent(new Event('change'));""")
        self.browser.settle()
        x = self.browser.run("return document.querySelector('#path .figure').figure().places[0].map(({ x }) => x)")
        file = self.results("sway")
        main = file["histories/branch"][()] == 0
        np.testing.assert_allclose(x, file["histories/crown/displacement"][:, 1][main], rtol=1e-6)


class Modes(FoundTest):
    def positions(self):
        """Of the rods' centreline, at the phase that is shown."""
        return np.array(self.browser.run("return Array.from(document.getElementById('canvas').motion().positions)")).reshape(-1, 3)

    def test_lists_them_and_swings_in_the_chosen_one(self):
        self.open("sagging_cable")
        self.assertEqual(self.tabs()[:2], ["Modes", "Charts"])
        tones = self.results("sagging_cable")["stages/tones"]
        listed = self.browser.run("return [...document.querySelectorAll('.modes tbody')].map((body) => body.textContent)")
        self.assertEqual(len(listed), len(tones["frequency"]))
        shares = tones["effective_mass"][()] / tones["total_mass"][()]
        for text, frequency, words, share in zip(listed, tones["frequency"], tones["words"].asstr(), shares):
            self.assertIn(f"{frequency:.6g}", text)
            self.assertIn(words, text)
            for part, direction in zip(share, ("along x", "along y", "along z")):
                self.assertEqual(f"{round(100 * part)} % {direction}" in text.replace("\u00a0", " "), bool(part >= 0.005), text)
        self.press(".modes .swing", 1)
        self.assertTrue(self.is_playing())
        self.pause()
        with h5py.File(self.folder / "sagging_cable.tones.vtkhdf") as shapes:
            points = shapes["VTKHDF/Points"][()]
            move = shapes["VTKHDF/PointData/displacement"][()].reshape(-1, len(points), 3)[1]
        for step in (0, 9, 18, 36):
            self.slide(step)
            np.testing.assert_allclose(self.positions(), points + np.cos(2 * np.pi * step / 72) * move, atol=2e-6)
        self.browser.run("const s = document.getElementById('amplitude'); s.value = 1; s.dispatchEvent(new Event('input'))")
        self.slide(0)
        np.testing.assert_allclose(self.positions(), points + 2.0 * move, atol=2e-6)
        self.press(".modes .swing", 1)  # once more leaves it
        self.assertIn("frame", self.text("#frame-text"))

    def test_a_complex_shape_goes_round(self):
        self.open("turning_blade")
        with h5py.File(self.folder / "turning_blade.tones.vtkhdf") as shapes:
            points = shapes["VTKHDF/Points"][()]
            read = lambda name: shapes[f"VTKHDF/PointData/{name}"][()].reshape(-1, len(points), 3)
            real, imaginary, turns = read("displacement"), read("displacement_imaginary"), read("rotation_vector")
        mode = 0
        self.assertLess(np.linalg.norm(turns[mode], axis=1).max(), 1.9)  # so that it is drawn as large as it is
        self.press(".modes .swing", mode)
        self.pause()
        for step in (0, 9, 18, 30):
            self.slide(step)
            angle = 2 * np.pi * step / 72
            expected = points + np.cos(angle) * real[mode] - np.sin(angle) * imaginary[mode]
            np.testing.assert_allclose(self.positions(), expected, atol=2e-6)

    def test_eigenvalues_in_the_complex_plane(self):
        self.open("damped_cantilever")
        tones = self.results("damped_cantilever")["stages/tones"]
        points = self.browser.run("return document.querySelector('#modes .figure').figure().points")
        np.testing.assert_allclose([[point["x"], point["y"]] for point in points],
                                   np.column_stack([tones["growth"], tones["omega"]]), rtol=1e-12)
        # It opens on its first mode, as nothing moves in the run; pressing an eigenvalue chooses its own.
        self.assertIn("tones 1", self.text("#swing-note"))
        self.assertFalse(self.is_playing())
        self.assertIn("has no steps", self.text("#charts"))
        place = self.browser.run("""
            const canvas = document.querySelector('#modes canvas');
            const over = document.querySelector('#modes .u-over');
            const ratio = canvas.width / canvas.clientWidth;
            const point = document.querySelector('#modes .figure').figure().points[2];
            return [point.left / ratio - over.offsetLeft, point.top / ratio - over.offsetTop];""")
        self.assertIn(tones["words"].asstr()[2], self.browser.run(MOVE, "#modes", *place, True))
        self.assertIn("tones 3", self.text("#swing-note"))


class Sweeps(FoundTest):
    def setUp(self):
        super().setUp()
        self.open("campbell")
        self.press("[aria-controls=sweep]")

    def figure(self, value):
        return self.browser.run(f"const figure = document.querySelector('#sweep .figure').figure(); return {value};")

    def test_lists_where_multiples_of_the_speed_meet_modes(self):
        stage = self.results("campbell")["stages/campbell"]
        speeds, omegas = stage["speed"][()], stage["omega"][()]
        expected = []
        for mode, curve in enumerate(omegas.T):
            for multiple in range(1, 9):
                off = curve - multiple * speeds
                for i in np.flatnonzero(off[:-1] * off[1:] < 0):
                    part = off[i] / (off[i] - off[i + 1])
                    place = speeds[i] + part * (speeds[i + 1] - speeds[i])
                    fine = np.linspace(0, 20, 200001)
                    near = np.abs(np.interp(fine, speeds, curve) / np.maximum(multiple * fine, 1e-9) - 1) <= 0.1
                    at = np.searchsorted(fine, place)
                    before, after = np.flatnonzero(~near[:at]), np.flatnonzero(~near[at:])
                    ends = fine[before[-1] + 1] if len(before) else 0, fine[at + after[0] - 1] if len(after) else 20
                    expected.append((place, multiple, mode, multiple * place, *ends))
        expected.sort()
        self.assertGreater(len(expected), 8)
        found = self.figure("figure.crossings.map((c) => [c.place, c.multiple, c.mode, c.frequency, c.from, c.until])")
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=2e-4)
        rows = self.browser.run("return [...document.querySelectorAll('.crossings tbody tr')].map((row) => row.textContent)")
        self.assertEqual(len(rows), min(len(expected), 40))
        self.assertIn(f"{expected[0][1]}P", rows[0])
        self.assertEqual(self.figure("figure.y.range[0]"), 0)
        self.assertEqual(self.figure("figure.rays.map(({ multiple }) => multiple)"), list(range(1, 9)))

    def test_a_press_on_a_curve_shows_the_shape_there(self):
        stage = self.results("campbell")["stages/campbell"]
        value, mode = 30, 1
        place = self.browser.run("""
            const canvas = document.querySelector('#sweep canvas');
            const over = document.querySelector('#sweep .u-over');
            const ratio = canvas.width / canvas.clientWidth;
            const point = document.querySelector('#sweep .figure').figure().lines[arguments[1]][arguments[0]];
            return [point.left / ratio - over.offsetLeft, point.top / ratio - over.offsetTop];""", value, mode)
        words = stage["words_at_values"].asstr()[6 * value + mode]
        self.assertIn(words, self.browser.run(MOVE, "#sweep", *place, True))
        self.pause()
        self.assertIn(words, self.text("#swing-note"))
        self.assertIn("campbell 2", self.text("#swing-note"))
        self.slide(18)
        with h5py.File(self.folder / "campbell.campbell.vtkhdf") as file:
            nodes = int(file["VTKHDF/NumberOfPoints"][0])
            rows = slice((6 * value + mode) * nodes, (6 * value + mode + 1) * nodes)
            expected = file["VTKHDF/Points"][rows] - file["VTKHDF/PointData/displacement_imaginary"][rows]
        positions = self.browser.run("return Array.from(document.getElementById('canvas').motion().positions)")
        np.testing.assert_allclose(np.array(positions).reshape(-1, 3), expected, atol=2e-6)


class Responses(FoundTest):
    def test_amplitudes_and_phases_over_the_frequency(self):
        self.open("damped_cantilever")
        self.press("[aria-controls=response]")
        stages = self.results("damped_cantilever")["stages"]
        omegas = stages["shake/omega"][()]
        answers = stages["shake/histories/tip/displacement"][:, 1]
        moments = stages["shake/histories/root/reaction_moment"][:, 2]
        phase_of = lambda complex_parts: np.degrees(np.unwrap(np.arctan2(complex_parts[:, 1], complex_parts[:, 0])))
        curves = """
            return [...document.querySelectorAll('#response .figure')].map((body) => {
                const { x, y, lines, ticks } = body.figure();
                return { isLog: [x.isLog, y.isLog], xs: lines[0].map((p) => p.x), ys: lines[0].map((p) => p.y), ticks: ticks.map((t) => t.value) };
            });"""
        root, turned, amplitude, phase = self.browser.run(curves)
        self.assertEqual((root["isLog"], amplitude["isLog"], phase["isLog"]), ([True, True], [True, True], [True, False]))
        np.testing.assert_allclose(amplitude["xs"], omegas, rtol=1e-12)
        np.testing.assert_allclose(amplitude["ys"], np.hypot(*answers.T), rtol=1e-6)
        np.testing.assert_allclose(phase["ys"], phase_of(answers), atol=1e-3)
        self.assertLess(phase_of(moments)[-1], -200)  # without a jump back by a turn
        np.testing.assert_allclose(turned["ys"], phase_of(moments), atol=1e-3)
        np.testing.assert_allclose(amplitude["ticks"], stages["tones/omega"][()], rtol=1e-12)
        self.browser.run("const m = document.querySelector('#response select'); m.value = 'frequency'; m.dispatchEvent(new Event('change'))")
        np.testing.assert_allclose(self.browser.run(curves)[2]["xs"], omegas / (2 * np.pi), rtol=1e-12)


class Stages(FoundTest):
    def test_the_player_names_the_stage(self):
        self.open("sagging_cable")
        file = self.results("sagging_cable")
        times = file["VTKHDF/Steps/Values"][()]
        for frame, time in enumerate(times):
            self.slide(frame)
            self.assertIn("hang · frame" if time <= 1.0 else "slacken · frame", self.text("#frame-text"))
        self.assertIn("static, modes", self.text("#subtitle"))

    def test_charts_have_a_dashed_line_where_a_stage_starts(self):
        self.open("sagging_cable")
        self.press("[aria-controls=charts]")
        self.slide(0)
        self.browser.wait(lambda: self.browser.run("return document.querySelector('.chart:not(.along) canvas') !== null"))
        self.browser.settle()
        drawn = self.browser.run("""
            const canvas = document.querySelector('.chart:not(.along) canvas');
            const over = document.querySelector('.chart:not(.along) .u-over');
            const ratio = canvas.width / canvas.clientWidth;
            return [0.375, 0.5].map((part) => {
                const left = Math.round((over.offsetLeft + part * over.clientWidth) * ratio) - 1;
                const { data } = canvas.getContext('2d').getImageData(left, over.offsetTop * ratio, 3, over.clientHeight * ratio);
                let count = 0;
                for (let i = 0; i < data.length; i += 4) count += data[i + 3] > 60 && Math.max(data[i], data[i + 1], data[i + 2]) < 140;
                return count;
            });""")  # before the second stage starts, and there
        self.assertLess(drawn[0], 12)
        self.assertGreater(drawn[1], 40)


class Looks(FoundTest):
    def test_a_phone_does_not_scroll_sideways(self):
        for name, tabs in (("sway", ["path"]), ("sagging_cable", ["modes"]), ("damped_cantilever", ["modes", "response"])):
            self.open(name, PHONE)
            for tab in tabs:
                self.press(f"[aria-controls={tab}]")
                width = self.browser.run("return Math.max(document.documentElement.scrollWidth, document.body.scrollWidth)")
                self.assertLessEqual(width, PHONE[0], (name, tab))


if __name__ == "__main__":
    unittest.main()
