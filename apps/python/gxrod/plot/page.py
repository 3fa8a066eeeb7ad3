"""Puts shapes, histories and the ledger together into one figure."""

import textwrap
from dataclasses import dataclass

from .errors import FileFault
from .found import draw_found, section_height
from .histories import draw_histories, history_panels, row_count
from .ledger import draw_ledger, panel_count
from .path import draw_paths, path_curves
from .path import section_height as path_section_height
from .ranges import HEIGHT as RANGE_HEIGHT
from .ranges import draw_ranges, read_ranges
from .response import HEIGHT, draw_response
from .results import choose_histories
from .shapes import choose_frames, draw_shapes, fitting_size, prepare_shapes
from .stresses import HEIGHT as STRESS_HEIGHT
from .stresses import SECTION_HEIGHT, choose_section, draw_envelopes, draw_section, read_envelopes
from .style import BLACK, new_figure
from .sweep import HEIGHT as SWEEP_HEIGHT
from .sweep import draw_sweep

WIDTH = 12.5
NARROW_WIDTH = 8.4  # of a figure of shapes or the ledger only
SHAPES_HEIGHT = 7.6
PANEL_HEIGHT = 2.3
TITLE_HEIGHT, FACTS_HEIGHT, HEADING_MARGIN = 0.27, 0.19, 0.14  # of a line each
TITLE_LETTER, FACTS_LETTER = 0.125, 0.073  # width, inches
FLAT = 0.5  # scenes below this part of the height of an overview have a section of their own
LONGEST_REASON = 90  # characters; the whole one is in the file


def draw_page(results, request):
    """The figure that the command line requests."""
    file = request.results[0]
    if len(results.times) == 0:
        raise FileFault(f"{file}: holds no complete step yet")
    panels = history_panels(choose_histories(results, request.history))
    if request.what == "histories":
        if not panels:
            raise FileFault(f"{file}: has no histories")
        return draw_sections(results, request, [histories_section(results, panels)])
    if request.what == "ledger":
        section = (panel_count(results) * PANEL_HEIGHT, lambda figure: draw_ledger(figure, results))
        return draw_sections(results, request, [section], NARROW_WIDTH)
    if request.what in ("stress", "section"):
        if not results.results.sections:
            raise FileFault(f"{file}: has no stresses; stresses = \"von-mises\" in [output] of the deck writes them")
        return draw_sections(results, request, [stress_section(results, request)], NARROW_WIDTH)
    if request.what == "range":
        rows = read_ranges(results, request)
        width = NARROW_WIDTH if len(rows) == 1 else WIDTH
        return draw_sections(results, request, [(RANGE_HEIGHT * len(rows[0]), lambda figure: draw_ranges(figure, results, rows))], width)
    found = [found_section(results, request, each) for each in results.found()] if request.what in ("all", "found") else []
    if request.what in ("all", "found"):
        found += [response_section(each) for each in results.responses()]
        found += [sweep_section(each) for each in results.sweeps()]
    if request.what == "found" and not found:
        raise FileFault(f"{file}: has nothing found; stages of kind modes, eigenvalues, buckling or response find it")
    if found and (request.what == "found" or len(results.times) == 1):
        return draw_sections(results, request, found)
    if len(results.frame_times) == 0:
        raise FileFault(f"{file}: holds no complete frame yet")
    shapes = prepare_shapes(results, choose_frames(results, request.times, request.frames), request.view)
    if request.what == "shapes":
        width, height = fitting_size(shapes, NARROW_WIDTH, SHAPES_HEIGHT)
        return draw_sections(results, request, [(height, lambda figure: draw_shapes(figure, results, shapes))], width)
    sections = overview_sections(results, shapes)
    if panels:
        sections.append(histories_section(results, panels))
    return draw_sections(results, request, sections + found)


def found_section(results, request, found):
    return section_height(found), lambda figure: draw_found(figure, results, found, request.view)


def stress_section(results, request):
    if request.what == "section":
        place = choose_section(results, request)
        return SECTION_HEIGHT, lambda figure: draw_section(figure, results, place)
    envelopes = read_envelopes(results, request)
    return STRESS_HEIGHT, lambda figure: draw_envelopes(figure, results, envelopes, request.measure.replace("-", "_"))


def response_section(response):
    return HEIGHT, lambda figure: draw_response(figure, response)


def sweep_section(sweep):
    return SWEEP_HEIGHT, lambda figure: draw_sweep(figure, sweep)


def histories_section(results, panels):
    stages = results.paths()
    curves = path_curves(panels) if stages else []
    if curves:
        return path_section_height(stages, curves), lambda figure: draw_paths(figure, stages, curves)
    return row_count(panels) * PANEL_HEIGHT, lambda figure: draw_histories(figure, results, panels)


def overview_sections(results, shapes):
    """Shapes and ledger: side by side, or below each other where the shapes are flat."""
    width, height = fitting_size(shapes, 0.62 * WIDTH, SHAPES_HEIGHT)
    if height < FLAT * SHAPES_HEIGHT:
        _, height = fitting_size(shapes, WIDTH, SHAPES_HEIGHT)
        rows = -(-panel_count(results) // 2)
        return [(height, lambda figure: draw_shapes(figure, results, shapes)),
                (rows * PANEL_HEIGHT, lambda figure: draw_ledger(figure, results, columns=2))]

    def draw(figure):
        left, right = figure.subfigures(1, 2, width_ratios=(width, WIDTH - width))
        draw_shapes(left, results, shapes)
        draw_ledger(right, results)
    return [(SHAPES_HEIGHT, draw)]


def draw_sections(results, request, sections, width=WIDTH):
    """One section (height, drawer) below the other, under a heading."""
    heights = [height for height, _ in sections]
    if request.size:
        width = request.size[0]
    heading = [] if request.no_title else heading_lines(results, request, width)
    heading_height = HEADING_MARGIN + sum(line.height for line in heading) if heading else 0.0
    figure = new_figure(*(request.size or (width, heading_height + sum(heights))))
    if request.size:
        # Sections get what the heading leaves of the requested height.
        left = max(request.size[1] - heading_height, 0.3 * request.size[1])
        heights = [height * left / sum(heights) for height in heights]
    if heading:
        heights = [heading_height, *heights]
    parts = list(figure.subfigures(len(heights), 1, height_ratios=heights, squeeze=False).flat)
    if heading:
        draw_heading(parts.pop(0), heading, heading_height)
    for part, (_, draw) in zip(parts, sections):
        draw(part)
    return figure


@dataclass
class Line:
    """One line of the heading."""

    text: str
    height: float
    style: dict


def heading_lines(results, request, width):
    """The title and facts of the run, or the user's title, in as many lines as they need."""
    title = {"fontsize": 14, "fontweight": "bold", "color": BLACK}
    lines = [Line(text, TITLE_HEIGHT, title)
             for text in textwrap.wrap(request.title or results.title, max(int(width / TITLE_LETTER), 10))]
    if not request.title:
        lines += [Line(text, FACTS_HEIGHT, {"fontsize": 9, "color": "#5b616b"})
                  for text in textwrap.wrap(" · ".join(facts(results)), max(int(width / FACTS_LETTER), 20))]
    return lines


def draw_heading(figure, lines, height):
    top = height - 0.5 * HEADING_MARGIN
    for line in lines:
        figure.text(0.012, (top - 0.5 * line.height) / height, line.text, va="center", **line.style)
        top -= line.height


def facts(results):
    status = results.status
    if results.reason and status != "complete":
        status += f" ({textwrap.shorten(results.reason, LONGEST_REASON, placeholder=' …')})"
    steps = max(len(results.times) - 1, 0)
    clock = results.time_label if results.is_static else "t"
    if steps == 0:
        return [results.deck, status, *([f"units {results.units}"] if results.units else []), f"gxrod {results.version}"]
    found = [results.deck, f"{steps} steps to {clock} = {results.times[-1]:g}", status]
    if results.units:
        found.append(f"units {results.units}")
    return found + [f"gxrod {results.version}"]
