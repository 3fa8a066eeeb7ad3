"""Every relative link and picture of the documentation leads to a file that is there."""

import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])
LINK = re.compile(r"\]\(([^)\s]+)\)")


def broken_links(page):
    """The link targets of a page that lead nowhere."""
    text = re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)
    targets = [target.split("#")[0] for target in LINK.findall(text) if "://" not in target]
    return [target for target in targets if target and not (page.parent / target).exists()]


class Links(unittest.TestCase):
    def test_lead_somewhere(self):
        pages = [SOURCE / "README.md", SOURCE / "CHANGELOG.md", *(SOURCE / "docs").rglob("*.md")]
        self.assertGreater(len(pages), 10)
        broken = [f"{page.relative_to(SOURCE)}: {target}" for page in pages for target in broken_links(page)]
        self.assertEqual(broken, [])

    def test_every_page_can_be_reached(self):
        found, waiting = set(), [SOURCE / "README.md"]
        while waiting:
            page = waiting.pop().resolve()
            if page not in found and page.suffix == ".md" and page.exists():
                found.add(page)
                targets = (target.split("#")[0] for target in LINK.findall(page.read_text(encoding="utf-8")))
                waiting += [page.parent / target for target in targets if target]
        pages = {page.resolve() for page in (SOURCE / "docs").rglob("*.md")}
        self.assertEqual([], sorted(str(page.relative_to(SOURCE.resolve())) for page in pages - found))

    def test_a_broken_link_is_found(self):
        page = SOURCE / "docs" / "architecture.md"
        self.assertEqual(LINK.findall("see [this](nowhere.md)"), ["nowhere.md"])
        self.assertFalse((page.parent / "nowhere.md").exists())


if __name__ == "__main__":
    unittest.main()
