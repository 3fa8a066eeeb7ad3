"""The complete decks of the guide's pages are decks, and their pieces are TOML."""

import re
import tomllib
import unittest

from program import SOURCE, ProgramTest

PAGES = sorted((SOURCE / "docs" / "guide").glob("*.md"))


def toml_blocks(page):
    return re.findall(r"```toml\n(.*?)```", page.read_text(), flags=re.DOTALL)


class Guide(ProgramTest):
    def test_every_piece_is_toml(self):
        for page in PAGES:
            for block in toml_blocks(page):
                with self.subTest(page=page.name, block=block):
                    tomllib.loads(block)

    def test_every_complete_deck_passes_the_check(self):
        complete = [(page, block) for page in PAGES for block in toml_blocks(page) if block.startswith("title")]
        self.assertGreaterEqual(len(complete), 3)
        for number, (page, block) in enumerate(complete):
            with self.subTest(page=page.name, deck=block):
                done = self.gxrod("check", self.write(f"{number}.toml", block))
                self.assertNotIn("warning", done.stdout)


if __name__ == "__main__":
    unittest.main()
