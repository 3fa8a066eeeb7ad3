"""Random centrelines of about a given length, with their ends; and meshes of lines."""

import dataclasses

import numpy as np

from draw import floats


@dataclasses.dataclass
class Centreline:
    keys: dict  # of a [rod.NAME]
    start: np.ndarray
    end: np.ndarray
    length: float  # about
    pieces: int = 1  # elements at least
    is_straight: bool = False


def turn(axis, angle, vector):
    """The vector turned about a unit axis."""
    along = axis * axis.dot(vector)
    return along + np.cos(angle) * (vector - along) + np.sin(angle) * np.cross(axis, vector)


def across(draw, axis):
    """A unit vector at right angles to a unit vector."""
    vector = np.cross(axis, draw.direction())
    return vector / np.linalg.norm(vector)


def along_axes(draw):
    """A direction, as often as not one of the global axes, as users' models have."""
    if draw.chance(0.5):
        return draw.direction()
    axis = np.zeros(3)
    axis[draw.integer(0, 2)] = draw.pick([-1.0, 1.0])
    return axis


def line(draw, start, length):
    end = start + length * along_axes(draw)
    return straight(draw, start, end)


def straight(draw, start, end):
    keys = {"line": {"from": floats(start), "to": floats(end)}}
    return Centreline(keys, start, end, float(np.linalg.norm(end - start)), is_straight=True)


def pieces_of(angle):
    """Elements in which a curve turns by less than half a turn."""
    return int(abs(angle) / 3.0) + 1


def arc(draw, start, length):
    axis = along_axes(draw)
    angle = draw.pick([-1, 1]) * draw.pick([draw.uniform(0.01, 2 * np.pi), 2 * np.pi, np.pi])
    radius = length / abs(angle)
    centre = start - radius * across(draw, axis)
    end = centre + turn(axis, angle, start - centre)
    if draw.chance(0.5) and abs(angle) < 6.0:
        through = centre + turn(axis, angle * draw.uniform(0.3, 0.7), start - centre)
        keys = {"arc": {"from": floats(start), "through": floats(through),
                        "to": floats(end)}}
    else:
        keys = {"arc": {"centre": floats(centre), "axis": floats(axis * draw.log_uniform(0.1, 10)),
                        "from": floats(start), "angle": float(angle)}}
    return Centreline(keys, start, end, length, pieces=pieces_of(angle))


def helix(draw, start, length):
    axis = along_axes(draw)
    turns = draw.pick([-1, 1]) * draw.log_uniform(0.1, 3.0)
    radius = length / (2 * np.pi * abs(turns)) * draw.uniform(0.3, 0.95)
    pitch = draw.pick([-1, 1]) * np.sqrt((length / turns) ** 2 - (2 * np.pi * radius) ** 2)
    centre = start - radius * across(draw, axis)
    angle = 2 * np.pi * turns
    end = centre + turn(axis, angle, start - centre) + abs(turns) * pitch * axis
    keys = {"helix": {"centre": floats(centre), "axis": floats(axis), "from": floats(start),
                      "turns": float(turns), "pitch": float(pitch)}}
    return Centreline(keys, start, end, length, pieces=pieces_of(angle))


def points_along(draw, start, length, count):
    """Points whose chords lean by less than a right angle or so."""
    direction = along_axes(draw)
    points = [start]
    for _ in range(count):
        points.append(points[-1] + length / count * draw.uniform(0.5, 1.5) * direction)
        direction = direction + draw.vector(0.4)
        direction /= np.linalg.norm(direction)
    return points


def polyline(draw, start, length):
    points = points_along(draw, start, length, draw.integer(1, 3))
    return Centreline({"polyline": [floats(point) for point in points]}, start, points[-1], length,
                      pieces=len(points) - 1)


def spline(draw, start, length):
    points = points_along(draw, start, length, draw.integer(1, 5))
    return Centreline({"spline": [floats(point) for point in points]}, start, points[-1], length)


SHAPES = {line: 5, arc: 3, helix: 2, polyline: 2, spline: 2}


def centreline(draw, start, length):
    return draw.weighted(SHAPES)(draw, np.asarray(start, float), length)
