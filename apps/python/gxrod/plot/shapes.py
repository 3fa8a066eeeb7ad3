"""Deflected shapes over time, in space or in a plane."""

from dataclasses import dataclass, field

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.art3d import Line3DCollection

from ..results.outlines import place_corners
from .errors import UsageError
from .mechanism import Mechanism, describe, draw_mechanism, make_mechanism
from .style import AXIS_COLOURS, GREY, TIME_COLOURS

DEFAULT_FRAMES = 12
MOST_TRACED = 2000  # frames of a trace
MOST_EDGES = 3000  # of a body, that are drawn
PLANES = {"xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
AXES = "xyz"
ELEVATION, AZIMUTH = 22, -58  # degrees, of views in space
SIDES, BELOW = 1.7, 1.0  # inches that ticks, labels, title and colour bar take
LEAST_WIDTH, LEAST_HEIGHT = 3.2, 2.2
FLATTEST = 0.7  # height of a view in space relative to its width


@dataclass
class Scene:
    """Everything that is drawn: lines of points in space, with their times or colours."""

    shapes: list  # (points [n,3], time)
    traces: list  # (points [F,3], times [F])
    triads: list  # (origin [3], axes {letter: tip [3]})
    outlines: list = field(default_factory=list)  # (edges [L,2,3] of a body, time)
    mechanism: Mechanism = field(default_factory=Mechanism)

    def places(self):
        """All points but those of outlines and the tips of axes."""
        return np.concatenate([*(points for points, _ in self.shapes + self.traces), self.mechanism.points()])

    def points(self):
        tips = [tip for origin, axes in self.triads for tip in (origin, *axes.values())]
        edges = [np.reshape(lines, (-1, 3)) for lines, _ in self.outlines]
        return np.concatenate([self.places(), *edges, np.reshape(tips, (-1, 3))])


def choose_frames(results, times=None, count=None):
    """Indices of the frames to draw: the nearest to each of `times`, or `count` evenly over the time."""
    all_times = results.frame_times
    if times:
        first, last = all_times[0], all_times[-1]
        slack = 1e-9 * (last - first)
        for time in times:
            if not first - slack <= time <= last + slack:
                raise UsageError(f"there is no frame at {time:g}; they go from {first:g} to {last:g}")
        return sorted({int(np.abs(all_times - time).argmin()) for time in times})
    wanted = np.linspace(all_times[-1], all_times[0], count or DEFAULT_FRAMES)  # the last one always
    return sorted({int(np.abs(all_times - time).argmin()) for time in wanted})


def make_scene(results, frames):
    shapes = []
    for index in frames:
        points = results.frame(index)
        shapes += [(points[rod], results.frame_times[index]) for rod in results.rods]
    scene = Scene(shapes, [], [])
    stride = -(-len(results.frame_times) // MOST_TRACED)
    times = results.frame_times[::stride]
    scene.traces = [(results.trace(node, stride), times) for node in results.bodies]
    scene.mechanism = make_mechanism(results, frames, triad_size(scene))
    size = triad_size(scene)
    jointed = nodes_on_joints(results)
    add_outlines(scene, results, frames, jointed)
    for node, (path, _) in zip(results.bodies, list(scene.traces)):
        travels = np.ptp(path, axis=0).max() > size
        if travels and node in jointed:
            # Its links show how it turns.
            add_triads(scene, results, node, frames[-1:], 0.4 * size)
        elif travels:
            add_triads(scene, results, node, frames, size)
        else:
            # A body that turns on the spot: the path of its steadiest axis shows how.
            add_triads(scene, results, node, frames[-1:], 2.0 * size)
            scene.traces.append((path + 2.0 * size * steadiest_axis(results, node, stride), times))
    return scene


def add_outlines(scene, results, frames, jointed):
    """Edges of bodies in the last frame, and in those where a corner has moved on by more than half of the body. Of those on joints links show the way:
    they have edges in the last frame, and only where the deck has their looks."""
    for outline in results.outlines():
        if outline.point in jointed and not outline.is_given:
            continue
        edges = outline.lines[:: -(-len(outline.lines) // MOST_EDGES)] if len(outline.lines) else outline.lines
        drawn = None
        for index in () if not len(edges) else frames[-1:] if outline.point in jointed else frames:
            corners = place_corners(outline.corners, *(results.frame(index, name)[outline.point] for name in ("position", "rotation_vector")))
            if drawn is not None and index != frames[-1] and np.abs(corners - drawn).max() < 0.5 * np.ptp(corners, axis=0).max():
                continue
            drawn = corners
            scene.outlines.append((corners[edges], results.frame_times[index]))


def nodes_on_joints(results):
    tables = filter(None, (results.ends("joints"), results.ends("sleeves")))
    return {int(node) for ends in tables for numbers in ends.points for node in numbers}


def steadiest_axis(results, node, stride):
    """The body axis [F,3] whose tip travels least from frame to frame: that about which the body spins, if it does."""
    axes = [results.trace(node, stride, f"axis_{axis}") for axis in "zyx"]
    return min(axes, key=lambda axis: np.linalg.norm(np.diff(axis, axis=0), axis=1).sum())


def triad_size(scene):
    """Length of the axes drawn at bodies: a part of the picture, or 1/2 where nothing moves or has a size."""
    points = scene.points()
    extent = np.ptp(points, axis=0).max() if len(points) else 0.0
    return 0.12 * extent if extent > 1e-9 else 0.5


def add_triads(scene, results, node, frames, size):
    """The axes of a body in the last frame, and in those where it has moved on by more than their length."""
    drawn = None
    for index in frames:
        origin = results.frame(index)[node]
        if drawn is not None and np.linalg.norm(origin - drawn) < 1.2 * size and index != frames[-1]:
            continue
        drawn = origin
        axes = {axis: origin + size * results.frame(index, f"axis_{axis}")[node] for axis in AXES}
        scene.triads.append((origin, axes))


def best_view(scene):
    """The plane that holds all shapes and traces, or space."""
    extent = np.ptp(scene.places(), axis=0)
    for view, plane in PLANES.items():
        if extent[3 - sum(plane)] < 1e-6 * extent.max():
            return view
    return "3d"


def prepare_shapes(results, frames, view=None):
    """A scene, and the view that shows it: the requested one, or the best."""
    scene = make_scene(results, frames)
    return scene, view or best_view(scene)


def fitting_size(shapes, most_width, most_height):
    """Width and height of a figure that the scene fills, with room for ticks and the colour bar."""
    width_of, height_of = picture_sides(*shapes)
    aspect = height_of / width_of
    height = min(most_height, aspect * (most_width - SIDES) + BELOW)
    width = min(most_width, (height - BELOW) / aspect + SIDES)
    return max(width, LEAST_WIDTH), max(height, LEAST_HEIGHT)


def picture_sides(scene, view):
    """Width and height of what is drawn, in the scene's own units."""
    low, high = limits(scene)
    extent = high - low
    if view != "3d":
        across, up = PLANES[view]
        return extent[across], extent[up]
    # A box seen from the side and above, with its labels around it.
    turn, lift = np.radians(AZIMUTH), np.radians(ELEVATION)
    across = abs(np.sin(turn)) * extent[0] + abs(np.cos(turn)) * extent[1]
    deep = abs(np.cos(turn)) * extent[0] + abs(np.sin(turn)) * extent[1]
    width, height = 1.25 * across + 0.1 * extent.max(), 1.1 * (np.cos(lift) * extent[2] + np.sin(lift) * deep)
    return width, max(height, FLATTEST * width)


def draw_shapes(figure, results, shapes):
    """Fills a figure or subfigure with one picture and its colour bar."""
    scene, view = shapes
    norm = Normalize(results.frame_times[0], max(results.frame_times[-1], results.frame_times[0] + 1e-300))
    if view == "3d":
        axes = figure.add_subplot(projection="3d", proj_type="ortho")
        draw_in_space(axes, scene, norm, zoom_for(figure))
    else:
        axes = figure.add_subplot()
        draw_in_plane(axes, scene, norm, PLANES[view], view)
    title = f"{'Shapes' if results.rods else 'Motion'} over {results.time_label}"
    figure.suptitle(title, x=0.02, ha="left", fontsize=9.5, fontweight="bold")
    notes = [*(["bodies by their axes: x red, y green, z blue"] if scene.triads else []), describe(scene.mechanism)]
    if any(notes):
        figure.supxlabel("\n".join(filter(None, notes)), x=0.02, ha="left", fontsize=8, color="#5b616b")
    bar = figure.colorbar(ScalarMappable(norm, TIME_COLOURS), ax=axes, shrink=0.7, aspect=30,
                          pad=0.09 if view == "3d" else 0.02)
    bar.outline.set_visible(False)
    bar.set_label(results.time_label)


def coloured_lines(scene, norm, pick):
    """Segments, colours and widths of the shapes and of the traces, in the picked directions."""
    lines = [(pick(points), TIME_COLOURS(norm(time)), 1.8) for points, time in scene.shapes + scene.mechanism.links]
    lines += [(pick(edge), TIME_COLOURS(norm(time)), 0.8) for edges, time in scene.outlines for edge in edges]
    for points, times in scene.traces:
        picked = pick(points)
        lines += [(picked[i : i + 2], TIME_COLOURS(norm(times[i])), 1.0) for i in range(len(picked) - 1)]
    return zip(*lines) if lines else ([], [], [])


def draw_in_plane(axes, scene, norm, plane, view):
    segments, colours, widths = coloured_lines(scene, norm, lambda points: points[:, plane])
    axes.add_collection(LineCollection(segments, colors=colours, linewidths=widths, capstyle="round"))
    for origin, tips in scene.triads:
        for axis, tip in tips.items():
            ends = np.array([origin, tip])[:, plane]
            axes.plot(*ends.T, color=AXIS_COLOURS[axis], linewidth=1.6, solid_capstyle="round")
        axes.plot(*origin[list(plane)], "o", color=GREY, markersize=4)
    draw_mechanism(axes, scene.mechanism, lambda points: points[:, plane], lambda time: TIME_COLOURS(norm(time)))
    low, high = limits(scene)
    for set_limits, direction in zip((axes.set_xlim, axes.set_ylim), plane):
        set_limits(low[direction], high[direction])
    axes.set_aspect("equal")
    axes.set_xlabel(view[0])
    axes.set_ylabel(view[1])


def zoom_for(figure):
    """Matplotlib fits a scene into a square; this lets a tall one, as a column's, reach beyond it above and below."""
    box = figure.bbox.transformed(figure.dpi_scale_trans.inverted())
    width, height = max(box.width - SIDES, 0.5), max(box.height - BELOW, 0.5)
    return 1.05 * max(1.0, 0.76 * height / width)


def draw_in_space(axes, scene, norm, zoom):
    segments, colours, widths = coloured_lines(scene, norm, lambda points: points)
    # Its limits are set by hand; those of add_collection3d want lines of as many points.
    axes.add_collection(Line3DCollection(segments, colors=colours, linewidths=widths, capstyle="round"), autolim=False)
    for origin, tips in scene.triads:
        for axis, tip in tips.items():
            axes.plot(*np.array([origin, tip]).T, color=AXIS_COLOURS[axis], linewidth=1.8)
        axes.plot(*origin[:, None], "o", color=GREY, markersize=4)
    draw_mechanism(axes, scene.mechanism, lambda points: points, lambda time: TIME_COLOURS(norm(time)))
    low, high = limits(scene)
    for set_limits, a, b in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), low, high):
        set_limits(a, b)
    axes.set_box_aspect(high - low, zoom=zoom)
    axes.view_init(elev=ELEVATION, azim=AZIMUTH)
    for name in AXES:
        axis = getattr(axes, f"{name}axis")
        axis.set_pane_color((1.0, 1.0, 1.0, 0.0))
        axis.line.set_color(GREY)
        axis._axinfo["grid"].update(color="#e4e6ea", linewidth=0.7)
        axis.set_label_text(name)
        axis.labelpad = 2.0
        axis.set_major_locator(few_ticks(high - low, AXES.index(name)))
    for artist in [*axes.collections, *axes.lines]:
        artist.set_in_layout(False)
        artist.set_clip_on(False)


def few_ticks(extent, direction):
    """Fewer ticks on the short sides of the box."""
    share = extent[direction] / extent.max()
    return MaxNLocator(nbins=max(2, round(6 * share)), steps=[1, 2, 2.5, 5, 10])


def limits(scene):
    """Corners of the box around the scene, never thinner than a part of its longest side."""
    points = scene.points()
    low, high = points.min(axis=0), points.max(axis=0)
    longest = max((high - low).max(), 1e-12)
    half = np.maximum(0.5 * (high - low), 0.06 * longest) + 0.02 * longest
    middle = 0.5 * (low + high)
    return middle - half, middle + half
