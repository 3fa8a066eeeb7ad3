"""What MkDocs does besides for this site: mkdocs.yml names this file.

The pages are written for a plain forge, where a link may lead to any file of the project. The site has docs/ and the
changelog: a link to another file becomes its path in the project.
"""

import os
import pathlib
import re

from mkdocs.structure.files import File

PROJECT = pathlib.Path(__file__).resolve().parents[2]
DOCS = PROJECT / "docs"
CHANGELOG = "CHANGELOG.md"
# What stands beside other pages; wide tables need the room.
HIDDEN = {"README.md": ["navigation", "toc"], "deck.md": ["navigation"], "plan.md": ["navigation"]}
CODE_OR_LINK = re.compile(r"^```.*?^```$|\[([^\]\[]+)\]\(([^)\s#]+)(#[^)\s]*)?\)", re.MULTILINE | re.DOTALL)


def pages_of(entries):
    """The names of all pages below an entry of the navigation."""
    if isinstance(entries, str):
        return {entries}
    values = entries.values() if isinstance(entries, dict) else entries
    return set().union(*map(pages_of, values))


def expand(entries, named):
    """The navigation, with FOLDER/* as the pages of that folder which it does not name."""
    if isinstance(entries, dict):
        return {title: expand(below, named) for title, below in entries.items()}
    if isinstance(entries, str):
        return entries
    found = []
    for entry in entries:
        if isinstance(entry, str) and entry.endswith("/*"):
            folder = DOCS / entry[:-2]
            pages = [page.relative_to(DOCS).as_posix() for page in (*folder.glob("*.md"), *folder.glob("*/README.md"))]
            found += sorted(set(pages) - named)
        else:
            found.append(expand(entry, named))
    return found


def on_config(config):
    config["nav"] = expand(config["nav"], pages_of(config["nav"]))
    return config


def on_files(files, config):
    for file in list(files):
        if "__pycache__" in file.src_path or file.src_path.startswith("site/") and file.src_path.endswith(".py"):
            files.remove(file)
    files.append(File(CHANGELOG, str(PROJECT), config["site_dir"], config["use_directory_urls"]))
    return files


def in_site(link, page):
    """A link of a page, as the site has it."""
    text, target, anchor = link.groups()
    if target is None or "://" in target:  # code, or the network
        return link.group()
    here = PROJECT / CHANGELOG if page == CHANGELOG else DOCS / page
    path = pathlib.Path(os.path.normpath(here.parent / target))
    if path.is_relative_to(DOCS) and not path.is_dir():
        name = path.relative_to(DOCS)
    elif path == PROJECT / CHANGELOG:
        name = CHANGELOG
    elif path.exists():
        name = path.relative_to(PROJECT).as_posix()
        return f"`{name}`" if text.strip("`").split(".")[0] == path.stem else f'<span title="{name}">{text}</span>'
    else:
        return link.group()  # MkDocs reports it
    return f"[{text}]({os.path.relpath(DOCS / name, (DOCS / page).parent)}{anchor or ''})"


def on_page_markdown(markdown, page, **_):
    name = page.file.src_path
    if name in HIDDEN:
        page.meta["hide"] = HIDDEN[name]
    return CODE_OR_LINK.sub(lambda link: in_site(link, name), markdown)
