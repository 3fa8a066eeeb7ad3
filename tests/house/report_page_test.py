"""The page that apps/report was bundled into is that of the sources beside it, checked without Node."""

import hashlib
import os
import pathlib
import re
import unittest

FOLDER = pathlib.Path(os.environ["GXROD_SOURCE"]) / "apps" / "report"


def digest_sources(folder):
    """What apps/report/build.js writes into the page: SHA-256 over name and content of each source."""
    names = ["build.js", "package-lock.json", "package.json", *(f"src/{path.name}" for path in (folder / "src").iterdir())]
    digest = hashlib.sha256()
    for name in sorted(names):
        digest.update(f"{name}\n{(folder / name).read_text(encoding='utf-8')}\n".encode())
    return digest.hexdigest()


class ReportPage(unittest.TestCase):
    def test_is_built_from_these_sources(self):
        page = (FOLDER / "dist" / "page.html").read_text(encoding="utf-8")
        stated = re.search(r"sources sha256:([0-9a-f]{64})", page)
        self.assertEqual(stated.group(1), digest_sources(FOLDER), "build it anew: cd apps/report && npm ci && npm run build")

    def test_holds_its_data_mark_once_and_the_licences(self):
        page = (FOLDER / "dist" / "page.html").read_text(encoding="utf-8")
        self.assertEqual(page.count("<!-- data -->"), 1)
        self.assertEqual(page.count("Permission is hereby granted, free of charge"), 2)

    def test_names_no_registry(self):
        lock = (FOLDER / "package-lock.json").read_text(encoding="utf-8")
        self.assertNotIn('"resolved"', lock)
        self.assertNotIn("://", lock)


if __name__ == "__main__":
    unittest.main()
