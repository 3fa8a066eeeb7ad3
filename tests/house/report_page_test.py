"""apps/report/build-pages makes whole pages of the sources next to it, and refuses what would not run."""

import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

FOLDER = pathlib.Path(os.environ["GXROD_SOURCE"]) / "apps" / "report"
SCRIPT = re.compile(r"<script>(.*?)</script>", re.DOTALL)
# Each page and how many libraries are in it.
PAGES = {"page": 2, "batch": 1, "study": 1}


def build_pages(folder, output):
    return subprocess.run(["/usr/bin/python3", "-B", folder / "build-pages", output], text=True, capture_output=True, check=False)


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        built = build_pages(FOLDER, cls.folder.name)
        assert built.returncode == 0, built.stderr
        cls.texts = {name: pathlib.Path(cls.folder.name, f"{name}.html").read_text(encoding="utf-8") for name in PAGES}

    def test_hold_their_data_mark_once_and_the_licences(self):
        for name, libraries in PAGES.items():
            self.assertEqual(self.texts[name].count("<!-- data -->"), 1, name)
            self.assertEqual(self.texts[name].count("Permission is hereby granted, free of charge"), libraries, name)

    def test_of_charts_alone_carry_nothing_to_draw_in_3d(self):
        self.assertIn("WebGLRenderer", self.texts["page"])
        self.assertNotIn("WebGLRenderer", self.texts["batch"] + self.texts["study"])

    def test_allow_their_own_scripts_alone(self):
        for name, libraries in PAGES.items():
            scripts = SCRIPT.findall(self.texts[name])
            hashes = [f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'" for script in scripts]
            self.assertEqual(len(scripts), libraries + 1)
            self.assertIn(f"default-src 'none'; script-src {' '.join(hashes)}; style-src", self.texts[name])

    def test_are_in_the_sources_as_they_are(self):
        for name, text in self.texts.items():
            source = pathlib.Path(self.folder.name, f"{name}_template.cpp").read_text(encoding="utf-8")
            self.assertEqual("".join(re.findall(r'R"page\((.*?)\)page"', source, re.DOTALL)), text)

    @unittest.skipUnless(shutil.which("node"), "without Node only the tests in a browser find errors of syntax")
    def test_have_scripts_without_errors_of_syntax(self):
        for name, text in self.texts.items():
            script = pathlib.Path(self.folder.name, f"{name}.js")
            script.write_text(SCRIPT.findall(text)[-1], encoding="utf-8")
            checked = subprocess.run(["node", "--check", script], text=True, capture_output=True, check=False)
            self.assertEqual(checked.returncode, 0, f"{name}: {checked.stderr}")


class Refused(unittest.TestCase):
    def refusal(self, name, text):
        """What build-pages says after a text was added at the start of a script."""
        with tempfile.TemporaryDirectory() as folder:
            changed = pathlib.Path(folder) / "report"
            shutil.copytree(FOLDER, changed, ignore=shutil.ignore_patterns("node_modules"))
            path = changed / "src" / name
            path.write_text(text + path.read_text(encoding="utf-8"), encoding="utf-8")
            built = build_pages(changed, pathlib.Path(folder) / "pages")
            self.assertEqual(built.returncode, 1)
            return built.stderr

    def test_imports_of_what_is_not_exported(self):
        self.assertIn("src/format.js: elements.js has no Nothing", self.refusal("format.js", 'import { Nothing } from "./elements.js";\n'))
        self.assertIn("src/format.js: three has no Nothing; update-libraries.js adds it",
                      self.refusal("format.js", 'import { Nothing } from "three";\n'))
        self.assertIn("src/batch/cases.js: this page has no three", self.refusal("batch/cases.js", 'import { Mesh } from "three";\n'))

    def test_circles(self):
        self.assertIn("import each other: elements.js, deck.js", self.refusal("elements.js", 'import { showDeck } from "./deck.js";\n'))

    def test_what_a_page_cannot_hold(self):
        for text in ('import * as three from "three";\n', "export default 1;\n", 'const mark = "</script>";\n', "const text = `a\n b`;\n"):
            self.assertIn("src/format.js: ", self.refusal("format.js", text))


class Libraries(unittest.TestCase):
    def test_name_no_registry(self):
        lock = (FOLDER / "package-lock.json").read_text(encoding="utf-8")
        self.assertNotIn('"resolved"', lock)
        self.assertNotIn("://", lock)

    def test_are_of_the_versions_that_are_asked_for(self):
        package = (FOLDER / "package.json").read_text(encoding="utf-8")
        for library in ("three", "uplot"):
            version = (FOLDER / "libraries" / f"{library}.txt").read_text(encoding="utf-8").split("\n")[0].split()[1]
            self.assertIn(f'"{library}": "{version}"', package)


if __name__ == "__main__":
    unittest.main()
