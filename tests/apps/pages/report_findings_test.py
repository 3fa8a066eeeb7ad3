"""What gxrod report puts into a page of paths, modes, eigenvalues and answers, compared with the results files.

report_findings_page_test opens such pages in a browser.
"""

import base64
import json
import re
import shutil
import unittest

import h5py
import numpy as np
from program import SOURCE, SPINNING_BODY, ProgramTest

EXAMPLES = SOURCE / "docs/examples"
COLUMN = """
[section.s]
stiffness = { EA = 1e3, GAy = 4e2, GAz = 4e2, GJ = 1, EIy = 1, EIz = 2 }
inertia = { rhoA = 1, rhoJ = 3e-4, rhoIy = 1e-4, rhoIz = 2e-4 }
damping = { mass_proportional = 0.5 }
[rod.column]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 3
[[support]]
at = "column.start"
fix = "all"
[[load]]
at = "column.end"
force = [-1, 0, 0.2]
"""
STAGES = COLUMN + """
[[stage]]
name = "press"
kind = "static"
steps = 4
[[stage]]
name = "hold"
kind = "static"
steps = 2
[[stage]]
name = "tones"
kind = "modes"
count = 4
[[stage]]
name = "more"
kind = "buckling"
[output]
every = 3
"""
SHAKEN = COLUMN + """
[[stage]]
name = "shake"
kind = "response"
omega = { from = 1, to = 60, count = 4000 }
excite = [{ at = "column.end", force = [0, 1, 0] }]
[[history]]
name = "tip"
at = "column.end"
quantities = ["position"]
[[history]]
name = "root"
at = "column.start"
quantities = ["reaction_force", "reaction_moment"]
"""


ARCH = """plane = "xy"
[parameters]
half = "pi/6"
[section.strip]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 1e4, EIy = 1e4, EIz = 1e4 }
inertia = { rhoA = 1, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.arch]
section = "strip"
arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = ["100*sin(half)", "100*cos(half)", 0], angle = "2*half" }
elements = 8
order = 3
[[support]]
at = "arch.start"
fix = ["x", "y"]
[[support]]
at = "arch.end"
fix = ["x", "y"]
[[load]]
at = "arch@0.5"
force = [0, -1, 0]
[[stage]]
name = "load"
kind = "path"
until = { points = 1, t = 200 }
branches = 1
[[stage]]
name = "tones"
kind = "modes"
count = 3
"""


class PageData:
    """The JSON and the numbers of a page."""

    def __init__(self, path):
        text = path.read_text(encoding="utf-8")
        self.info = json.loads(re.search(r'<script type="application/json" id="report">(.*?)</script>', text).group(1))
        self.blocks = dict(re.findall(r'<script type="text/plain" id="data-([^"]+)">([^<]*)</script>', text))

    def numbers(self, name, kind=np.float32):
        return np.frombuffer(base64.b64decode(self.blocks[name]), kind)

    def vectors(self, name, count):
        return self.numbers(name).reshape(count, -1, 3)


class Findings(ProgramTest):
    def make(self, name, *options):
        """The page of these results."""
        done = self.gxrod("report", f"{name}.vtkhdf", "--force", *options)
        return PageData(self.folder / f"{name}.html"), done

    def run_deck(self, name, deck=None):
        if deck is None:
            shutil.copy(EXAMPLES / name / f"{name}.toml", self.folder)
        else:
            self.write(f"{name}.toml", deck)
        self.gxrod("run", f"{name}.toml", "--quiet")

    def open(self, name):
        file = h5py.File(self.folder / f"{name}.vtkhdf")
        self.addCleanup(file.close)
        return file

    def check_shapes(self, page, swing, shapes, rotations):
        """`rotations` of the nodes in the states."""
        count, states = swing["kept"], len(swing["times"])
        block = lambda part, number: page.vectors(f"shape-{part}-{swing['block']}", number)
        data = shapes["VTKHDF/PointData"]
        as_page = lambda values, number: values[()].astype(np.float32).reshape(number, -1, 3)
        np.testing.assert_array_equal(block("places", states), as_page(shapes["VTKHDF/Points"], states))
        np.testing.assert_array_equal(block("attitudes", states), rotations.astype(np.float32).reshape(states, -1, 3))
        np.testing.assert_array_equal(block("moves", count), as_page(data["displacement"], count))
        np.testing.assert_array_equal(block("turns", count), as_page(data["rotation_vector"], count))
        self.assertEqual(f"shape-moves-imaginary-{swing['block']}" in page.blocks, swing["is_complex"])
        if swing["is_complex"]:
            np.testing.assert_array_equal(block("moves-imaginary", count), as_page(data["displacement_imaginary"], count))
            np.testing.assert_array_equal(block("turns-imaginary", count), as_page(data["rotation_vector_imaginary"], count))

    def rotations_at(self, file, times):
        """Of all nodes, in the frames at these times, which are there."""
        nodes = int(file["VTKHDF/NumberOfPoints"][0])
        frames = [list(file["VTKHDF/Steps/Values"]).index(time) for time in times]
        rotations = file["VTKHDF/PointData/rotation_vector"]
        return np.concatenate([rotations[frame * nodes:(frame + 1) * nodes] for frame in frames])

    def test_a_path_with_its_branches_and_shapes(self):
        self.run_deck("sway")
        page, _ = self.make("sway")
        file = self.open("sway")
        [path] = page.info["paths"]
        steps = len(file["histories/time"])
        self.assertEqual((path["stage"], path["first"], path["count"]), ("path", 0, steps))
        for block, name, kind in (("times", "histories/time", np.float64), ("loads", "histories/load_factor", np.float64),
                                  ("branches", "histories/branch", np.int32), ("pivots", "solver/negative_pivots", np.int32)):
            np.testing.assert_array_equal(page.numbers(f"path-{block}", kind), file[name][()])
        values = page.numbers("path-values").reshape(4, steps)
        displacement = file["histories/crown/displacement"][()]
        expected = np.column_stack([displacement, np.linalg.norm(displacement, axis=1)]).T
        np.testing.assert_allclose(values, expected, rtol=1e-6, atol=1e-12)
        points = file["stages/path/critical_points"]
        for name in ("kind", "words", "finding"):
            self.assertEqual([point[name] for point in path["points"]], list(points[name].asstr()[()]))
        for name in ("row", "load_factor", "branch", "multiplicity"):
            self.assertEqual([point[name] for point in path["points"]], list(points[name][()]))
        self.assertEqual([point["first_shape"] for point in path["points"]], list(points["first_shape"][()] - 1))
        self.assertEqual([point["shapes"] for point in path["points"]], [1, 1, 1, 1])
        branches = file["stages/path/branches"]
        self.assertEqual([branch["name"] for branch in path["paths"]], list(branches["name"].asstr()[()]))
        for name in ("parent", "critical_point"):
            self.assertEqual([branch[name] for branch in path["paths"]], list(branches[name][()]))
        times = file["histories/time"][()][points["row"][()]]
        self.assertEqual(path["swing"]["times"], list(times))
        self.check_shapes(page, path["swing"], self.open("sway.path"), self.rotations_at(file, times))

    def test_a_long_path_is_thinned_but_for_its_turns(self):
        histories = "".join(f'[[history]]\nname = "h{i}"\nat = "arch@{i / 40}"\n'
                            'quantities = ["displacement", "position", "rotation_vector", "quaternion"]\n' for i in range(1, 40, 3))
        deck = (EXAMPLES / "sway/sway.toml").read_text().replace("max_step = 0.05", "max_step = 0.02")
        self.run_deck("long", deck + histories)
        page, done = self.make("long", "--budget", "1.05")
        file = self.open("long")
        times = page.numbers("path-times", np.float64)
        steps = file["histories/time"][()]
        self.assertLess(len(times), len(steps))
        self.assertIn(f"Of {len(steps)} steps along paths, charts over the load factor have {len(times)}.", done.stdout)
        [path] = page.info["paths"]
        rows = file["stages/path/critical_points/row"][()]
        np.testing.assert_array_equal(times[[point["row"] for point in path["points"]]], steps[rows])
        kept = np.searchsorted(steps, times)
        np.testing.assert_array_equal(steps[kept], times)
        branches = file["histories/branch"][()]
        for number in range(3):
            own = np.flatnonzero(branches == number)
            self.assertTrue({own[0], own[-1]} <= set(kept), "an end of a branch is missing")
        np.testing.assert_array_equal(page.numbers("path-branches", np.int32), branches[kept])
        columns = page.numbers("path-values").reshape(-1, len(times))
        labels = [(chart["title"], chart["quantity"], label) for chart in page.info["charts"] if chart["group"] == "history"
                  for label in chart["labels"]]
        for history, quantity, component in (("crown", "displacement", 1), ("h7", "position", 0), ("h37", "quaternion", 2)):
            label = ("w" if quantity == "quaternion" else "") + "xyz"
            column = columns[labels.index((history, quantity, label[component]))]
            np.testing.assert_array_equal(column, file[f"histories/{history}/{quantity}"][:, component][kept].astype(np.float32))

    def test_modes_and_buckling_of_a_loaded_state(self):
        self.run_deck("column", STAGES)
        page, _ = self.make("column")
        file = self.open("column")
        self.assertEqual(page.info["stages"], [
            {"name": "press", "kind": "static", "from": 0.0, "until": 1.0},
            {"name": "hold", "kind": "static", "from": 1.0, "until": 2.0},
            {"name": "tones", "kind": "modes", "from": 2.0, "until": 2.0},
            {"name": "more", "kind": "buckling", "from": 2.0, "until": 2.0}])
        tones, more = page.info["modes"]
        for found, names in ((tones, ("frequency", "omega", "growth")), (more, ("factor",))):
            table = file[f"stages/{found['stage']}"]
            for name in names:
                self.assertEqual(found[name], list(table[name][()]))
            self.assertEqual(found["words"], list(table["words"].asstr()[()]))
            self.assertEqual((found["complete"], found["kind"]), (1, table.attrs["kind"]))
            self.assertEqual(found["swing"]["times"], [2.0])
            self.assertFalse(found["swing"]["is_complex"])
            self.check_shapes(page, found["swing"], self.open(f"column.{found['stage']}"), self.rotations_at(file, [2.0]))
        masses = file["stages/tones/effective_mass"][()] / file["stages/tones/total_mass"][()]
        masses[~np.isfinite(masses)] = 0.0
        np.testing.assert_allclose(tones["mass_shares"], masses, rtol=1e-12)
        self.assertNotIn("mass_shares", more)
        self.assertNotIn("paths", page.info)

    def test_modes_after_a_path_are_about_where_its_main_path_ends(self):
        self.run_deck("arch", ARCH)
        page, _ = self.make("arch")
        file = self.open("arch")
        branches = file["histories/branch"][()]
        self.assertGreater(branches[-1], 0)
        end = file["histories/time"][np.flatnonzero(branches == 0)[-1]]
        [tones] = page.info["modes"]
        self.assertEqual(tones["swing"]["times"], [end])
        self.check_shapes(page, tones["swing"], self.open("arch.tones"), self.rotations_at(file, [end]))

    def test_eigenvalues_of_a_turning_blade_are_complex(self):
        self.run_deck("turning_blade")
        page, done = self.make("turning_blade")
        file = self.open("turning_blade")
        [tones] = page.info["modes"]
        for name in ("frequency", "omega", "growth", "damping_ratio"):
            self.assertEqual(tones[name], list(file[f"stages/tones/{name}"][()]))
        self.assertTrue(tones["swing"]["is_complex"])
        self.check_shapes(page, tones["swing"], self.open("turning_blade.tones"), self.rotations_at(file, [1.0]))
        self.assertNotIn("jumps", done.stderr)  # though no load does the work of turning
        self.assertEqual(page.info["warnings"], [])

    def test_answers_to_forces_that_swing(self):
        self.run_deck("shaken", SHAKEN)
        page, _ = self.make("shaken")
        table = self.open("shaken")["stages/shake"]
        [response] = page.info["responses"]
        curves = [(curve["history"], curve["quantity"], curve["component"], curve["dimension"]) for curve in response["curves"]]
        self.assertEqual(curves, [("root", "reaction_force", 1, "force"), ("root", "reaction_moment", 2, "force·length"),
                                  ("tip", "displacement", 1, "length")])
        np.testing.assert_array_equal(page.numbers("response-omegas-0", np.float64), table["omega"][()])
        values = page.numbers("response-values-0").reshape(3, 2, -1)
        for (history, quantity, component, _), (real, imaginary) in zip(curves, values):
            expected = table[f"histories/{history}/{quantity}"][:, component].astype(np.float32)
            np.testing.assert_array_equal(np.column_stack([real, imaginary]), expected)

    def test_of_too_many_answers_the_peaks_stay(self):
        self.run_deck("shaken", SHAKEN)
        page, done = self.make("shaken", "--budget", "1.05")
        table = self.open("shaken")["stages/shake"]
        omegas = page.numbers("response-omegas-0", np.float64)
        self.assertLess(len(omegas), 4000)
        self.assertIn(f"Of 4000 frequencies of stage shake, charts have {len(omegas)}, with every peak.", done.stdout)
        self.assertEqual([omegas[0], omegas[-1]], [1.0, 60.0])
        for history, quantity, component in (("root", "reaction_moment", 2), ("tip", "displacement", 1)):
            size = np.hypot(*table[f"histories/{history}/{quantity}"][:, component].T)
            peaks = np.flatnonzero((size[1:-1] > size[:-2]) & (size[1:-1] > size[2:])) + 1
            self.assertGreater(len(peaks), 0)
            self.assertTrue(set(table["omega"][()][peaks]) <= set(omegas))

    def test_of_too_many_shapes_the_first_move(self):
        deck = STAGES.replace("elements = 8", "elements = 120").replace("count = 4", "count = 30")
        self.run_deck("column", deck)
        whole, _ = self.make("column")
        self.assertEqual(whole.info["modes"][0]["swing"]["kept"], 30)
        page, done = self.make("column", "--budget", "1.05")
        self.assertLessEqual((self.folder / "column.html").stat().st_size, 1.05e6)
        tones, more = page.info["modes"]
        kept = tones["swing"]["kept"]
        self.assertTrue(1 <= kept < 30, kept)
        self.assertEqual(len(tones["frequency"]), 30)
        self.assertIn(f"Of 30 shapes of stage tones, the first {kept} move.", done.stdout)
        # Of the nodes that are kept.
        nodes = page.numbers("reference").reshape(-1, 3)
        moves = page.vectors("shape-moves-0", kept)
        self.assertEqual(moves.shape[1], len(nodes))
        points = whole.numbers("reference").reshape(-1, 3)
        chosen = [int(np.flatnonzero((points == node).all(axis=1))[0]) for node in nodes]
        np.testing.assert_array_equal(moves, whole.vectors("shape-moves-0", 30)[:kept, chosen])

    def test_without_good_shapes_there_are_only_words(self):
        self.run_deck("column", STAGES)
        beside = self.folder / "column.tones.vtkhdf"
        shapes = beside.read_bytes()
        self.write("other.toml", STAGES.replace("steps = 4", "steps = 5"))
        self.gxrod("run", "other.toml", "--quiet")
        for content, said in ((None, "is not in the folder of the results"),
                              (shapes[:9000] + bytes([shapes[9000] ^ 1]) + shapes[9001:], "is not as the run wrote it"),
                              ((self.folder / "other.tones.vtkhdf").read_bytes(), "is of another run")):
            beside.unlink(missing_ok=True)
            if content is not None:
                beside.write_bytes(content)
            page, _ = self.make("column")
            swing = page.info["modes"][0]["swing"]
            self.assertEqual(swing["why_none"], f"The shapes do not move, because column.tones.vtkhdf {said}.")
            self.assertEqual(swing["kept"], 0)
            self.assertNotIn("shape-places-0", page.blocks)
            self.assertIn("shape-places-1", page.blocks)

    def test_runs_without_such_stages_have_nothing_more(self):
        self.run_deck("body", SPINNING_BODY)
        page, _ = self.make("body")
        for name in ("stages", "paths", "modes", "responses"):
            self.assertNotIn(name, page.info)
        self.assertEqual([name for name in page.blocks if name.startswith(("path", "shape", "response"))], [])

    def test_modes_over_a_number_of_the_deck(self):
        self.write("swept.toml", "[parameters]\nP = 1\n" + COLUMN.replace("[-1, 0, 0.2]", '["-P", 0, 0]') + """
[[stage]]
name = "press"
kind = "static"
steps = 1
[[stage]]
name = "onset"
kind = "eigenvalues"
count = 2
sweep = { key = "parameters.P", values = [0, 2, 3] }
""")
        self.gxrod("run", "swept.toml", "--quiet")
        self.gxrod("report", "swept.vtkhdf")
        info = PageData(self.folder / "swept.html").info
        self.assertNotIn("modes", info)
        [sweep] = info["sweeps"]
        with h5py.File(self.folder / "swept.vtkhdf") as file:
            stage = file["stages/onset"]
            for part in ("omega", "growth"):
                np.testing.assert_array_equal(np.array(sweep[part]).T, stage[part][()])
            self.assertEqual(sweep["words"], list(stage["words"].asstr()))
        self.assertEqual((sweep["key"], sweep["values"], sweep["speeds"]), ("parameters.P", [0, 2, 3], [0, 0, 0]))
        # B1: the column buckles at 2.458335976611.
        [onset] = sweep["onsets"]
        self.assertEqual((onset["kind"], onset["begins"]), ("divergence", True))
        self.assertAlmostEqual(onset["value"], 2.458335976611, delta=1e-5)


if __name__ == "__main__":
    unittest.main()
