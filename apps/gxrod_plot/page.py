"""Puts shapes, histories and the ledger together into one figure."""

import textwrap

from .errors import FileFault
from .histories import draw_histories, history_panels, row_count
from .ledger import draw_ledger, panel_count
from .results import choose_histories
from .shapes import choose_frames, draw_shapes
from .style import BLACK, new_figure

WIDTH = 12.5
NARROW_WIDTH = 8.4  # of a figure of shapes or the ledger only
SHAPES_HEIGHT = 7.6
PANEL_HEIGHT = 2.3
HEADING_HEIGHT = 0.62
LONGEST_REASON = 90  # characters; the whole one is in the file


def draw_page(results, request):
    """The figure that the command line asks for."""
    if len(results.times) == 0:
        raise FileFault(f"{request.results}: holds no complete step yet")
    panels = history_panels(choose_histories(results, request.history))
    if request.what == "histories":
        if not panels:
            raise FileFault(f"{request.results}: has no histories")
        return draw_sections(results, [(row_count(panels) * PANEL_HEIGHT, histories_drawer(results, panels))])
    if request.what == "ledger":
        section = (panel_count(results) * PANEL_HEIGHT, lambda figure: draw_ledger(figure, results))
        return draw_sections(results, [section], NARROW_WIDTH)
    if len(results.frame_times) == 0:
        raise FileFault(f"{request.results}: holds no complete frame yet")
    frames = choose_frames(results, request.times, request.frames)
    if request.what == "shapes":
        section = (SHAPES_HEIGHT, lambda figure: draw_shapes(figure, results, frames, request.view))
        return draw_sections(results, [section], NARROW_WIDTH)
    sections = [(SHAPES_HEIGHT, lambda figure: draw_overview(figure, results, frames, request.view))]
    if panels:
        sections.append((row_count(panels) * PANEL_HEIGHT, histories_drawer(results, panels)))
    return draw_sections(results, sections)


def histories_drawer(results, panels):
    return lambda figure: draw_histories(figure, results, panels)


def draw_overview(figure, results, frames, view):
    left, right = figure.subfigures(1, 2, width_ratios=(1.65, 1.0))
    draw_shapes(left, results, frames, view)
    draw_ledger(right, results)


def draw_sections(results, sections, width=WIDTH):
    """One section (height, drawer) below the other, under a heading."""
    heights = [height for height, _ in sections]
    figure = new_figure(width, HEADING_HEIGHT + sum(heights))
    parts = figure.subfigures(1 + len(sections), 1, height_ratios=[HEADING_HEIGHT, *heights])
    draw_heading(parts[0], results)
    for part, (_, draw) in zip(parts[1:], sections):
        draw(part)
    return figure


def draw_heading(figure, results):
    figure.text(0.012, 0.72, results.title, fontsize=14, fontweight="bold", color=BLACK, va="center")
    figure.text(0.012, 0.2, " · ".join(facts(results)), fontsize=9, color="#5b616b", va="center")


def facts(results):
    status = results.status
    if results.reason and status != "complete":
        status += f" ({textwrap.shorten(results.reason, LONGEST_REASON, placeholder=' …')})"
    steps = max(len(results.times) - 1, 0)
    clock = "load factor" if results.is_static else "t"
    found = [results.deck, f"{steps} steps to {clock} = {results.times[-1]:g}", status]
    if results.units:
        found.append(f"units {results.units}")
    return found + [f"gxrod {results.version}"]
