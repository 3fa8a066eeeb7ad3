"""The documentation as a site: MkDocs builds it without a warning, and every link, anchor and picture of it leads somewhere."""

import html.parser
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])


def find_missing():
    """What Debian's package mkdocs-material would bring and is not there."""
    if any(importlib.util.find_spec(name) is None for name in ("mkdocs", "pymdownx")):
        return "MkDocs is not installed"
    from mkdocs.utils import get_theme_names
    return "" if "material" in get_theme_names() else "the theme Material for MkDocs is not installed"


MISSING = find_missing()


class Page(html.parser.HTMLParser):
    """The anchors of a page, its links, and what it loads."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.loaded = set(), set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.anchors.add(found.get("id"))
        target = found.get("href", found.get("src"))
        if target is not None:
            (self.links if tag == "a" else self.loaded).add(target)


def broken_links(pages):
    """'PAGE: TARGET' of each link of {path: page} to a file or an anchor that is not there."""
    broken = []
    for path, page in pages.items():
        for link in page.links | page.loaded:
            target = urllib.parse.urlsplit(link)
            if target.scheme or target.netloc:
                continue
            file = (path.parent / urllib.parse.unquote(target.path)).resolve() if target.path else path
            file = file / "index.html" if file.is_dir() else file
            anchor = urllib.parse.unquote(target.fragment)
            is_there = file.exists() and (not anchor or file not in pages or anchor in pages[file].anchors)
            if not is_there:
                broken.append(f"{path.name}: {link}")
    return broken


class BrokenLinks(unittest.TestCase):
    def test_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder).resolve() / "a.html"
            path.write_text('<h2 id="here"></h2><a href="#here"></a><a href="a.html#there"></a><img src="no.png">'
                            '<a href="https://toml.io"></a>', encoding="utf-8")
            page = Page(path.read_text(encoding="utf-8"))
            self.assertEqual(sorted(broken_links({path: page})), ["a.html: a.html#there", "a.html: no.png"])


@unittest.skipIf(MISSING, f"{MISSING}: apt install mkdocs-material")
class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name).resolve()
        cls.build = subprocess.run([sys.executable, "-B", "-m", "mkdocs", "build", "--strict", "--site-dir", cls.folder],
                                   cwd=SOURCE, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        cls.pages = {path: Page(path.read_text(encoding="utf-8")) for path in cls.folder.rglob("*.html")
                     if path.name != "404.html"}

    def test_builds_without_a_warning(self):
        self.assertEqual(self.build.returncode, 0, self.build.stdout)

    def test_every_page_is_in_the_navigation(self):
        self.assertNotIn("not included in the", self.build.stdout)
        self.assertGreater(len(self.pages), 150)

    def test_links_and_pictures_lead_somewhere(self):
        self.assertEqual(broken_links(self.pages), [])

    def test_needs_no_network(self):
        self.assertEqual({link for page in self.pages.values() for link in page.loaded if "//" in link}, set())


if __name__ == "__main__":
    unittest.main()
