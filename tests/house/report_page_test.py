"""The page that apps/report was bundled into is that of the sources next to it, checked without Node."""

import hashlib
import os
import pathlib
import re
import unittest

FOLDER = pathlib.Path(os.environ["GXROD_SOURCE"]) / "apps" / "report"


def digest_sources(folder):
    """What apps/report/build.js writes into the pages: SHA-256 over name and content of each source."""
    sources = (path.relative_to(folder).as_posix() for path in (folder / "src").rglob("*") if path.is_file())
    names = ["build.js", "package-lock.json", "package.json", *sources]
    digest = hashlib.sha256()
    for name in sorted(names):
        digest.update(f"{name}\n{(folder / name).read_text(encoding='utf-8')}\n".encode())
    return digest.hexdigest()


# Each page and how many libraries are in it.
PAGES = {"page.html": 2, "batch.html": 1, "study.html": 1}


def read_page(name):
    return (FOLDER / "dist" / name).read_text(encoding="utf-8")


class ReportPage(unittest.TestCase):
    def test_is_built_from_these_sources(self):
        self.assertEqual({path.name for path in (FOLDER / "dist").iterdir()}, set(PAGES))
        for name in PAGES:
            stated = re.search(r"sources sha256:([0-9a-f]{64})", read_page(name))
            self.assertEqual(stated.group(1), digest_sources(FOLDER),
                             f"rebuild {name}: cd apps/report && npm ci && npm run build")

    def test_holds_its_data_mark_once_and_the_licences(self):
        for name, libraries in PAGES.items():
            self.assertEqual(read_page(name).count("<!-- data -->"), 1, name)
            self.assertEqual(read_page(name).count("Permission is hereby granted, free of charge"), libraries, name)

    def test_of_charts_alone_carry_nothing_to_draw_in_3d(self):
        self.assertIn("WebGLRenderer", read_page("page.html"))
        self.assertNotIn("WebGLRenderer", read_page("batch.html"))
        self.assertNotIn("WebGLRenderer", read_page("study.html"))

    def test_names_no_registry(self):
        lock = (FOLDER / "package-lock.json").read_text(encoding="utf-8")
        self.assertNotIn('"resolved"', lock)
        self.assertNotIn("://", lock)


if __name__ == "__main__":
    unittest.main()
