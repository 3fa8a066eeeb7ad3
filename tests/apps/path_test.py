"""Paths of equilibria from a deck to tables and pictures: a deep arch that sways."""

import csv
import json
import sys
import types
import unittest

import h5py
import numpy as np
from program import GXROD_PLOT, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "apps" / "python"))
sys.dont_write_bytecode = True

from gxrod.plot.compare import draw_runs, read_run  # noqa: E402
from gxrod.plot.histories import history_panels  # noqa: E402
from gxrod.plot.path import draw_paths, path_curves, split_by_stability  # noqa: E402
from gxrod.plot.results import choose_histories, read_results  # noqa: E402
from gxrod.plot.style import new_figure  # noqa: E402

DECK = SOURCE / "docs/examples/sway/sway.toml"
BIFURCATION, LIMIT, SWAYED_LIMIT = 327.6277845, 946.3035197, 411.0760129733


def read_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Paths(ProgramTest):
    def setUp(self):
        super().setUp()
        self.done = self.gxrod("run", DECK, "--summary", "summary.json")

    def test_the_run_reports_what_it_has_found(self):
        lines = self.done.stdout.splitlines()
        self.assertTrue(lines[0].startswith("path: bifurcation at λ = 327.62"), lines[0])
        self.assertTrue(lines[1].startswith("path: limit point at λ = 946.30"), lines[1])
        self.assertTrue(any(line.startswith("path.1−: limit point at λ = 411.07") for line in lines), lines)
        summary = json.loads((self.folder / "summary.json").read_text())
        self.assertEqual(summary["findings"], [line for line in lines if line.startswith("path")])

    def test_the_check_says_where_it_ends(self):
        done = self.gxrod("check", DECK)
        self.assertIn("path of equilibria until t = 0 or t = 950 or 2 critical points, and the branches that leave it",
                      done.stdout)

    def test_tables_have_load_factors_branches_and_critical_points(self):
        self.gxrod("export", "sway.vtkhdf", "--csv", "tables")
        rows = read_table(self.folder / "tables" / "history_crown.csv")
        self.assertEqual(list(rows[0])[:3], ["arc_length", "load_factor", "branch"])
        self.assertEqual({row["branch"] for row in rows}, {"0", "1", "2"})
        points = read_table(self.folder / "tables" / "stage_path_critical_points.csv")
        self.assertAlmostEqual(float(points[0]["load_factor"]) / BIFURCATION, 1.0, delta=1e-6)
        self.assertAlmostEqual(float(points[1]["load_factor"]) / LIMIT, 1.0, delta=1e-6)
        self.assertEqual(points[0]["kind"], "bifurcation")
        self.assertEqual(float(rows[int(points[0]["row"])]["load_factor"]), float(points[0]["load_factor"]))
        swayed = [float(point["load_factor"]) for point in points if point["branch"] == "1" and point["kind"] == "limit"]
        self.assertAlmostEqual(swayed[0] / SWAYED_LIMIT, 1.0, delta=1e-6)
        branches = read_table(self.folder / "tables" / "stage_path_branches.csv")
        self.assertEqual([branch["name"] for branch in branches], ["path", "path.1+", "path.1−"])

    def test_pictures_have_stable_and_unstable_stretches(self):
        def check(results):
            [stage] = results.paths()
            main, *branches = stage.paths
            stability = [is_stable for _, is_stable in split_by_stability(main)]
            self.assertEqual(stability, [True, False])
            first, _ = split_by_stability(main)[0]
            self.assertAlmostEqual(stage.load_factors[first[-1]] / BIFURCATION, 1.0, delta=1e-6)
            for branch in branches:
                self.assertEqual(branch.rows[0], first[-1])  # where it leaves the main path
        read_results(self.folder / "sway.vtkhdf", check)
        self.gxrod("sway.vtkhdf", "-o", "sway.png", program=GXROD_PLOT)
        self.gxrod("sway.vtkhdf", "--x", "crown/displacement/y", "--y", "load-factor", "-o", "xy.png", program=GXROD_PLOT)
        self.assertTrue((self.folder / "sway.png").stat().st_size > 10000)

    def test_both_axes_have_names_and_branches_do_not_join(self):
        request = types.SimpleNamespace(x="crown/displacement/x", y=["load-factor"], what="all", history=[], title=None, size=None)
        run = read_results(self.folder / "sway.vtkhdf", lambda file: read_run(file, request, "sway"))
        [axes] = draw_runs([run], request).axes
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("crown: displacement x (length)", "load factor"))
        x, y = axes.get_lines()[0].get_data()
        gaps = np.flatnonzero(np.isnan(x))
        self.assertEqual((len(gaps), list(gaps)), (2, list(np.flatnonzero(np.isnan(y)))))
        for gap in gaps:
            self.assertAlmostEqual(y[gap + 1] / BIFURCATION, 1.0, delta=1e-6)

        def labels(results):
            figure = new_figure(8, 6)
            draw_paths(figure, results.paths(), path_curves(history_panels(choose_histories(results, []))))
            return {(axes.get_xlabel(), axes.get_ylabel()) for axes in figure.axes}
        self.assertIn(("crown: displacement x (length)", "load factor λ"), read_results(self.folder / "sway.vtkhdf", labels))

    def test_shapes_are_about_the_equilibria_at_their_points(self):
        with h5py.File(self.folder / "sway.path.vtkhdf") as shapes, h5py.File(self.folder / "sway.vtkhdf") as file:
            nodes = int(shapes["VTKHDF/NumberOfPoints"][0])
            steps = shapes["VTKHDF/Steps"]
            frame = list(file["VTKHDF/Steps/Values"]).index(file["histories/time"][file["stages/path/critical_points/row"][0]])
            first = shapes["VTKHDF/Points"][int(steps["PointOffsets"][0]):][:nodes]
            np.testing.assert_array_equal(first, file["VTKHDF/Points"][frame * nodes:][:nodes])
            self.assertGreater(np.abs(shapes["VTKHDF/Points"][int(steps["PointOffsets"][1]):][:nodes] - first).max(), 1.0)

    def test_a_complete_path_is_not_resumed_but_made_longer(self):
        before = (self.folder / "sway.vtkhdf").read_bytes()
        done = self.gxrod("resume", "sway.vtkhdf")
        self.assertIn("has followed its path to the end; nothing was changed", done.stdout)
        self.assertEqual((self.folder / "sway.vtkhdf").read_bytes(), before)
        done = self.gxrod("resume", "sway.vtkhdf", "--set", "analysis.branches=0")
        self.assertIn("continues from λ = ", done.stdout)
        with h5py.File(self.folder / "sway.vtkhdf") as file:
            self.assertEqual(set(file["histories/branch"][()]), {0})
            self.assertEqual(len(file["stages/path/branches/name"]), 1)

    def test_verify_says_that_it_refines_no_path(self):
        done = self.gxrod("verify", DECK, code=2)
        self.assertIn("finds a path of equilibria; gxrod verify refines what moves", done.stderr)


if __name__ == "__main__":
    unittest.main()
