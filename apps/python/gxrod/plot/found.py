"""Shapes that stages have found: modes of vibration and of buckling, about the equilibrium."""

import textwrap
from dataclasses import dataclass

import numpy as np
from mpl_toolkits.mplot3d.art3d import Line3DCollection

from .shapes import AZIMUTH, ELEVATION, PLANES, Scene, best_view, limits
from .style import BLUE, GREY

MOST_SHAPES = 12
COLUMNS = 3
PANEL_HEIGHT = 2.0
LABEL_WIDTH = 44  # characters of a panel's title
ROUND_OFF = 1e-9  # of a damping ratio
PALE = "#a9c9e6"


@dataclass
class FoundShapes:
    """What one stage has found."""

    stage: str
    kind: str
    labels: list  # of each shape
    points: np.ndarray  # [N,3] of the equilibrium
    shapes: np.ndarray  # [n,N,3] displacements, scaled for drawing


def read_found(results):
    """FoundShapes of each stage of results, whose shapes are in files beside theirs."""
    return [read_stage(stage) for stage in results.stages.values() if "words" in stage and "values" not in stage]


def read_stage(stage):
    labels = [f"{number}   {value}   {text}" for number, (value, text) in enumerate(zip(values_of(stage), stage.words), 1)]
    shapes = stage.shapes
    return FoundShapes(stage.name, stage.kind, labels, shapes.position, np.real(shapes.displacement))


def values_of(stage):
    if "factors" in stage:
        return [f"factor {factor:.6g}" for factor in stage.factors]
    rows = zip(stage.frequencies, stage.growth_rates)
    if "damping_ratios" in stage:
        return [describe_eigenvalue(frequency, growth, ratio)
                for (frequency, growth), ratio in zip(rows, stage.damping_ratios)]
    return [f"grows by exp({growth:.4g} t)" if growth > 0.0 else f"f = {frequency:.6g}" for frequency, growth in rows]


def describe_eigenvalue(frequency, growth, ratio):
    if frequency == 0.0:
        return f"exp({growth:.4g} t)"
    return f"f = {frequency:.6g}" + (f"  Re λ = {growth:.4g}" if abs(ratio) > ROUND_OFF else "")


def section_height(found):
    return PANEL_HEIGHT * row_count(found) + 0.35


def row_count(found):
    return -(-min(len(found.labels), MOST_SHAPES) // COLUMNS)


def draw_found(figure, results, found, view=None):
    """Fills a figure or subfigure with a panel for each shape."""
    drawn = min(len(found.labels), MOST_SHAPES)
    extremes = [found.points + sign * move for move in found.shapes[:drawn] for sign in (-1.0, 1.0)]
    scene = Scene([(points, 0.0) for points in extremes], [], [])
    view = view or best_view(scene)
    title = {"modes": "Modes of vibration", "buckling": "Buckling, by linear theory",
             "eigenvalues": "Eigenvalues, real parts of their shapes"}.get(found.kind, found.kind)
    more = f" · the first {drawn} of {len(found.labels)}" if drawn < len(found.labels) else ""
    figure.suptitle(f"{found.stage}: {title}{more}" if found.stage != found.kind else title + more, x=0.02, ha="left",
                    fontsize=9.5, fontweight="bold")
    for number in range(drawn):
        place = (row_count(found), COLUMNS, number + 1)
        draw = draw_in_space if view == "3d" else draw_in_plane
        lines = [(found.points, GREY, 1.0), (found.points - found.shapes[number], PALE, 1.2),
                 (found.points + found.shapes[number], BLUE, 1.8)]
        axes = draw(figure, place, lines, results, limits(scene), view)
        axes.set_title("\n".join(textwrap.wrap(found.labels[number], LABEL_WIDTH)[:2]), fontsize=8, fontweight="normal")


def draw_in_plane(figure, place, lines, results, box, view):
    axes = figure.add_subplot(*place)
    plane = list(PLANES[view])
    for points, colour, width in lines:
        for rod in results.rods:
            axes.plot(*points[rod][:, plane].T, color=colour, linewidth=width, solid_capstyle="round")
    axes.set_xlim(box[0][plane[0]], box[1][plane[0]])
    axes.set_ylim(box[0][plane[1]], box[1][plane[1]])
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    for spine in axes.spines.values():
        spine.set_visible(False)
    return axes


def draw_in_space(figure, place, lines, results, box, _view):
    axes = figure.add_subplot(*place, projection="3d", proj_type="ortho")
    for points, colour, width in lines:
        axes.add_collection(Line3DCollection([points[rod] for rod in results.rods], colors=colour, linewidths=width,
                                             capstyle="round"), autolim=False)
    for set_limits, a, b in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), *box):
        set_limits(a, b)
    axes.set_box_aspect(box[1] - box[0], zoom=1.3)
    axes.view_init(elev=ELEVATION, azim=AZIMUTH)
    axes.set_axis_off()
    for artist in axes.collections:
        artist.set_in_layout(False)
        artist.set_clip_on(False)
    return axes
