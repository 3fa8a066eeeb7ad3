"""What sketches are drawn of: supports, arrows, dimensions, axes. Lengths are parts of the picture's size."""

import numpy as np
from gxrod.plot import style

FORCE, MOVE, HELD, QUIET = style.ORANGE, style.PURPLE, style.BLACK, style.GREY
TURN = np.radians(290.0)  # of a round arrow


class Pen:
    """Axes to draw on, the projection, and the size of the picture in units of length."""

    def __init__(self, axes, projection, size):
        self.axes, self.projection, self.size = axes, projection, size
        self.seen = []  # points of the paper that the picture must hold

    def see(self, *points):
        self.seen += [point for point in np.array(points, float) if np.isfinite(point).all()]

    def box(self):
        """Lower left and upper right corner of what was drawn."""
        return np.array([np.min(self.seen, axis=0), np.max(self.seen, axis=0)])

    def line(self, points, **options):
        flat = self.projection(points)
        self.see(*flat)
        self.axes.plot(flat[:, 0], flat[:, 1], **{"solid_capstyle": "round", **options})

    def text(self, at, words, **options):
        """At a point of the paper."""
        settings = {"ha": "center", "va": "center", "fontsize": 9.5, "zorder": 6,
                    "bbox": {"fc": "white", "ec": "none", "alpha": 0.8, "pad": 0.8}, **options}
        self.see(at)
        self.axes.text(*at, words, **settings)

    def finish(self):
        """Sets the limits of the picture, out of which words may stand; returns width and height in sizes."""
        low, high = self.box() + 0.03 * self.size * np.array([[-1.0], [1.0]])
        self.axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
        self.axes.axis("off")
        return (high - low) / self.size


def paper_normal(direction):
    return np.array([-direction[1], direction[0]])


def arrow(pen, start, end, colour, width=1.8, style_of_head="-|>"):
    """Between two points of the paper."""
    pen.see(start, end)
    pen.axes.annotate("", xy=end, xytext=start, zorder=5, annotation_clip=False, arrowprops={
        "arrowstyle": f"{style_of_head},head_width=0.28,head_length=0.55", "color": colour, "lw": width,
        "shrinkA": 0, "shrinkB": 0, "mutation_scale": 11})


def force(pen, place, vector, words, colour=FORCE, length=0.2):
    """Begins at its point; the words are at its head."""
    start, direction = pen.projection(place), pen.projection.direction(vector)
    end = start + length * pen.size * direction
    arrow(pen, start, end, colour)
    if direction[1] < -0.5:  # next to the head: below it the rod can be
        pen.text(end + [0.04 * pen.size, 0.0], words, color=colour, ha="left")
    else:
        pen.text(end + 0.05 * pen.size * direction, words, color=colour, ha=side_of(direction), va=height_of(direction))


def side_of(direction):
    return "left" if direction[0] > 0.5 else "right" if direction[0] < -0.5 else "center"


def height_of(direction):
    return "bottom" if direction[1] > 0.7 else "top" if direction[1] < -0.7 else "center"


def moment(pen, place, vector, words, colour=FORCE, apart=None):
    """A round arrow in the plane across its vector, right-handed; in space with the vector itself, thin."""
    axis = np.asarray(vector, float) / np.linalg.norm(vector)
    radius = 0.085 * pen.size
    first = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    first /= np.linalg.norm(first)
    second = np.cross(axis, first)
    angles = np.linspace(0.0, TURN, 60)[:, None]
    circle = place + radius * (np.cos(angles) * first + np.sin(angles) * second)
    pen.line(circle[:-3], color=colour, lw=1.8, zorder=5)
    flat, centre = pen.projection(circle), pen.projection(place)
    arrow(pen, flat[-6], flat[-1], colour)
    straight = pen.projection(axis)
    if np.linalg.norm(straight) > 0.05:
        arrow(pen, centre, centre + 2.2 * radius * straight, colour, width=0.9)
    at = words_next_to(straight) if apart is None else 1.7 * np.asarray(apart)
    pen.text(centre + radius * at, words, color=colour, ha=side_of(at), va=height_of(at))


def words_next_to(straight):
    """Where the words of a round arrow are, in its radii: at the head of its vector; next to it where a force can be, to
    the right of one that points up; above one that is seen from its tip."""
    if np.linalg.norm(straight) < 0.05:
        return np.array([0.6, 1.5])
    if straight[1] < -0.3 or abs(straight[0]) > 0.3:
        return 2.2 * straight + 0.5 * straight / np.linalg.norm(straight)
    across = paper_normal(straight / np.linalg.norm(straight))
    return 2.0 * np.sign(-straight[1]) * across


def clamp(pen, place, tangent):
    """A wall across the tangent, hatched away from the rod."""
    centre, out = pen.projection(place), pen.projection.direction(tangent)
    along = paper_normal(out)
    reach = 0.075 * pen.size
    ends = np.array([centre - reach * along, centre + reach * along])
    pen.axes.plot(*ends.T, color=HELD, lw=2.2, zorder=4)
    pen.see(*(ends - 0.02 * pen.size * out))
    hatch(pen, ends, -out)


def hatch(pen, ends, towards, strokes=6):
    """Short strokes from a line to the side that holds it."""
    step = (ends[1] - ends[0]) / strokes
    for index in range(strokes):
        foot = ends[0] + (index + 0.8) * step
        stroke = np.array([foot, foot - 0.8 * step + 0.85 * np.linalg.norm(step) * towards])
        pen.axes.plot(*stroke.T, color=HELD, lw=0.9, zorder=4)


def spring(pen, ends, turns=8):
    """A zigzag from one point to the other, straight near both."""
    start, end = pen.projection(np.array(ends))
    along = end - start
    across = 0.03 * pen.size * paper_normal(along / np.linalg.norm(along))
    shares = np.concatenate([[0.0], np.linspace(0.2, 0.8, 2 * turns + 1), [1.0]])
    sides = np.concatenate([[0.0, 0.0], np.tile([1.0, -1.0], turns)[1:], [0.0, 0.0]])
    line = start + shares[:, None] * along + sides[:, None] * across
    pen.see(*line)
    pen.axes.plot(*line.T, color=HELD, lw=1.2, zorder=3, solid_joinstyle="round")


def hinge(pen, place, down=(0.0, -1.0)):
    """A triangle with its top at the point, on hatched ground."""
    top, down = pen.projection(place), np.asarray(down)
    across, reach = paper_normal(down), 0.055 * pen.size
    ends = np.array([top + 1.7 * reach * down - reach * across, top + 1.7 * reach * down + reach * across])
    pen.axes.fill(*np.array([top, *ends]).T, fc="white", ec=HELD, lw=1.5, zorder=4)
    wide = ends + 0.4 * reach * np.array([[-1.0], [1.0]]) * across
    pen.axes.plot(*wide.T, color=HELD, lw=1.5, zorder=4)
    pen.see(*(wide + 0.4 * reach * down))
    hatch(pen, wide, down)
    pen.axes.plot(*top, "o", ms=5.5, mfc="white", mec=HELD, mew=1.4, zorder=6)


def dimension(pen, start, end, words, side=1.0, share=0.5):
    """A line with a head at both ends, next to what it measures; its words at a share of it."""
    start, end = pen.projection(start), pen.projection(end)
    length = np.linalg.norm(end - start)
    offset = side * 0.1 * pen.size * paper_normal((end - start) / length)
    for point in (start, end):
        foot = np.array([point + 0.25 * offset, point + 1.12 * offset])
        pen.axes.plot(*foot.T, color=QUIET, lw=0.7, zorder=1)
    arrow(pen, start + offset, end + offset, QUIET, width=0.8, style_of_head="<|-|>")
    along = end - start if end[0] >= start[0] else start - end
    pen.text((1.0 - share) * start + share * end + offset, words, color="#4a4f57", rotation_mode="anchor",
             rotation=np.degrees(np.arctan2(along[1], along[0])))


def axes_of_space(pen, corner, names="xyz", length=0.1):
    """The three axes at a corner of the paper; one that points at the reader is left out."""
    for index, name in enumerate(names):
        flat = pen.projection(np.eye(3)[index])
        if np.linalg.norm(flat) < 0.05:
            continue
        end = corner + length * pen.size * flat
        arrow(pen, corner, end, style.AXIS_COLOURS[name], width=1.2)
        pen.text(corner + (length + 0.035 / np.linalg.norm(flat)) * pen.size * flat, name, fontsize=9,
                 color=style.AXIS_COLOURS[name], bbox=None)


def measured(pen, place):
    """A point whose motion is compared."""
    pen.axes.plot(*pen.projection(place), "o", ms=6, mfc="white", mec=style.BLUE, mew=1.6, zorder=6)
