"""Decks with meshes: what a user sees of Gmsh, and what the results keep."""

import shutil
import unittest

import h5py

from program import SOURCE, ProgramTest

DECK = """[section.wire]
shape = { circle = { radius = 5e-3 } }
material = { E = 2.1e11, nu = 0.3, density = 7850 }
[rod.truss]
section = "wire"
mesh = { file = "truss.geo", group = "truss" }
[[support]]
at = "truss.left_foot"
fix = "all"
[analysis]
kind = "dynamic"
end_time = 1e-3
steps = 2
"""


class Mesh(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "decks").mkdir()
        shutil.copy(SOURCE / "meshes" / "truss.geo", self.folder / "decks")
        self.write("decks/truss.toml", DECK)

    def test_is_found_next_to_its_deck_and_kept_with_the_results(self):
        done = self.gxrod("run", "decks/truss.toml")
        self.assertNotIn("Info", done.stdout + done.stderr)
        with h5py.File(self.folder / "truss.vtkhdf") as file:
            self.assertEqual(bytes(file["deck/meshes/truss.geo"][:]), (SOURCE / "meshes" / "truss.geo").read_bytes())
            self.assertEqual(file["VTKHDF/NumberOfPoints"][0], 11)

    def test_check_says_what_the_mesh_became(self):
        done = self.gxrod("check", "decks/truss.toml")
        self.assertIn("rod truss: length 6.21421, mass 3.8313, 12 objective elements of order 1, section wire", done.stdout)
        self.assertIn("support at truss.left_foot: fixes x y z rx ry rz", done.stdout)
        self.assertEqual(done.stderr, "")

    def test_that_is_wrong_is_a_fault_of_the_deck_in_one_line(self):
        (self.folder / "decks" / "truss.geo").write_text("Point(;\n")
        done = self.gxrod("check", "decks/truss.toml", code=2)
        self.assertIn("decks/truss.toml:6:17: rod.truss.mesh.file: decks/truss.geo: Gmsh cannot read it", done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1)

    def test_that_is_missing_is_a_fault_of_the_deck(self):
        (self.folder / "decks" / "truss.geo").unlink()
        done = self.gxrod("run", "decks/truss.toml", code=2)
        self.assertIn("rod.truss.mesh.file: decks/truss.geo: cannot be read (No such file or directory)", done.stderr)


if __name__ == "__main__":
    unittest.main()
