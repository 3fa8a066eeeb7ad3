"""gxrod obstacle: the size and the defects of a mesh, and its picture."""

import struct
import unittest
from xml.etree import ElementTree

from program import SOURCE, ProgramTest

CORNERS = [(x, y, z) for z in (0, 3) for y in (0, 2) for x in (0, 1)]
# Of a box of 1 × 2 × 3, corners counterclockwise seen from outside.
FACETS = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]

DECK = """[obstacle.box]
mesh = { file = "cut.stl" }
[section.wire]
shape = { circle = { radius = 5e-3 } }
material = { E = 2.1e11, nu = 0.3, density = 7850 }
[rod.wire]
section = "wire"
line = { from = [0, 0, 5], to = [1, 0, 5] }
elements = 4
[[support]]
at = "wire.start"
fix = "all"
[analysis]
kind = "static"
"""


def write_bytes(facets):
    text = b"a box".ljust(80) + struct.pack("<I", len(facets))
    for facet in facets:
        text += struct.pack("<12fH", 0, 0, 0, *(x for corner in facet for x in CORNERS[corner]), 0)
    return text


def write_text(facets, end="endsolid box\n"):
    lines = ["solid box\n"]
    for facet in facets:
        lines.append("facet normal 0 0 0\nouter loop\n")
        lines += [f"vertex {x} {y} {z}\n" for x, y, z in (CORNERS[corner] for corner in facet)]
        lines.append("endloop\nendfacet\n")
    return "".join(lines) + end


class ObstacleVerb(ProgramTest):
    def test_a_whole_box_has_its_size_and_no_defects(self):
        (self.folder / "box.stl").write_bytes(write_bytes(FACETS))
        said = self.gxrod("obstacle", "box.stl", "--strict").stdout
        self.assertIn("box.stl: 12 triangles of 1 part, sides 1 to 3.606\n", said)
        self.assertIn("box: 1 × 2 × 3, from (0, 0, 0) to (1, 2, 3)\n", said)
        self.assertIn("area: 22\n", said)
        self.assertIn("volume: 6\n", said)
        self.assertIn("edges: 12 sharp (turned by more than 0.1 rad); the surface turns by 1.571 rad, 90 degrees, at most\n", said)
        self.assertIn("no defects\n", said)
        said = self.gxrod("obstacle", "box.stl", "--scale", "2", "--feature-angle", "1.6").stdout
        self.assertIn("volume: 48\n", said)
        self.assertIn("edges: 0 sharp", said)

    def test_text_says_the_same_as_bytes(self):
        (self.folder / "box.stl").write_bytes(write_bytes(FACETS))
        bytes_said = self.gxrod("obstacle", "box.stl").stdout
        (self.folder / "box.stl").write_text(write_text(FACETS))
        self.assertEqual(self.gxrod("obstacle", "box.stl").stdout, bytes_said)

    def test_defects_are_named_and_strict_returns_2(self):
        bad = FACETS[:10] + [FACETS[10][::-1], FACETS[0], (0, 1, 1)]
        (self.folder / "bad.stl").write_bytes(write_bytes(bad))
        said = self.gxrod("obstacle", "bad.stl").stdout
        self.assertIn("volume: not closed\n", said)
        self.assertIn("defect: hole of 3 open edges, 8.606 around, about ", said)
        self.assertIn("defect: 1 facet the other way around than most of its part: triangle 11\n", said)
        self.assertIn("defect: 1 repeated facet, left out\n", said)
        self.assertIn("defect: 1 facet without area, left out\n", said)
        self.assertNotIn("no defects", said)
        self.gxrod("obstacle", "bad.stl", "--strict", code=2)

    def test_an_edge_of_three_facets_is_a_defect(self):
        (self.folder / "fin.stl").write_bytes(write_bytes([*FACETS, (0, 1, 7)]))
        self.assertIn("defect: 1 edge with more than two facets\n", self.gxrod("obstacle", "fin.stl").stdout)

    def test_a_text_cut_between_facets_is_found_here_and_by_check(self):
        (self.folder / "cut.stl").write_text(write_text(FACETS[:9], end=""))
        said = self.gxrod("obstacle", "cut.stl").stdout
        self.assertIn("defect: the text has a solid without endsolid: the rest of the file may be lost\n", said)
        self.write("box.toml", DECK)
        self.assertIn("cut.stl has a solid without endsolid: the rest of the file may be lost", self.gxrod("check", "box.toml").stdout)

    def test_a_file_that_is_missing_or_no_mesh_is_an_error_in_one_line(self):
        self.assertEqual(self.gxrod("obstacle", "none.stl", code=4).stderr, "gxrod: none.stl: does not exist\n")
        (self.folder / "box.obj").write_text("v 0 0 0\n")
        self.assertEqual(self.gxrod("obstacle", "box.obj", code=2).stderr, "gxrod: box.obj: has another ending than .stl and .msh\n")
        (self.folder / "cut.stl").write_bytes(write_bytes(FACETS)[:-10])
        self.assertIn("gxrod: cut.stl: is not STL", self.gxrod("obstacle", "cut.stl", code=2).stderr)
        (self.folder / "folder.stl").mkdir()
        self.assertEqual(self.gxrod("obstacle", "folder.stl", code=2).stderr, "gxrod: folder.stl: is a folder, expected a mesh\n")
        self.assertIn("--scale", self.gxrod("obstacle", "none.stl", "--scale", "0", code=2).stderr)

    def test_the_picture_is_svg_and_kept_unless_forced(self):
        (self.folder / "box.stl").write_bytes(write_bytes(FACETS[:-1]))
        said = self.gxrod("obstacle", "box.stl", "-o", "box.svg").stdout
        self.assertTrue(said.endswith("box.svg\n"))
        tree = ElementTree.parse(self.folder / "box.svg").getroot()
        names = [element.tag.split("}")[1] for element in tree.iter()]
        self.assertEqual(names.count("polygon"), 3 * 11)
        self.assertEqual(names.count("polyline"), 3 * 3)
        self.assertIn("exists (--force replaces it)", self.gxrod("obstacle", "box.stl", "-o", "box.svg", code=4).stderr)
        self.gxrod("obstacle", "box.stl", "-o", "box.svg", "--force")

    def test_the_vessel_of_the_example_is_open_at_both_ends(self):
        said = self.gxrod("obstacle", str(SOURCE / "docs/examples/guidewire/meshes/vessel.stl")).stdout
        self.assertIn("2400 triangles of 1 part", said)
        self.assertEqual(said.count("defect: hole"), 2)


if __name__ == "__main__":
    unittest.main()
