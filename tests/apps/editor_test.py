"""What taplo, which VS Code's Even Better TOML runs, underlines in decks by `gxrod schema`."""

import shutil
import subprocess
import unittest

from program import SOURCE, ProgramTest

TAPLO = shutil.which("taplo")


@unittest.skipIf(TAPLO is None, "needs taplo: python3 -m pip install taplo")
class Editor(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("gxrod.schema.json", self.gxrod("schema").stdout)

    def lint(self, *decks):
        schema = (self.folder / "gxrod.schema.json").as_uri()
        return subprocess.run([TAPLO, "lint", "--schema", schema, *map(str, decks)], cwd=self.folder, text=True, capture_output=True)

    def test_every_example_is_valid(self):
        examples = SOURCE / "docs" / "examples"
        decks = [deck for deck in examples.glob("*/*.toml") if deck.stem == deck.parent.name and "\n[vary]" not in deck.read_text()]
        self.assertGreater(len(decks), 90)
        done = self.lint(*decks, *(SOURCE / "apps" / "gxrod" / "decks").glob("*.toml"))
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_wrong_key_and_a_wrong_word_are_underlined(self):
        self.gxrod("init", "riser")
        text = (self.folder / "riser.toml").read_text()
        self.write("wrong.toml", "#:schema ./gxrod.schema.json\n" + text.replace("outer_radius", "outer_radus").replace('"static"', '"statics"'))
        done = subprocess.run([TAPLO, "lint", "wrong.toml"], cwd=self.folder, text=True, capture_output=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("'outer_radus' was unexpected", done.stderr)
        self.assertIn('"statics" is not one of', done.stderr)


if __name__ == "__main__":
    unittest.main()
