"""Stresses: the largest ones along rods, and those within a section."""

from dataclasses import dataclass

import numpy as np
from matplotlib.tri import Triangulation

from ..errors import Error
from .errors import UsageError
from .shapes import choose_frames
from .style import BLACK, BLUE, BROWN, GREEN, GREY, ORANGE, PURPLE, RED

HEIGHT, SECTION_HEIGHT = 4.2, 6.4
COLOURS = (BLUE, ORANGE, GREEN, PURPLE, BROWN, BLACK)
TITLES = {"von_mises": "von Mises stress", "exposure": "exposure"}
STRESS = "force/length²"
CRITERIA = {"von-mises": "von Mises", "tsai-wu": "Tsai–Wu", "hashin": "Hashin", "max-stress": "the largest stress"}


@dataclass
class SectionPlace:
    """What is drawn of a section: its stresses, and where they come from in words."""

    section: object  # gxrod.results.stresses.ResultSection
    resultants: np.ndarray
    words: str


def choose_rods(results, wanted):
    there = list(results.results.rods)
    for name in wanted or ():
        if name not in there:
            raise UsageError(f"there is no rod {name!r}; the file has {', '.join(there)}")
    return wanted or there


def read_envelopes(results, request):
    """Of the chosen rods that have stresses, the one with the largest first."""
    measure = request.measure.replace("-", "_")
    envelopes = [read(results, lambda name=name: results.results.envelope(name)) for name in choose_rods(results, request.rod)]
    largest = lambda envelope: getattr(envelope, measure).value
    envelopes = [envelope for envelope in envelopes if np.isfinite(largest(envelope)).any()]
    if not envelopes:
        raise UsageError("these rods have no stresses: their sections have no shape, or follow a law")
    return sorted(envelopes, key=lambda envelope: -np.nanmax(largest(envelope)))


def read(results, function):
    """What the file lacks is a fault of the request."""
    try:
        return function()
    except UsageError:
        raise
    except (Error, ValueError) as error:
        raise UsageError(str(error)) from error


def draw_envelopes(figure, results, envelopes, measure):
    """The largest value of all steps over the arc length; of many rods those with the largest ones in colour."""
    axes = figure.subplots()
    unit = results.unit_of(STRESS) if measure == "von_mises" else ""
    for number, envelope in reversed(list(enumerate(envelopes))):
        has_colour = number < len(COLOURS)
        values = getattr(envelope, measure).value
        axes.plot(envelope.arc_length, values, color=COLOURS[number] if has_colour else GREY,
                  linewidth=1.5 if has_colour else 0.6, alpha=1.0 if has_colour else 0.6, label=envelope.rod if has_colour else None)
    mark_worst(axes, results, envelopes[0], measure)
    if measure == "exposure":
        axes.axhline(1.0, color=RED, linewidth=1.1, linestyle=(0, (5, 3)))
    axes.set_ylim(bottom=0.0)
    axes.margins(x=0.02)
    axes.set_title(f"Largest {TITLES[measure]} of all steps" + (f", by {CRITERIA.get(envelopes[0].criterion, envelopes[0].criterion)}" if measure == "exposure" else ""))
    axes.set_ylabel(", ".join(filter(None, (TITLES[measure], unit))))
    axes.set_xlabel(f"arc length, {results.unit_of('length')}" if results.unit_of("length") != "length" else "arc length")
    others = len(envelopes) - len(COLOURS)
    handles, labels = axes.get_legend_handles_labels()
    if len(envelopes) > 1:
        axes.legend(handles[::-1], labels[::-1], loc="upper left", bbox_to_anchor=(1.0, 1.0), title=f"grey: {others} more" if others > 0 else None)


def mark_worst(axes, results, envelope, measure):
    worst = envelope.worst(measure)
    place = (worst["arc_length"], worst["value"])
    axes.plot(*place, "o", color=RED, markersize=6, zorder=5)
    y, z = worst["point"]
    clock = results.time_label if results.is_static else "t"
    text = f"{envelope.rod}: {worst['value']:.4g} at s = {worst['arc_length']:.4g}, {clock} = {worst['time']:.4g}, (y, z) = ({y:.3g}, {z:.3g})"
    axes.set_title(text, loc="right", fontsize=8, fontweight="normal", color=RED)


def choose_section(results, request):
    """At the place and time of the request, else where the largest stress of all steps is."""
    opened = results.results
    measure = request.measure.replace("-", "_")
    clock = results.time_label if results.is_static else "t"
    if request.at is None:
        [envelope, *_] = read_envelopes(results, request)
        worst = envelope.worst(measure)
        section = opened.sections[list(opened.sections)[worst["section"]]]
        words = f"{envelope.rod}, s = {worst['arc_length']:.4g}, {clock} = {worst['time']:.4g}: the largest {TITLES[measure]} of all steps"
        return SectionPlace(section, worst["resultants"], words)
    if len(request.rod or []) != 1:
        raise UsageError("--at needs one --rod")
    [name] = choose_rods(results, request.rod)
    time = results.frame_times[choose_frames(results, request.times, 1)[0]] if request.times else None
    stress = read(results, lambda: opened.stress(name, request.at, time))
    return SectionPlace(stress.section, stress.resultants, f"{name}, s = {stress.s:.4g}, {clock} = {stress.time:.4g}")


def triangles(cells):
    """Corners [t,3] of cells of three or four corners, the last of which may be twice there."""
    halves = [cells[:, [0, 1, 2]]] + ([cells[:, [0, 2, 3]]] if cells.shape[1] == 4 else [])
    corners = np.concatenate(halves)
    return corners[(corners[:, 0] != corners[:, 2]) & (corners[:, 1] != corners[:, 2])]


def outline(cells):
    """Edges [e,2] of one cell alone: the outline, and where layers meet."""
    pairs = np.concatenate([np.stack([cells[:, i], np.roll(cells, -1, axis=1)[:, i]], axis=1) for i in range(cells.shape[1])])
    pairs = np.sort(pairs[pairs[:, 0] != pairs[:, 1]], axis=1)
    edges, counts = np.unique(pairs, axis=0, return_counts=True)
    return edges[counts == 1]


def draw_section(figure, results, place):
    """Cells coloured by von Mises' stress, as seen against x, with the largest value."""
    from ..results.stresses import RESULTANTS, von_mises

    axes = figure.subplots()
    section = place.section
    values = von_mises(section.stress(place.resultants))
    allowed = np.where(section.is_singular, -np.inf, values)
    worst = int(allowed.argmax())
    y, z = section.points.T
    colours = axes.tripcolor(Triangulation(y, z, triangles(section.cell_points)), values, shading="gouraud", cmap="viridis", vmin=0.0,
                             vmax=max(values[worst], np.finfo(float).tiny))
    axes.plot(*(section.points[outline(section.cell_points)].transpose(2, 1, 0)), color=BLACK, linewidth=0.7)
    axes.plot(y[worst], z[worst], "o", color=RED, markerfacecolor="none", markersize=9, markeredgewidth=1.8)
    axes.plot(0.0, 0.0, "+", color=RED, markersize=10)
    unit = results.unit_of(STRESS)
    length = results.unit_of("length")
    figure.colorbar(colours, ax=axes, label=f"von Mises stress, {unit}", shrink=0.85, panchor=(0.5, 0.5))
    figure.suptitle(f"{section.name} ({section.source})\n{place.words}", x=0.02, ha="left", fontsize=9.5, fontweight="bold")
    forces = ", ".join(f"{name} {value:.4g}" for name, value in zip(RESULTANTS, place.resultants))
    layer = f", {section.layers[section.point_layer[worst]]}" if len(section.layers) > 1 else ""
    axes.set_xlabel(f"y, {length}")
    figure.supxlabel(f"○ {values[worst]:.4g} {unit} at ({y[worst]:.4g}, {z[worst]:.4g}){layer}\n{forces}", fontsize=9)
    axes.set_ylabel(f"z, {length}")
    axes.set_aspect("equal")
    axes.locator_params(axis="x", nbins=3 if np.ptp(y) < 0.7 * np.ptp(z) else 6)
    axes.grid(False)
