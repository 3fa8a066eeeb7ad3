"""gxrod section: constants, stresses and pictures of cross-sections."""

import json
import re
import unittest
from xml.etree import ElementTree

from program import ProgramTest

DECK = """units = "m, N"
[section.post]
shape    = { profile = "IPE 200" }
material = { E = 2.1e11, nu = 0.3, density = 7850, yield_stress = 235e6 }
[section.wire]
shape    = { circle = { radius = 1e-3 } }
material = { E = 2.1e11, nu = 0.3 }
[rod.post]
section  = "post"
line     = { from = [0, 0, 0], to = [2, 0, 0] }
y_axis   = [0, 1, 0]
elements = 4
[[support]]
at  = "post.start"
fix = "all"
[analysis]
kind = "static"
"""


def number_of(text, name):
    return float(re.search(rf"\b{name} ([-+\d.e]+)", text)[1])


class SectionVerb(ProgramTest):
    def test_a_profile_by_name_has_the_printed_constants(self):
        said = self.gxrod("section", "ipe200").stdout
        self.assertIn("shape: IPE 200, ", said)
        for name, value, relative in (("A", 2848.4107, 4e-6), ("Iy", 19431683, 4e-6), ("Iz", 1423683.3, 4e-6), ("It", 68462.0, 1e-4),
                                      ("Iw", 1.274616e10, 1e-4), ("Wy", 194316.8, 1e-5)):
            self.assertAlmostEqual(number_of(said, name) / value, 1, delta=relative, msg=name)

    def test_a_name_that_no_profile_has_is_answered_by_near_ones(self):
        said = self.gxrod("section", "IPE 205", code=2).stderr
        self.assertIn('no file and no profile "IPE 205"; nearest are IPE 200', said)
        self.assertIn("series are", self.gxrod("section", "nothing", code=2).stderr)

    def test_sections_of_a_deck(self):
        self.write("frame.toml", DECK)
        said = self.gxrod("section", "frame.toml").stdout
        self.assertIn("section post:", said)
        self.assertNotIn("section wire:", said)
        self.assertAlmostEqual(number_of(said, "My") / (220638.65e-9 * 235e6), 1, delta=1e-5)
        self.assertIn("section wire:", self.gxrod("section", "frame.toml", "wire").stdout)
        self.assertIn('no section "past"; the deck has post, wire', self.gxrod("section", "frame.toml", "past", code=2).stderr)

    def test_stress_of_resultants_and_its_picture(self):
        done = self.gxrod("section", "IPE 200", "--resultants", "0", "0", "1", "0", "0", "0", "-o", "shear.svg")
        self.assertAlmostEqual(number_of(done.stdout, "at most"), 1.75600e-3, delta=3e-6 * 1.756e-3 * 10)
        picture = (self.folder / "shear.svg").read_text(encoding="utf-8")
        ElementTree.fromstring(picture)
        self.assertIn("von Mises", picture)
        self.assertIn("--force", self.gxrod("section", "IPE 200", "-o", "shear.svg", code=4).stderr)
        self.gxrod("section", "IPE 200", "-o", "shear.svg", "--force")
        self.assertNotIn("von Mises", (self.folder / "shear.svg").read_text(encoding="utf-8"))

    def test_resultants_are_compared_with_strengths_by_each_criterion(self):
        self.write("frame.toml", DECK)
        said = self.gxrod("section", "frame.toml", "--resultants", "0", "0", "0", "0", "8e3", "0", "--csv", "stress.csv").stdout
        found = re.search(r"von Mises: exposure ([\d.e-]+), yield of material at .* in \S+; fails at ([\d.e-]+) times", said)
        self.assertAlmostEqual(float(found[1]), 8e3 / 194.3168e-6 / 235e6, delta=2e-6)
        self.assertAlmostEqual(float(found[2]), 1 / float(found[1]), delta=1e-4)
        rows = (self.folder / "stress.csv").read_text(encoding="utf-8").splitlines()
        self.assertEqual(rows[0], "y,z,layer,material,xx,yy,zz,yz,xz,xy,von_mises,exposure von-mises")
        self.assertAlmostEqual(max(float(row.split(",")[-1]) for row in rows[1:]), float(found[1]), delta=1e-6)
        self.assertIn("--csv: give --resultants", self.gxrod("section", "frame.toml", "--csv", "other.csv", code=2).stderr)
        plies = """[material.ply]
E = [141e9, 9.8e9]
G = 6e9
nu = 0.3
strength = { Xt = 1500e6, Xc = 1200e6, Yt = 40e6, Yc = 200e6, S12 = 70e6, S23 = 50e6 }
[layup.skin]
plies = [["ply", 1e-3, 0]]
"""
        walls = DECK.replace('profile = "IPE 200"', 'walls = { corners = [[-0.01, 0], [0.01, 0]], layup = "skin" }')
        walls = walls.replace("material = { E = 2.1e11, nu = 0.3, density = 7850, yield_stress = 235e6 }\n", "")
        self.write("ply.toml", plies + walls.replace('units = "m, N"\n', ""))
        said = self.gxrod("section", "ply.toml", "--resultants", "10e3", "0", "0", "0", "0", "0").stdout
        self.assertRegex(said, r"Hashin: exposure 0\.3333\d*, fibre tension of ply at .* fails at (2\.9999|3)")
        self.assertIn("Tsai–Wu: exposure", said)
        self.assertIn("maximum stress: exposure 0.3333", said)

    def test_json_and_the_estimate_of_the_error(self):
        self.write("frame.toml", DECK)
        said = json.loads(self.gxrod("section", "frame.toml", "--json", "--resultants", "1", "0", "0", "0", "0", "0").stdout)
        self.assertEqual([one["name"] for one in said], ["post"])
        self.assertAlmostEqual(said[0]["shape"]["area"] / 2848.4107e-6, 1, delta=4e-6)
        self.assertAlmostEqual(said[0]["shape"]["yields_at"]["My"] / (220638.65e-9 * 235e6), 1, delta=1e-5)
        self.assertEqual(len(said[0]["stiffness"]), 6)
        self.assertEqual(said[0]["stress"]["exposures"][0]["criterion"], "von-mises")
        changes = dict(re.findall(r"([EGAIJy-z ]+) ([-+][\d.e-]+)[,]", self.gxrod("section", "frame.toml", "--estimate").stdout))
        self.assertLess(abs(float(changes[" GJ"])), 1e-4)

    def test_check_says_how_far_restrained_warping_reaches(self):
        self.write("frame.toml", DECK)
        said = self.gxrod("check", "frame.toml").stdout
        self.assertRegex(said, r"where the warping of IPE 200 is held, as at a clamp, this reaches 0\.696 along the rod, which is 2 long; "
                               r"held at one end it twists 35 % less")

    def test_check_asks_about_lengths_in_another_unit(self):
        self.write("frame.toml", DECK.replace('profile = "IPE 200"', 'profile = "IPE 200", millimetre = 1'))
        said = self.gxrod("check", "frame.toml").stdout
        self.assertIn("note: frame.toml:3:12: section.post.shape: is 200 across, and rod post is 2 long; are all lengths in one unit?", said)
        self.assertNotIn("thicker than long", said)

    def test_a_mesh_by_itself_is_refused_with_how_a_deck_has_it(self):
        self.write("blade.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n")
        self.assertIn('blade.msh is a mesh without materials; give a deck that has it: [section.NAME] with shape = { mesh = { file = "blade.msh", '
                      'material = … } }', self.gxrod("section", "blade.msh", code=2).stderr)

    def test_a_deck_without_shapes_on_cells_says_so(self):
        self.write("wire.toml", DECK.replace('profile = "IPE 200"', "rectangle = { width_y = 0.1, height_z = 0.2 }"))
        self.assertIn("no section of the deck is cut into cells", self.gxrod("section", "wire.toml", code=2).stderr)


if __name__ == "__main__":
    unittest.main()
