"""The page of `gxrod report`, in a notebook or in the browser."""

from __future__ import annotations

import html
import tempfile
import webbrowser
from pathlib import Path

from .program import run_program
from .typed import AnyPath


class Page:
    """One HTML page. A notebook shows it as the last line of a cell; `open()` shows it in the browser, `save(path)` writes it.

    `html`: its text.
    """

    def __init__(self, text: str, height: int = 720) -> None:
        self.html, self.height = text, height
        self._folder: tempfile.TemporaryDirectory[str] | None = None

    def save(self, path: AnyPath) -> None:
        """Writes the page to a file; it needs no other one, and no network."""
        Path(path).write_text(self.html, encoding="utf-8")

    def open(self) -> None:
        """Shows the page in the browser, from a temporary file that is there as long as this object."""
        self._folder = self._folder or tempfile.TemporaryDirectory(prefix="gxrod_")
        path = Path(self._folder.name) / "report.html"
        self.save(path)
        webbrowser.open(path.as_uri())

    def _repr_html_(self) -> str:
        # The page is the document of a frame of its own, so that its styles and scripts do not meet those of the notebook.
        return f'<iframe srcdoc="{html.escape(self.html)}" width="100%" height="{self.height}" style="border:0"></iframe>'

    def __repr__(self):
        return f"a page of {len(self.html) / 1e6:.1f} MB: open() shows it in the browser, save(path) writes it"


def make_page(results: AnyPath, height: int = 720) -> Page:
    """The page of a results file. Needs the program gxrod."""
    with tempfile.TemporaryDirectory(prefix="gxrod_") as folder:
        path = Path(folder) / "report.html"
        run_program(["report", str(results), "-o", str(path)])
        return Page(path.read_text(encoding="utf-8"), height)
