"""The sketch of a problem of rods, from its deck."""

import numpy as np
from gxrod.plot import style

from . import symbols
from .deck import FREE_AXES, Deck
from .projection import Projection, find_normal

COMPONENTS = ("x", "y", "z", *FREE_AXES)
INCHES = 2.6  # of a picture's size


def number_text(value):
    """As short as it can be, with π where it is one of its multiples."""
    quarters = 4.0 * value / np.pi
    if value and abs(quarters - round(quarters)) < 1e-9 * abs(quarters):
        times = f"{round(quarters) / 4:g}"
        return "π" if times == "1" else f"{times}π"
    return f"{value:.4g}".replace("e+0", "e").replace("e+", "e")


def load_text(kind, vector, changes, is_static):
    letter, size = "F" if kind == "force" else "M", number_text(np.linalg.norm(vector))
    return f"{letter}(t) ≤ {size}" if changes and not is_static else f"{letter} = {size}"


def move_text(component, size, is_static):
    if component in FREE_AXES:
        return f"turned by {number_text(abs(size))}" if is_static else "turned by θ(t)"
    return f"moved by {number_text(abs(size))}" if is_static else "moved"


def direction_of(component, size, axes):
    """Unit vector of a component of a support, with the sign of what is prescribed."""
    return np.sign(size) * axes[COMPONENTS.index(component) % 3]


def choose_projection(deck):
    """A plane if curves, loads, moves and velocities have one."""
    straight = [vector for _, kind, vector, _ in deck.loads() if kind == "force"]
    straight += [velocity for _, velocity in deck.velocities()] + [deck.gravity()]
    round_about = [vector for _, kind, vector, _ in deck.loads() if kind == "moment"]
    for _, _, _, move, axes in deck.supports():
        for component, size in move.items():
            (round_about if component in FREE_AXES else straight).append(direction_of(component, size, axes))
    points = np.concatenate(list(deck.rods.values()))
    straight, round_about = ([each for each in some if np.any(each)] for some in (straight, round_about))
    return Projection(find_normal(points, straight, round_about))


def draw_rods(pen, deck):
    for curve in deck.rods.values():
        pen.line(curve, color=style.BLUE, lw=3.4, zorder=3)
    corners = [curve[-1] for curve in deck.rods.values()][:-1]
    for corner in corners:
        pen.axes.plot(*pen.projection(corner), "s", ms=5, color=style.BLUE, zorder=4)


def draw_sizes(pen, deck):
    middle = pen.projection(np.concatenate(list(deck.rods.values()))).mean(axis=0)
    for name, rod in deck.tree["rod"].items():
        curve = deck.rods[name]
        if "arc" in rod:
            draw_arc_size(pen, deck, rod["arc"], curve)
            continue
        if "spline" in rod:
            continue
        words = f"{'L = ' if len(deck.rods) == 1 else ''}{number_text(np.linalg.norm(curve[-1] - curve[0]))}"
        start, end = pen.projection(curve[[0, -1]])
        outwards = symbols.paper_normal(end - start) @ (0.5 * (start + end) - middle)
        side = np.sign(outwards) if abs(outwards) > 1e-6 * pen.size**2 else side_away_from_loads(pen, deck, end - start)
        is_loaded_in_middle = any(np.allclose(place, curve.mean(axis=0)) for place, *_ in deck.loads())
        symbols.dimension(pen, curve[0], curve[-1], words, side=side, share=0.25 if is_loaded_in_middle else 0.5)


def side_away_from_loads(pen, deck, along):
    """Of a rod, the side to which loads do not point: below if there are none, above where a hinge is."""
    if any({"x", "y", "z"} <= held and len(held | set(move)) < 6 for _, _, held, move, _ in deck.supports()):
        return 1.0
    normal = symbols.paper_normal(along)
    push = sum(pen.projection.direction(vector) @ normal for _, kind, vector, _ in deck.loads() if kind == "force")
    return -1.0 if abs(push) < 1e-6 and normal[1] > 0.0 or push > 0.0 else 1.0


def draw_arc_size(pen, deck, arc, curve):
    """A radius to the middle of the arc, and its angle at the centre."""
    angle = np.degrees(deck.number(arc["angle"]))
    centre, middle = deck.vector(arc["centre"]), curve[int((0.15 if abs(angle) > 90.0 else 0.35) * len(curve))]
    for point in (curve[0], curve[-1]):
        pen.line(np.array([centre, point]), color=symbols.QUIET, lw=0.6, ls=":")
    symbols.arrow(pen, pen.projection(centre), pen.projection(middle), symbols.QUIET, width=0.8)
    pen.text(pen.projection(0.35 * centre + 0.65 * middle), f"R = {number_text(np.linalg.norm(middle - centre))}",
             color="#4a4f57")
    if abs(angle) > 359.0:
        return
    pen.line(centre + 0.2 * (curve - centre), color=symbols.QUIET, lw=0.8)
    pen.text(pen.projection(centre + 0.32 * (curve[int(0.62 * len(curve))] - centre)), f"{angle:g}°", color="#4a4f57")


def draw_supports(pen, deck):
    for place, tangent, held, move, axes in deck.supports():
        if len(held | set(move)) == 6:
            symbols.clamp(pen, place, tangent)
        elif {"x", "y", "z"} <= held:
            symbols.hinge(pen, place)
        for component, size in move.items():
            words, vector = move_text(component, size, deck.is_static), direction_of(component, size, axes)
            if component in FREE_AXES:
                symbols.moment(pen, place, vector, words, colour=symbols.MOVE, apart=(0.1, 1.2))
            else:
                symbols.force(pen, place, vector, words, colour=symbols.MOVE)


def draw_loads(pen, deck):
    for place, kind, vector, changes in deck.loads():
        words = load_text(kind, vector, changes, deck.is_static)
        if kind == "force":
            symbols.force(pen, place, vector, words)
        else:
            symbols.moment(pen, place, vector, words)


def draw_velocities(pen, deck):
    found = list(deck.velocities())
    largest = max((np.linalg.norm(velocity) for _, velocity in found), default=0.0)
    for place, velocity in found:
        start = pen.projection(place)
        symbols.arrow(pen, start, start + 0.3 * pen.size / largest * pen.projection(velocity), symbols.MOVE, width=1.0)
    if found:
        start, velocity = found[-1]
        at = pen.projection(start) + 0.36 * pen.size / largest * pen.projection(velocity)
        pen.text(at, "velocity at t = 0", color=symbols.MOVE, va="bottom")


def draw_gravity(pen, deck, corner):
    gravity = deck.gravity()
    if gravity.any():
        end = corner + 0.14 * pen.size * pen.projection.direction(gravity)
        symbols.arrow(pen, corner, end, style.GREEN)
        pen.text(end + 0.05 * pen.size * pen.projection.direction(gravity),
                 f"g = {number_text(np.linalg.norm(gravity))}", color=style.GREEN, va="top")


def draw_sketch(axes, deck, measured):
    """All of a problem of rods, with a mark at the points of these histories."""
    projection = choose_projection(deck)
    flat = projection(np.concatenate(list(deck.rods.values())))
    pen = symbols.Pen(axes, projection, np.ptp(flat, axis=0).max())
    draw_rods(pen, deck)
    draw_sizes(pen, deck)
    draw_supports(pen, deck)
    draw_velocities(pen, deck)
    draw_loads(pen, deck)
    for place in deck.places(measured):
        symbols.measured(pen, place)
    low, high = pen.box()
    draw_gravity(pen, deck, np.array([high[0] + 0.12 * pen.size, high[1]]))
    symbols.axes_of_space(pen, low - [0.2 * pen.size, 0.0])
    return pen.finish()


def save_sketch(path, decks, metadata):
    """A picture of one deck, or of several under their titles; `decks` is {title: (path, histories compared)}."""
    from .body_sketch import draw_body  # which need this module
    from .mechanism_sketch import draw_mechanism

    figure, right = style.plt.figure(figsize=(1.0, 1.0)), 0.0
    style.plt.rcParams.update(style.SETTINGS)
    for title, (deck_path, measured) in decks.items():
        deck, axes = Deck(deck_path), figure.add_axes([0.0, 0.0, 1.0, 1.0])
        size = INCHES * np.array(draw_mechanism(axes, deck, measured) if "joint" in deck.tree else
                                 draw_sketch(axes, deck, measured) if deck.rods else draw_body(axes, deck))
        axes.set_position([right, 0.0, *size])  # of a figure of one inch; what stands out of it is saved, too
        right += size[0] + 0.9
        if len(decks) > 1:
            axes.set_title(title, pad=22.0)
    figure.savefig(path, metadata=metadata, dpi=110, bbox_inches="tight", pad_inches=0.1)
    style.plt.close(figure)
