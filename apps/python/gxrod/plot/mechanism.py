"""What joints, sleeves, springs and bushings look like in pictures of the motion."""

from dataclasses import dataclass, field

import numpy as np

from .style import GREY

JOINT, SPRING = "#1d8a99", "#b08418"
# Of types of joints: the marker, whether it is filled, and which axes are drawn through it.
MARKERS = {"ball": ("o", True, ""), "hinge": ("o", False, "a"), "cylinder": ("s", False, "a"), "slider": ("s", True, "a"),
           "universal": ("P", True, "ab"), "screw": ("d", True, "a"), "plane": ("D", False, ""), "weld": ("X", True, ""),
           "distance": (".", True, ""), "generic": ("h", True, "a"), "cam": ("p", True, ""), "sleeve": ("o", False, "")}
SIGNS = {"ball": "●", "hinge": "○", "cylinder": "□", "slider": "■", "universal": "✚", "screw": "⬧", "plane": "◇", "weld": "✖",
         "distance": "•", "generic": "⬢", "cam": "⬟", "sleeve": "◉"}
WINDINGS = 8  # of a spring
MARK, BEAD = 6.0, 4.5  # widths in points, of joints and of sleeves at earlier times


@dataclass
class Ends:
    """Rows of a table of results: points that carry the ends A and B (-1: the ground), and arms from there at t = 0."""

    names: list
    types: list
    points: tuple  # of [n]
    arms: tuple  # of [n,3]
    axes: tuple = ()  # of [n,3] at t = 0, of joints


@dataclass
class Mechanism:
    """What is drawn of joints, sleeves, springs and bushings."""

    links: list = field(default_factory=list)  # ([2,3] from a node to a joint, time)
    bars: list = field(default_factory=list)  # [2,3] of distances
    marks: list = field(default_factory=list)  # (type, place [3], colour)
    axes: list = field(default_factory=list)  # ([2,3], colour)
    coils: list = field(default_factory=list)  # [n,3]
    anchors: list = field(default_factory=list)  # places [3] of springs on the ground
    boxes: list = field(default_factory=list)  # places [3] of bushings
    beads: list = field(default_factory=list)  # (places [n,3] of sleeves, time)

    def points(self):
        lines = [line for line, _ in self.links] + self.bars + self.coils
        places = [place for _, place, _ in self.marks] + self.boxes + [places for places, _ in self.beads]
        return np.concatenate([np.reshape(part, (-1, 3)) for part in (*lines, *places)] or [np.empty((0, 3))])


def read_ends(table):
    """Of a table of results; None if it has no rows."""
    if not len(table):
        return None
    texts = lambda name: list(table[name]) if name in table else []
    sides = lambda name: tuple(table[f"{name}_{side}"] for side in "ab" if f"{name}_{side}" in table)
    return Ends(texts("name"), texts("type"), sides("point"), sides("arm"), sides("axis"))


def turn(rotation_vectors, vectors):
    """Vectors [n,3] turned by rotation vectors [n,3]."""
    angles = np.linalg.norm(rotation_vectors, axis=1, keepdims=True)
    axes = np.divide(rotation_vectors, angles, out=np.zeros_like(rotation_vectors), where=angles > 0.0)
    along = axes * np.sum(axes * vectors, axis=1, keepdims=True)
    return along + np.cos(angles) * (vectors - along) + np.sin(angles) * np.cross(axes, vectors)


class FrameEnds:
    """Where the ends are in one frame."""

    def __init__(self, ends, points, rotations):
        self.ends = ends
        self.nodes = [np.where((number >= 0)[:, None], points[number], np.nan) for number in ends.points]
        self.turns = [np.where((number >= 0)[:, None], rotations[number], 0.0) for number in ends.points]
        self.places = [turn(rotation, arm) + np.nan_to_num(node)
                       for rotation, arm, node in zip(self.turns, ends.arms, self.nodes)]

    def middle(self, row):
        return 0.5 * (self.places[0][row] + self.places[1][row])

    def axis(self, row, side):
        """Of a joint, the one that A or B carries."""
        number = "ab".index(side)
        return turn(self.turns[number][row : row + 1], self.ends.axes[number][row : row + 1])[0]


def make_mechanism(results, frames, size):
    """Links and sleeves in all `frames`, all else in the last; `size` is the length of axes."""
    mechanism = Mechanism()
    joints, sleeves, springs, bushings = (results.ends(table) for table in ("joints", "sleeves", "springs", "bushings"))
    in_frame = lambda ends, index: FrameEnds(ends, results.frame(index), results.frame(index, "rotation_vector"))
    last = lambda ends: in_frame(ends, frames[-1])
    for index in frames:
        for ends in filter(None, (joints, sleeves)):
            add_links(mechanism, in_frame(ends, index), results.frame_times[index])
        if sleeves:
            mechanism.beads.append((in_frame(sleeves, index).places[0], results.frame_times[index]))
    if joints:
        add_joints(mechanism, last(joints), size)
    if sleeves:
        add_sleeves(mechanism, last(sleeves))
    if springs:
        add_springs(mechanism, last(springs), size)
    if bushings:
        placed = last(bushings)
        mechanism.boxes = [placed.middle(row) for row in range(len(bushings.names))]
    return mechanism


def add_links(mechanism, placed, time):
    """From each node to the joints that it carries on arms."""
    for nodes, places in zip(placed.nodes, placed.places):
        for node, place in zip(nodes, places):
            if np.linalg.norm(place - node) > 0.0:  # not of the ground, whose node is NaN
                mechanism.links.append((np.array([node, place]), time))


def add_joints(mechanism, placed, size):
    ends = placed.ends
    for row, kind in enumerate(ends.types):
        is_grounded = min(ends.points[0][row], ends.points[1][row]) < 0
        colour = GREY if is_grounded else JOINT
        # What slides is seen at B, or at A if B is the ground.
        slides = kind in ("cylinder", "slider", "screw", "plane")
        rider = 0 if ends.points[1][row] < 0 else 1
        place = placed.places[rider][row] if slides else placed.middle(row)
        if kind == "cam":  # its roller
            place = placed.places[1][row]
        if kind == "distance":
            bar = np.array([placed.places[side][row] for side in (0, 1)])
            mechanism.bars.append(bar)
            mechanism.marks += [(kind, end, colour) for end in bar]
            continue
        mechanism.marks.append((kind, place, colour))
        for side in MARKERS[kind][2] if kind in MARKERS else "":
            half = 0.5 * size * placed.axis(row, side)
            mechanism.axes.append((np.array([place - half, place + half]), colour))


def add_sleeves(mechanism, placed):
    [numbers], [places] = placed.ends.points, placed.places
    mechanism.marks += [("sleeve", place, GREY if number < 0 else JOINT) for number, place in zip(numbers, places)]


def add_springs(mechanism, placed, size):
    for row, (start, end) in enumerate(zip(*placed.places)):
        mechanism.coils.append(coil(start, end, 0.12 * size))
        mechanism.anchors += [place for side, place in enumerate((start, end)) if placed.ends.points[side][row] < 0]


def coil(start, end, radius):
    """A zigzag [n,3] between two points, as wide as it is in the plane in which it turns least out of xy."""
    along = end - start
    across = np.cross([0.0, 0.0, 1.0], along)
    if np.linalg.norm(across) < 1e-9 * np.linalg.norm(along):
        across = np.array([1.0, 0.0, 0.0])
    norm = np.linalg.norm(across)
    across = radius * across / norm if norm > 0.0 else across
    parts = np.concatenate([[0.0, 0.15], np.linspace(0.15, 0.85, 2 * WINDINGS + 1)[1:-1:1], [0.85, 1.0]])
    sides = np.zeros(len(parts))
    sides[2:-2] = [1.0 if i % 2 else -1.0 for i in range(len(parts) - 4)]
    return start + parts[:, None] * along + sides[:, None] * across


def describe(mechanism):
    """What the signs in the picture mean."""
    kinds = list(dict.fromkeys(kind for kind, _, _ in mechanism.marks))
    words = [f"{SIGNS.get(kind, '●')} {kind}" for kind in kinds]
    words += ["○ in the colours of time: before"] if len(mechanism.beads) > 1 else []
    words += ["zigzag: spring"] if mechanism.coils else []
    words += ["ochre ■ bushing"] if mechanism.boxes else []
    if mechanism.anchors or any(colour == GREY for _, _, colour in mechanism.marks):
        words.append("grey: on the ground")
    return ", ".join(words)


def draw_mechanism(axes, mechanism, pick, colour_at):
    """Draws all but the links; `pick` takes points [n,3] to the coordinates of the axes, `colour_at` a time to its colour."""
    plot = lambda points, *style, **more: axes.plot(*pick(np.reshape(points, (-1, 3))).T, *style, **more)
    for places, time in mechanism.beads:
        plot(places, "o", color=colour_at(time), markersize=BEAD, markerfacecolor="white", markeredgewidth=1.3, zorder=4)
    for line, colour in mechanism.axes:
        plot(line, color=colour, linewidth=1.1)
    for bar in mechanism.bars:
        plot(bar, color=JOINT, linewidth=1.4)
    for line in mechanism.coils:
        plot(line, color=SPRING, linewidth=1.2, solid_joinstyle="round")
    if mechanism.anchors:
        plot(mechanism.anchors, ".", color=GREY, markersize=8)
    if mechanism.boxes:
        plot(mechanism.boxes, "s", color=SPRING, markersize=6)
    for kind, colour in dict.fromkeys((kind, colour) for kind, _, colour in mechanism.marks):
        marker, is_filled, _ = MARKERS.get(kind, ("o", True, ""))
        places = [place for other, place, its in mechanism.marks if (other, its) == (kind, colour)]
        plot(places, marker, color=colour, markersize=1.5 * MARK if kind == "sleeve" else MARK,
             markerfacecolor=colour if is_filled else "white", markeredgewidth=1.3, zorder=5)
        if kind == "sleeve":  # a bead that reaches out of its rod, and what slides in it
            plot(places, "o", color=colour, markersize=0.5 * MARK, zorder=6)
