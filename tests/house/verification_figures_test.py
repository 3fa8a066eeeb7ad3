"""The pictures of the validation book: what sketches read of decks, and that every kind of picture can be drawn."""

import math
import os
import pathlib
import sys
import tempfile
import unittest

import numpy as np

SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])
sys.path.insert(0, str(SOURCE / "docs" / "verification"))
sys.path.insert(0, str(SOURCE / "apps" / "python"))

from book import body_sketch, cases, convergence, deck, figures, projection, results, sketch  # noqa: E402

DECK = """[parameters]
L = "2*3"
[rod.bow]
arc = { centre = [0, 0, 0], axis = [0, 0, 2], from = ["L", 0, 0], angle = "pi/2" }
[rod.stem]
line = { from = [0, 6, 0], to = [0, 16, 0] }
y_axis = [0, 0, 1]
[function.kick]
table = [[0, 0], [1, 3], [2, 0]]
[function.push]
expression = "t < 1 ? -5*t^2 : t < 2 ? 1 : 0"
[[support]]
at = "stem.end"
fix = ["position", "rx"]
move = { rz = "-0.5*t" }
[[load]]
at = "bow@0.5"
force = ["kick(t)", 0, 0]
[[load]]
at = "stem.end"
moment = [1, 2, 0]
frame = "body"
[analysis]
kind = "dynamic"
end_time = 4
[[history]]
name = "tip"
at = "stem.end"
"""


class ReadDeck(unittest.TestCase):
    def setUp(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "deck.toml"
            path.write_text(DECK, encoding="utf-8")
            self.deck = deck.Deck(path)

    def test_expressions(self):
        self.assertEqual(self.deck.number("L^2 + max(1, 2)"), 38.0)
        push = self.deck.names["push"]
        self.assertEqual([push(0.5), push(1.5), push(3.0)], [-1.25, 1.0, 0.0])

    def test_places(self):
        place, tangent = self.deck.place("bow@0.5")
        np.testing.assert_allclose(place, [6 * math.sqrt(0.5)] * 2 + [0.0], atol=1e-3)
        np.testing.assert_allclose(tangent, [-math.sqrt(0.5), math.sqrt(0.5), 0.0], atol=0.02)
        np.testing.assert_allclose(self.deck.place("bow.end")[0], [0, 6, 0], atol=1e-12)
        np.testing.assert_allclose(self.deck.places({"tip"}), [[0, 16, 0]])

    def test_supports_and_loads(self):
        (place, tangent, held, move, axes), = self.deck.supports()
        np.testing.assert_allclose(place, [0, 16, 0])
        np.testing.assert_allclose(tangent, [0, -1, 0])  # into the rod
        self.assertEqual((held, move), ({"x", "y", "z", "rx"}, {"rz": -2.0}))
        np.testing.assert_array_equal(axes, np.eye(3))
        force, moment = self.deck.loads()
        np.testing.assert_allclose(force[2], [3, 0, 0])
        self.assertEqual((force[1], force[3]), ("force", True))
        # Section axes of the stem: x along y, y along z, z along x.
        np.testing.assert_allclose(moment[2], [0, 1, 2], atol=1e-12)

    def test_hung_lines(self):
        for name, rod, end, length in (("mooring", "line", (240, 0, 120.1), 300), ("heaving_cable", "cable", (100, 0, 20), 120)):
            curve = deck.Deck(SOURCE / "docs" / "examples" / name / f"{name}.toml").rods[rod]
            np.testing.assert_allclose(curve[-1], end, atol=1e-6)
            self.assertAlmostEqual(np.linalg.norm(np.diff(curve, axis=0), axis=1).sum() / length, 1.0, 4)

    def test_splines_and_own_axes(self):
        curve = deck.Deck(SOURCE / "docs" / "examples" / "plectoneme" / "plectoneme.toml").rods["rod"]
        np.testing.assert_allclose(curve[len(curve) // 2], [0, 5.7966, 0], atol=1e-12)
        self.assertAlmostEqual(np.linalg.norm(np.diff(curve, axis=0), axis=1).sum() / 300.0, 1.0, 3)
        *_, (_, _, _, move, axes) = deck.Deck(SOURCE / "docs" / "examples" / "winch" / "winch.toml").supports()
        self.assertEqual(list(move), ["x"])
        np.testing.assert_allclose(axes[0], [0, 0.031763, 0.999495], atol=1e-6)

    def test_other_curves_are_refused(self):
        with self.assertRaisesRegex(ValueError, "sketches know rods by line, arc, helix, catenary or spline"):
            self.deck._curve({"polyline": {}})  # pylint: disable=protected-access


class Draw(unittest.TestCase):
    def test_planes(self):
        chosen = {name: sketch.choose_projection(deck.Deck(cases.deck_of(name))).is_planar
                  for name in ("arch", "composite", "roll_up", "bend_45", "free_flight", "helix_load", "tumbling_rod")}
        self.assertEqual([name for name, is_planar in chosen.items() if is_planar], ["arch", "composite", "roll_up"])

    def test_projection(self):
        plane = projection.Projection(1)
        np.testing.assert_allclose(plane([[1, 2, 3]]), [[1, 3]])
        space = projection.Projection()
        np.testing.assert_allclose(space.rows @ space.rows.T, np.eye(2), atol=1e-12)
        self.assertGreater(space.rows[1, 2], 0.5)  # z is up

    def test_inertia_ellipsoid(self):
        sizes = np.array([1.0, 2.0, 3.0])
        inertia = 4.0 / 5.0 * (np.sum(sizes**2) - sizes**2)  # of a mass of 4
        np.testing.assert_allclose(body_sketch.semi_axes(inertia, 4.0), sizes)

    def test_numbers(self):
        texts = [sketch.number_text(value) for value in (2 * np.pi, np.pi, -10 * np.pi, 600.0, 6e5, 0.50661)]
        self.assertEqual(texts, ["2π", "π", "-10π", "600", "6e5", "0.5066"])

    def test_every_kind_of_picture(self):
        kept = results.read_kept()["cases"]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "picture.png"
            for name in ("arch", "free_flight", "tumbling_rod", "heavy_top", "rod_schemes"):
                with self.subTest(sketch=name):
                    sketch.save_sketch(path, figures.decks_of(name), {figures.KEYWORD: name})
                    self.assertEqual(figures.read_digest(path), name)
            for name in ("bend_45", "turned_bend", "roll_up", "rubin2007", "rod_schemes"):
                with self.subTest(convergence=name):
                    convergence.save_convergence(path, name, kept[name], {figures.KEYWORD: name})
                    self.assertEqual(figures.read_digest(path), name)


if __name__ == "__main__":
    unittest.main()
