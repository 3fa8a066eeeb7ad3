"""The gallery of the examples: a picture, the name and a line for each."""

import re

from .cases import EXAMPLES, KINDS, figure_of
from .figures import SKETCH

OTHERS = "Others"  # what `gxrod verify` has no case for
SCRIPTS = "From Python"  # those in a folder of their own


def read_page(name):
    """Title and first paragraph, without links, of the page of an example."""
    title, paragraph = (EXAMPLES / name / "README.md").read_text(encoding="utf-8").split("\n\n")[:2]
    return title.removeprefix("# "), re.sub(r"\[([^\]]+)\]\([^)]+\)", r"\1", paragraph.replace("\n", " "))


def make_entry(name, case):
    title, sentence = read_page(name)
    if case:
        picture, sentence = f"../verification/figures/{figure_of(name, SKETCH).name}", f"{case['sentence']}."
    else:
        picture = f"{name}/{name.split('/')[-1]}.png"
    page = f"{name}/README.md"
    return f"- [![{title}]({picture})]({page})<br>**[{title}]({page})**<br>{sentence}"


def make_group(title, entries):
    return ["", f"## {title}", "", '<div class="gallery" markdown>', "", *entries, "", "</div>"] if entries else []


def make_gallery(kept):
    """Lines for all folders of examples, grouped by kind."""
    names = sorted(folder.parent.name for folder in EXAMPLES.glob("*/README.md"))
    case_of = {name: kept["cases"].get(name) for name in names}
    scripts = sorted(folder.parent.relative_to(EXAMPLES).as_posix() for folder in EXAMPLES.glob("python/*/README.md"))
    lines = []
    for kind, title in [*KINDS.items(), (None, OTHERS)]:
        lines += make_group(title, [make_entry(name, case) for name, case in case_of.items() if (case and case["kind"]) == kind])
    lines += make_group(SCRIPTS, [make_entry(name, None) for name in scripts])
    return [f"{len(names) + len(scripts)} examples.", *lines, ""]
