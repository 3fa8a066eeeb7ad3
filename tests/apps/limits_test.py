"""docs/guide/limits.md is true: what it says that gxrod does not do is refused, with the message quoted there."""

import re
import shlex
import subprocess
import unittest

from program import GXROD, SOURCE, ProgramTest

PAGE = (SOURCE / "docs" / "guide" / "limits.md").read_text(encoding="utf-8")
NOW = "gxrod takes this now, or says something else of it: bring docs/guide/limits.md up to date"


def blocks():
    """(section, kind, text) of the page's blocks, in their order."""
    section, found = "", []
    for part in re.finditer(r"^## ([^\n]*)$|^```(\w+)\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL):
        if part.group(1):
            section = part.group(1)
        else:
            found.append((section, part.group(2), part.group(3)))
    return found


def claims():
    """(section, what is asked, what gxrod says): a piece of a deck or commands, and the message beneath."""
    found = []
    asked = None
    for section, kind, text in blocks():
        if kind == "text":
            assert asked is not None, f"{section}: a message that answers nothing: {text}"
            found.append((section, *asked, text.strip()))
            asked = None
        elif not text.startswith("title"):
            assert asked is None, f"{section}: no message beneath {asked}"
            asked = (kind, text)
    assert asked is None, f"no message beneath {asked}"
    return found


class Limits(ProgramTest):
    def setUp(self):
        super().setUp()
        self.complete = [text for _, kind, text in blocks() if kind == "toml" and text.startswith("title")]
        self.deck = self.complete[0]
        for deck in self.complete:
            for name in re.findall(r"^title = .*# (\w+\.toml)$", deck, re.MULTILINE):
                self.write(name, deck)

    def ask(self, kind, text):
        """Runs the commands, or checks the deck with a piece of it added; gives what the last one says."""
        if kind == "toml":
            self.write("piece.toml", f"{self.deck}\n{text}")
            return self.run_one(["check", "piece.toml"], is_last=True)
        commands = [shlex.split(line) for line in text.strip().splitlines()]
        for number, (program, *arguments) in enumerate(commands):
            self.assertEqual(program, "gxrod")
            said = self.run_one(arguments, is_last=number + 1 == len(commands))
        return said

    def run_one(self, arguments, is_last):
        done = subprocess.run([GXROD, *arguments], cwd=self.folder, capture_output=True, text=True, check=False)
        if is_last:
            self.assertIn(done.returncode, (2, 4), f"{NOW}: gxrod {' '.join(arguments)}")
        else:
            self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout + done.stderr

    def test_each_is_refused_with_its_message(self):
        self.assertGreater(len(claims()), 18)
        for section, kind, text, message in claims():
            with self.subTest(section=section, asked=text):
                self.assertIn(message, self.ask(kind, text), NOW)

    def test_every_section_is_tried(self):
        by_hand = PAGE.split("## Features and analyses that do not go together")[0]  # tests/matrix/matrix_test.py tries the rest
        sections = re.findall(r"^## (.*)$", by_hand, re.MULTILINE)
        self.assertEqual(sorted(set(sections)), sorted({section for section, *_ in claims()}))

    def test_the_decks_run(self):
        self.assertEqual(len(self.complete), 2)
        for deck in self.complete:
            self.gxrod("run", self.write("whole.toml", deck), "--quiet", "--force")

    def test_it_is_found_from_the_first_page(self):
        self.assertIn("(docs/guide/limits.md)", (SOURCE / "README.md").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
