"""The page docs/python.md is what the docstrings say, and has every public name."""

import ast
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])
SCRIPT = pathlib.Path("docs") / "site" / "python_page.py"
PACKAGE = pathlib.Path("apps") / "python" / "gxrod"
PAGE = (SOURCE / "docs" / "python.md").read_text(encoding="utf-8")


def write_page(source):
    return subprocess.run([sys.executable, "-B", source / SCRIPT], capture_output=True, text=True, encoding="utf-8", check=False)


class PythonPage(unittest.TestCase):
    def test_it_is_what_the_docstrings_say(self):
        done = write_page(SOURCE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, PAGE, "Write it again: python3 docs/site/python_page.py > docs/python.md")

    def test_it_has_every_public_name(self):
        sys.path.insert(0, str(SOURCE / PACKAGE.parent))
        import gxrod

        headings = re.findall(r"^### (\w+)$", PAGE, re.MULTILINE)
        self.assertEqual(set(gxrod.__all__) - {"gym"} - set(headings), set())
        self.assertEqual(len(headings), len(set(headings)))

    def test_what_is_returned_is_on_it(self):
        """Classes of the package that public functions return."""
        classes = {node.name for path in (SOURCE / PACKAGE).rglob("*.py") if "plot" not in path.parts for node in ast.parse(path.read_text(encoding="utf-8")).body
                   if isinstance(node, ast.ClassDef)}
        types = re.findall(r"\*\* → (.*)$|^\| `\w+` \| ([^|]*) \|", PAGE, re.MULTILINE)
        returned = {name for each in types for name in re.findall(r"\w+", " ".join(each))}
        self.assertIn("RodPlaces", returned)
        self.assertEqual({name for name in returned & classes if f"### {name}\n" not in PAGE}, set())

    def test_its_links_lead_somewhere(self):
        anchors = {heading.lower() for heading in re.findall(r"^### (\w+)$", PAGE, re.MULTILINE)}
        self.assertEqual(set(re.findall(r"\]\(#([^)]*)\)", PAGE)) - anchors, set())

    def test_a_name_without_a_docstring_is_reported(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder)
            shutil.copytree(SOURCE / PACKAGE, source / PACKAGE)
            (source / SCRIPT.parent).mkdir(parents=True)
            shutil.copy(SOURCE / SCRIPT, source / SCRIPT)
            decks = source / PACKAGE / "decks.py"
            decks.write_text(decks.read_text(encoding="utf-8").replace('        """The deck as it was read."""\n', ""), encoding="utf-8")
            done = write_page(source)
        self.assertEqual((done.returncode, done.stderr), (1, "Deck.text has no docstring\n"))


if __name__ == "__main__":
    unittest.main()
