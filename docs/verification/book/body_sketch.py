"""The sketch of a rigid body: its inertia ellipsoid, its fixed point and arm, its spin and what turns it."""

import numpy as np
from gxrod.plot import style

from . import symbols
from .projection import Projection
from .sketch import draw_gravity, load_text, number_text

CIRCLE = np.linspace(0.0, 2.0 * np.pi, 121)


def rotation(vector):
    """Rodrigues' formula."""
    angle = np.linalg.norm(vector)
    if angle == 0.0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross


def semi_axes(inertia, mass):
    """Of the homogeneous ellipsoid with this inertia."""
    return np.sqrt(np.maximum(2.5 * (0.5 * inertia.sum() - inertia) * 2.0 / mass, 0.0))


def fit_to_arm(axes, arm):
    """An ellipsoid that is large compared with its arm is drawn smaller, in the same shape."""
    length = np.linalg.norm(arm)
    return axes * min(1.0, 0.6 * length / axes.max()) if length else axes


def silhouette(pen, centre, shape):
    """The outline on the paper of the ellipsoid with these columns as semi-axes."""
    flat = pen.projection.rows @ shape
    sizes, directions = np.linalg.eigh(flat @ flat.T)
    ends = directions * np.sqrt(sizes)
    return pen.projection(centre) + np.outer(np.cos(CIRCLE), ends[:, 0]) + np.outer(np.sin(CIRCLE), ends[:, 1])


def draw_ellipsoid(pen, centre, shape):
    outline = silhouette(pen, centre, shape)
    pen.see(*outline)
    pen.axes.fill(*outline.T, fc="#dfeaf5", ec=style.BLUE, lw=1.6, zorder=2)
    for first, second in ((0, 1), (1, 2), (2, 0)):
        offset = np.outer(np.cos(CIRCLE), shape[:, first]) + np.outer(np.sin(CIRCLE), shape[:, second])
        normal = np.cross(shape[:, first], shape[:, second])
        normal = normal / max(np.linalg.norm(normal), 1e-30)
        towards = offset @ (pen.projection.towards - (pen.projection.towards @ normal) * normal)
        curve = np.where((towards > 0.0)[:, None], centre + offset, np.nan)
        pen.line(curve, color=style.BLUE, lw=0.7, alpha=0.8, zorder=3)


def draw_triad(pen, centre, turned, shape):
    """The body's axes, a little longer than its semi-axes."""
    for name, axis, size in zip("xyz", turned.T, np.linalg.norm(shape, axis=0)):
        end = pen.projection(centre + (size + 0.16 * pen.size) * axis)
        symbols.arrow(pen, pen.projection(centre), end, style.AXIS_COLOURS[name], width=1.1)
        pen.text(end + 0.05 * pen.size * pen.projection.direction(axis), name, color=style.AXIS_COLOURS[name],
                 fontsize=9, bbox=None)


def initial_spin(deck, body, turned):
    """Spatial angular velocity at the start."""
    if "angular_velocity_material" in body:
        return turned @ deck.vector(body["angular_velocity_material"])
    return deck.vector(body.get("angular_velocity", [0, 0, 0]))


def draw_spin(pen, deck, centre, spin, reach):
    if spin.any():
        at = centre + reach * spin / np.linalg.norm(spin)
        symbols.moment(pen, at, spin, f"ω = {number_text(np.linalg.norm(spin))}", colour=symbols.MOVE)
    for _, _, vector, changes in deck.loads():
        at = centre + reach * vector / np.linalg.norm(vector)
        symbols.moment(pen, at, vector, load_text("moment", vector, changes, deck.is_static))


def draw_body(axes, deck):
    """All of a problem of one rigid body."""
    body = next(iter(deck.tree["body"].values()))
    turned = rotation(deck.vector(body.get("rotation_vector", [0, 0, 0])))
    place, arm = deck.vector(body["at"]), turned @ deck.vector(body.get("centre_of_mass", [0, 0, 0]))
    centre = place + arm
    sizes = fit_to_arm(semi_axes(deck.vector(body["inertia"]), deck.number(body["mass"])), arm)
    shape = turned * sizes
    springs = list(deck.springs())
    reach = max([0.5 * np.linalg.norm(arm), *(0.5 * np.linalg.norm(b - a) for a, b in springs)])
    pen = symbols.Pen(axes, Projection(), 1.9 * max(sizes.max(), reach))
    draw_ellipsoid(pen, centre, shape)
    draw_triad(pen, centre, turned, shape)
    spin = initial_spin(deck, body, turned)
    axis = spin if spin.any() else np.array([0, 0, 1.0])
    draw_spin(pen, deck, centre, spin, np.linalg.norm(shape.T @ axis) / np.linalg.norm(axis) + 0.3 * pen.size)
    if arm.any():
        pen.line(np.array([place, centre]), color=style.BLACK, lw=2.2, zorder=4)
        pen.text(pen.projection(0.35 * centre + 0.65 * place) + [0.0, 0.07 * pen.size],
                 f"l = {number_text(np.linalg.norm(arm))}")
    for ends in springs:
        symbols.spring(pen, ends)
    for ground in deck.grounds():
        symbols.hinge(pen, ground, down=(0.0, 1.0))
    for _ in deck.supports():
        symbols.hinge(pen, place)
    low, high = pen.box()
    draw_gravity(pen, deck, np.array([high[0] + 0.35 * pen.size, high[1]]))
    symbols.axes_of_space(pen, low - [0.2 * pen.size, 0.0])
    return pen.finish()
