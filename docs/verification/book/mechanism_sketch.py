"""The sketch of a mechanism at the start: bodies as bars between their joints, rods, joints and what moves it."""

import numpy as np
from gxrod.plot import style

from . import symbols
from .body_sketch import initial_spin, rotation
from .projection import Projection, find_normal
from .sketch import draw_gravity, draw_loads, draw_rods, draw_supports, draw_velocities, move_text, number_text

BODY = "#dfeaf5"
CIRCLE = np.linspace(0.0, 2.0 * np.pi, 121)[:, None]
AXIS_LENGTH = 0.13  # of the line that shows the axis of a hinge, to either side


def bodies_of(deck):
    """(name, its points) of each body: joints and springs, and the centre of mass where there is but one."""
    for name, body in deck.tree.get("body", {}).items():
        points = deck.points_of_body(name)
        turned = rotation(deck.vector(body.get("rotation_vector", [0, 0, 0])))
        centre = deck.place(name)[0] + turned @ deck.vector(body.get("centre_of_mass", [0, 0, 0]))
        yield name, points if len(points) > 1 else [*points, centre]


def axes_of(joint):
    """The names of the axes that are drawn."""
    return [key for key in ("axis", "axis_b") if key in joint and joint["type"] != "slider"]


def axis_of(deck, joint, key="axis"):
    axis = deck.vector(joint[key])
    return axis / np.linalg.norm(axis)


def choose_projection(deck):
    """A plane, if points, gravity and loads are in one and the axes of hinges across it."""
    points = [place for _, place in deck.joints()] + [point for _, points in bodies_of(deck) for point in points]
    points = np.concatenate([np.array(points), *deck.rods.values()])
    across = [axis_of(deck, joint, key) for joint, _ in deck.joints() for key in axes_of(joint)]
    loads = [vector for _, kind, vector, _ in deck.loads() if kind == "force"]
    inside = [vector for vector in (deck.gravity(), *loads) if np.any(vector)]
    inside += [velocity for _, velocity in deck.velocities() if np.any(velocity)]
    projection = Projection(find_normal(points, inside, across))
    flat = projection(points)
    return projection, np.ptp(flat, axis=0).max()


def draw_bodies(pen, deck):
    """A bar between two points, a plate between more."""
    for _, points in bodies_of(deck):
        flat = pen.projection(np.array(points))
        pen.see(*flat)
        if len(points) > 2:
            pen.axes.fill(*flat.T, fc=BODY, ec=style.BLUE, lw=2.0, zorder=2, joinstyle="round")
        else:
            pen.axes.plot(*flat.T, color=style.BLUE, lw=2.6, solid_capstyle="round", zorder=2)


def disc_axis(deck, name, body):
    """Across which a body is drawn as a disc: the first axis of one that shares a rod's node, the hinge of a wheel; else None."""
    if isinstance(body.get("at"), str):
        return rotation(deck.vector(body.get("rotation_vector", [0, 0, 0])))[:, 0]
    held = [(joint, place) for joint, place in deck.joints() if name in joint["between"]]
    if len(held) == 1 and held[0][0]["type"] == "hinge" and np.allclose(held[0][1], deck.place(name)[0]):
        return axis_of(deck, held[0][0])
    return None


def draw_discs(pen, deck):
    for name, body in deck.tree.get("body", {}).items():
        axis = disc_axis(deck, name, body)
        if axis is None:
            continue
        first = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
        first /= np.linalg.norm(first)
        circle = deck.place(name)[0] + 0.1 * pen.size * (np.cos(CIRCLE) * first + np.sin(CIRCLE) * np.cross(axis, first))
        pen.line(circle, color=style.BLUE, lw=2.0, zorder=4)
        pen.axes.fill(*pen.projection(circle).T, fc=BODY, alpha=0.7, zorder=2)


def draw_rings(pen, deck):
    """Bodies whose joints are all at one place: rings that hold their two axes, the last a wheel across its axis."""
    held = {name: [axis_of(deck, joint) for joint, _ in deck.joints() if name in joint["between"]]
            for name in deck.tree["body"]}
    for index, (name, axes) in enumerate(held.items()):
        centre, radius = deck.place(name)[0], 0.42 * pen.size * 0.72**index
        first = axes[0] if len(axes) > 1 else np.cross(axes[0], np.eye(3)[np.abs(axes[0]).argmin()])
        second = axes[-1] if len(axes) > 1 else np.cross(axes[0], first)
        first, second = (vector / np.linalg.norm(vector) for vector in (first, second))
        circle = centre + radius * (np.cos(CIRCLE) * first + np.sin(CIRCLE) * second)
        pen.line(circle, color=style.BLUE, lw=2.6, zorder=3)
        if len(axes) == 1:
            pen.axes.fill(*pen.projection(circle).T, fc=BODY, alpha=0.7, zorder=2)
        for axis, outer in zip(axes, (1.0 / 0.72, 1.0) if len(axes) > 1 else (1.0 / 0.72,)):
            for side in (-1.0, 1.0):
                ends = centre + side * radius * np.outer([1.0 if len(axes) > 1 else 0.0, outer], axis)
                pen.line(ends, color=symbols.HELD, lw=1.6, zorder=4)


def draw_axis(pen, place, axis):
    """A dashed line along the axis, unless it points at the reader."""
    if np.linalg.norm(pen.projection(axis)) > 0.05:
        ends = place + AXIS_LENGTH * pen.size * np.outer([-1.0, 1.0], axis)
        pen.line(ends, color=symbols.HELD, lw=1.0, ls=(0, (4, 2)), zorder=5)


def draw_block(pen, place, axis):
    """A block on its guide."""
    along = pen.projection(axis)
    along, across = along * pen.size, symbols.paper_normal(along / np.linalg.norm(along)) * pen.size
    at = pen.projection(place)
    corners = [at + x * along + y * across for x, y in ((-0.07, -0.04), (0.07, -0.04), (0.07, 0.04), (-0.07, 0.04))]
    pen.axes.fill(*np.array(corners).T, fc=BODY, ec=style.BLUE, lw=1.6, zorder=3)
    for side in (-0.05, 0.05):
        ends = np.array([at - 0.16 * along + side * across, at + 0.16 * along + side * across])
        pen.axes.plot(*ends.T, color=symbols.HELD, lw=1.3, zorder=3)
        pen.see(*ends)


def draw_joint(pen, deck, joint, place):
    if joint["type"] == "slider":
        draw_block(pen, place, axis_of(deck, joint))
        return
    if "ground" in joint["between"]:
        symbols.hinge(pen, place)
    for key in axes_of(joint):
        draw_axis(pen, place, axis_of(deck, joint, key))
    fill = symbols.HELD if joint["type"] == "ball" else "white"
    pen.axes.plot(*pen.projection(place), "o", ms=5.5, mfc=fill, mec=symbols.HELD, mew=1.4, zorder=7)


def draw_motors(pen, deck):
    """What drives the coordinates of joints, and the fastest spin at the start."""
    for joint, place in deck.joints():
        if "move" in joint and joint["type"] == "hinge":
            axis = axis_of(deck, joint)
            is_along = deck.rods and np.linalg.norm(pen.projection(axis)) > 0.05  # then a rod can be where the words would be
            symbols.moment(pen, place, axis, move_text("rz", 1.0, deck.is_static), colour=symbols.MOVE,
                           apart=(0.1, 1.2) if is_along else None)
        if "drive" in joint and joint["type"] == "hinge":
            symbols.moment(pen, place, axis_of(deck, joint), f"M = {number_text(deck.number(joint['drive']))}")
    spins = {}
    for name, body in deck.tree.get("body", {}).items():
        turned = rotation(deck.vector(body.get("rotation_vector", [0, 0, 0])))
        spins[name] = initial_spin(deck, body, turned)
    name = max(spins, key=lambda each: np.linalg.norm(spins[each]), default=None)
    if name and spins[name].any():
        symbols.moment(pen, deck.place(name)[0], spins[name], f"ω = {number_text(np.linalg.norm(spins[name]))}",
                       colour=symbols.MOVE)


def draw_mechanism(axes, deck, measured):
    """All of a mechanism, with a mark at the points of these histories that are of no joint."""
    projection, size = choose_projection(deck)
    have_axes = all("axis" in joint for joint, _ in deck.joints())
    is_at_one_place = have_axes and np.ptp([place for _, place in deck.joints()], axis=0).max() < 1e-9 and not deck.rods
    pen = symbols.Pen(axes, projection, size if not is_at_one_place else 1.0)
    if is_at_one_place:
        draw_rings(pen, deck)
    else:
        draw_bodies(pen, deck)
        draw_rods(pen, deck)
        draw_discs(pen, deck)
        for joint, place in deck.joints():
            draw_joint(pen, deck, joint, place)
    for ends in deck.springs():
        symbols.spring(pen, ends)
    for ground in deck.grounds():
        symbols.hinge(pen, ground, down=(0.0, 1.0))
    if deck.rods:
        draw_supports(pen, deck)
        draw_velocities(pen, deck)
    draw_loads(pen, deck)
    draw_motors(pen, deck)
    points = {history["name"]: history["at"] for history in deck.tree["history"]}
    for place in deck.places({name for name in measured if points[name] not in deck.tree["joint"]}):
        symbols.measured(pen, place)
    low, high = pen.box()
    draw_gravity(pen, deck, np.array([high[0] + 0.12 * pen.size, high[1]]))
    symbols.axes_of_space(pen, low - [0.2 * pen.size, 0.0])
    return pen.finish()
