"""What bodies look like: from `looks` in a deck to results, reports, pictures and ParaView. No number of the mechanics changes."""

import base64
import json
import re
import sys
import unittest

import h5py
import numpy as np
from program import GXROD_PLOT, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "apps" / "python"))
sys.dont_write_bytecode = True

from gxrod.results import open_results  # noqa: E402

PLAIN = """title = "A bell and its clapper"
units = "m kg s"
gravity = [0, 0, -9.81]
[body.bell]
mass = 2
inertia = [0.03, 0.04, 0.05]
centre_of_mass = [0, 0, -0.3]
rotation_vector = [0, 0.4, 0]
#bell
[body.clapper]
mass = 0.5
inertia = [0.001, 0.001, 0.0005]
at = [0, 0, -0.3]
angular_velocity = [0, 1, 0]
velocity = [-0.1, 0, 0]
[joint.axle]
type = "hinge"
between = ["ground", "bell"]
axis = [0, 1, 0]
[joint.eye]
type = "ball"
between = ["bell", "clapper"]
at = [0, 0, -0.2]
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 0.3
time_step = 0.01
[[stage]]
name = "go_on"
kind = "dynamic"
integrator = "radau-5"
end_time = 0.2
time_step = 0.01
[output]
every = 5
[[history]]
name = "eye"
at = "eye"
quantities = ["force"]
"""
PYRAMID = """solid p
facet normal 0 0 -1
outer loop
vertex 0 0 0
vertex 0 40 0
vertex 30 0 0
endloop
endfacet
facet normal 0 -1 0
outer loop
vertex 0 0 0
vertex 30 0 0
vertex 0 0 50
endloop
endfacet
facet normal -1 0 0
outer loop
vertex 0 0 0
vertex 0 0 50
vertex 0 40 0
endloop
endfacet
facet normal 1 1 1
outer loop
vertex 30 0 0
vertex 0 40 0
vertex 0 0 50
endloop
endfacet
endsolid p
"""
LOOKS = """looks = [
  { box = { size = [0.2, 0.1, 0.4], at = [0, 0, -0.3] } },
  { mesh = { file = "pyramid.stl", scale = 1e-3, rotation_vector = [0, 0, "pi"] } },
  { arms = 0 },
]
"""
DRAWN = PLAIN.replace("#bell\n", LOOKS)


def numbers_of(file):
    """All datasets of numbers but those of looks."""
    found = {}
    file.visititems(lambda name, item: found.update({name: item[()]}) if isinstance(item, h5py.Dataset) and item.dtype.kind in "fiu"
                    and not name.startswith(("bodies/", "deck/", "provenance")) else None)
    return found


class Looks(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("pyramid.stl", PYRAMID)
        self.write("drawn.toml", DRAWN)

    def run_deck(self, name="drawn"):
        self.gxrod("run", f"{name}.toml", "--quiet", "--force", "--threads", "1")
        return self.folder / f"{name}.vtkhdf"

    def corners_in(self, file, frame):
        """Those of the bell in a frame, by its axes there: [P,3]."""
        group, vtk = file["bodies"], file["VTKHDF"]
        count = int(vtk["NumberOfPoints"][0])
        node = group["point"][0]
        local = np.array([[x, y, -0.3 + z] for z in (-0.2, 0.2) for y in (-0.05, 0.05) for x in (-0.1, 0.1)])
        # Corners of the file in mm are turned by half a turn about z; lines go from the centre of mass to both joints.
        local = np.vstack([local, [[0, 0, 0], [0, -0.04, 0], [-0.03, 0, 0], [0, 0, 0.05]]])
        turn = np.array([[np.cos(0.4), 0, np.sin(0.4)], [0, 1, 0], [-np.sin(0.4), 0, np.cos(0.4)]])
        axes = np.array([vtk[f"PointData/axis_{axis}"][frame * count + node] for axis in "xyz"]).T
        np.testing.assert_allclose(np.array([vtk[f"PointData/axis_{axis}"][node] for axis in "xyz"]).T, turn, atol=1e-12)
        return vtk["Points"][frame * count + node] + local @ axes.T

    def test_no_number_of_the_mechanics_changes(self):
        self.write("plain.toml", PLAIN)
        with h5py.File(self.run_deck("plain")) as plain, h5py.File(self.run_deck()) as drawn:
            before, after = numbers_of(plain), numbers_of(drawn)
            self.assertEqual(set(before), set(after))
            for name, values in before.items():
                if "wall" not in name and "restart" not in name:
                    np.testing.assert_array_equal(after[name], values, err_msg=name)
            self.assertEqual(plain["bodies/given"][()].tolist(), [0, 0])
            self.assertEqual(drawn["bodies/given"][()].tolist(), [1, 0])

    def test_outlines_move_with_their_bodies(self):
        path = self.run_deck()
        results = open_results(path)
        outline = results.outlines["bell"]
        self.assertEqual((outline.name, outline.is_given, outline.triangles.shape), ("bell", True, (16, 3)))
        with h5py.File(path) as file:
            for frame in (0, 3, len(results.frames) - 1):
                corners = self.corners_in(file, frame)
                own = outline.in_frame(results.frames[frame])
                # Corners of the file are in the order in which its reader has them.
                self.assertLess(max(np.abs(own[:12] - corner).max(axis=1).min() for corner in corners), 1e-12)
                np.testing.assert_allclose(own[:8], corners[:8], atol=1e-12)
        self.assertFalse(results.outlines["clapper"].is_given)

    def test_check_prints_their_sizes(self):
        done = self.gxrod("check", "drawn.toml")
        self.assertIn("looks of body bell: 0.2 × 0.1 × 0.55 along its axes, 16 triangles\n", done.stdout)
        self.assertNotIn("looks of body clapper", done.stdout)

    def test_export_writes_them_for_paraview(self):
        path = self.run_deck()
        done = self.gxrod("export", "drawn.vtkhdf", "--series", "frames", "--bodies")
        self.assertEqual(done.stdout, "frames/drawn.hdf.series\nframes/bodies.vtkhdf\n")
        results = open_results(path)
        with h5py.File(self.folder / "frames" / "bodies.vtkhdf") as file:
            vtk = file["VTKHDF"]
            np.testing.assert_array_equal(vtk["Steps/Values"][()], results.frames.time)
            self.assertEqual(vtk["Steps"].attrs["NSteps"], len(results.frames))
            count = int(vtk["NumberOfPoints"][0])
            for number, frame in enumerate(results.frames):
                first = vtk["Steps/PointOffsets"][number]
                expected = np.concatenate([outline.in_frame(frame) for outline in results.outlines.values()])
                np.testing.assert_allclose(vtk["Points"][first : first + count], expected, atol=1e-6)
            types, bodies = vtk["Types"][()], vtk["CellData/body"][()]
            self.assertEqual((types.dtype, len(types), vtk["Offsets"][-1]), (np.uint8, vtk["NumberOfCells"][0], len(vtk["Connectivity"])))
            self.assertEqual(np.sum((types == 5) & (bodies == 0)), 16)
        self.assertIn("has no outlines", self.export_without_bodies())

    def export_without_bodies(self):
        with h5py.File(self.folder / "drawn.vtkhdf", "r+") as file:
            del file["bodies"]
        return self.gxrod("export", "drawn.vtkhdf", "--series", "frames", "--bodies", "--force", code=4).stderr

    def test_reports_have_them_and_all_stages(self):
        self.run_deck()
        self.gxrod("report", "drawn.vtkhdf")
        page = (self.folder / "drawn.html").read_text(encoding="utf-8")
        info = json.loads(re.search(r'<script type="application/json" id="report">(.*?)</script>', page, re.DOTALL).group(1))
        read = lambda name, kind: np.frombuffer(base64.b64decode(re.search(rf'id="data-{name}">([^<]*)<', page).group(1)), kind)
        bell, clapper = info["bodies"]
        self.assertNotIn("outline", clapper)
        (first, points), (start, triangles), (_, lines) = bell["outline"]
        self.assertEqual((first, start, triangles), (0, 0, 16))
        corners = read("outline-points", "f4").reshape(-1, 3)
        self.assertEqual(len(corners), points)
        np.testing.assert_allclose(corners[0], [-0.1, -0.05, -0.5], rtol=1e-6)
        self.assertEqual(len(read("outline-triangles", "i4")), 3 * triangles)
        self.assertEqual(len(read("outline-lines", "i4")), 2 * lines)
        self.assertAlmostEqual(bell["reach"], np.linalg.norm(corners, axis=1).max(), places=6)
        stages = next(table for table in info["tables"] if table["title"] == "Stages")
        rows = [dict(zip(stages["columns"], row)) for row in stages["rows"]]
        self.assertEqual([row[""] for row in rows], ["swing", "go_on"])
        self.assertEqual([row["end time"] for row in rows], [0.3, 0.2])
        self.assertEqual(rows[1]["integrator"], "radau-5")

    def test_pictures_show_their_edges(self):
        from gxrod.plot import results, shapes

        scene = results.read_results(self.run_deck(), lambda found: shapes.make_scene(found, shapes.choose_frames(found)))
        self.assertEqual(len(scene.outlines), 1)  # of bodies on joints those with looks, in the last frame
        edges, time = scene.outlines[-1]
        self.assertEqual(edges.shape[1:], (2, 3))
        self.assertAlmostEqual(time, 0.5)
        free = PLAIN[: PLAIN.index("[body.clapper]")] + PLAIN[PLAIN.index("[[stage]]") : PLAIN.index("[[history]]")]
        self.write("free.toml", free.replace("#bell\n", "velocity = [9, 0, 0]\n" + LOOKS))
        scene = results.read_results(self.run_deck("free"), lambda found: shapes.make_scene(found, shapes.choose_frames(found)))
        self.assertGreater(len(scene.outlines), 5)
        self.gxrod("drawn.vtkhdf", "-o", "bell.png", program=GXROD_PLOT)

    def test_wrong_looks_are_told_once(self):
        for wrong, message in (('mesh = { file = "absent.stl" }', "looks[0].mesh.file: "), ("box = { size = [1, 0, 1] }", "expected three edges greater than 0"),
                               ("box = { size = [1, 1, 1] }, arms = 0", "only one of"), ("", "missing; expected box = { … } or"), ('file = "pyramid.stl"', 'did you mean "mesh"?')):
            self.write("wrong.toml", PLAIN.replace("#bell", f"looks = [{{ {wrong} }}]"))
            done = self.gxrod("check", "wrong.toml", code=2)
            with self.subTest(wrong):
                lines = [line for line in done.stderr.splitlines() if "wrong.toml:" in line]
                self.assertEqual(len(lines), 1, done.stderr)
                self.assertIn(message, lines[0])


if __name__ == "__main__":
    unittest.main()
