"""How parts of results look at a prompt and in a notebook: a line, and a small table."""

import html
from collections.abc import Sequence

MOST_ROWS = 30


class Shown:
    """Gives a class texts for prompts and notebooks: `_headline()` and `_rows()`, pairs or longer rows of texts."""

    def _headline(self):
        raise NotImplementedError

    def _rows(self) -> Sequence:
        return []

    def __repr__(self):
        rows = [[str(cell) for cell in row] for row in cut(self._rows())]
        columns = max(map(len, rows), default=0)
        widths = [max((len(row[i]) for row in rows if len(row) > i), default=0) for i in range(columns)]
        lines = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows]
        return "\n  ".join([self._headline(), *lines])

    def _repr_html_(self):
        rows = "".join("<tr>" + "".join(f"<td style='text-align:left'>{html.escape(str(cell))}</td>" for cell in row) + "</tr>"
                       for row in cut(self._rows()))
        return f"<div><b>{html.escape(self._headline())}</b><table>{rows}</table></div>"


def cut(rows):
    rows = list(rows)
    if len(rows) <= MOST_ROWS:
        return rows
    return [*rows[: MOST_ROWS - 1], (f"… and {len(rows) - MOST_ROWS + 1} more",)]


def shape_text(shape):
    return "[" + ", ".join(map(str, shape)) + "]"
