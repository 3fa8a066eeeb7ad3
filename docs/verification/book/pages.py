"""Renews the generated blocks of pages; what is written by hand around them stays."""

import re

from .cases import EXAMPLES, PAGES
from .gallery import make_gallery
from .index import make_index
from .tables import make_results, make_runs

BLOCK = re.compile(r"(<!-- (results|runs|index|gallery) -->\n)(.*?)(<!-- end -->)", re.DOTALL)
OTHER_PAGES = {"index": PAGES / "README.md", "gallery": EXAMPLES / "README.md"}


class PageFault(Exception):
    """A page that is not as it must be."""


def page_of(name):
    return OTHER_PAGES.get(name, PAGES / f"{name}.md")


def renew_text(text, blocks):
    """The text with each marked block made anew; each must be there once."""
    found = [match[2] for match in BLOCK.finditer(text)]
    if sorted(found) != sorted(blocks):
        raise PageFault(f"has the blocks {found}, not {sorted(blocks)}")
    return BLOCK.sub(lambda match: match[1] + "\n".join(blocks[match[2]]) + "\n" + match[4], text)


def blocks_of(name, kept):
    """{block: lines} of a page: of a case, or of those that show all cases."""
    if name == "index":
        return {"index": make_index(kept)}
    if name == "gallery":
        return {"gallery": make_gallery(kept)}
    case = kept["cases"][name]
    return {"results": make_results(case), "runs": make_runs(name, case)}


def renewed_pages(kept):
    """(page, its text, the text as it should be) of each page; the latter is the fault where there is one."""
    for name in [*OTHER_PAGES, *kept["cases"]]:
        page = page_of(name)
        text = page.read_text(encoding="utf-8") if page.exists() else None
        if text is None:
            yield page, None, PageFault("is missing")
            continue
        try:
            yield page, text, renew_text(text, blocks_of(name, kept))
        except PageFault as fault:
            yield page, text, fault


def write_pages(kept):
    """Renews all pages that are there; returns the faults."""
    faults = []
    for page, text, renewed in renewed_pages(kept):
        if isinstance(renewed, PageFault):
            faults.append(f"{page.name} {renewed}")
        elif renewed != text:
            page.write_text(renewed, encoding="utf-8")
    return faults
