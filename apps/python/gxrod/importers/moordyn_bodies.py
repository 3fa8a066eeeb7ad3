"""Free bodies of MoorDyn's files, and rods as rigid bodies: mass, volume, drag and added mass of what is fixed to them, summed up."""

from __future__ import annotations

from dataclasses import replace
from math import acos, atan2, dist, pi

import numpy as np

from ..typed import Array
from .mooring import Body, Vector

ROUND = 0.4  # of a homogeneous sphere: its moment of inertia over mass times radius squared
LEAST = 1e-3  # kg or m, where a file has nothing


def vector_of(values: Array) -> Vector:
    x, y, z = values.tolist()
    return x, y, z


def cylinder(name: str, ends: tuple[Vector, Vector], diameter: float, mass: float, drag: tuple[float, float], added: tuple[float, float], density: float) -> Body:
    """A rod of MoorDyn about its middle, x along it. `mass`: per length. `drag`, `added`: coefficients across the rod and at its ends."""
    length = dist(*ends)
    face, volume = pi / 4 * diameter**2, pi / 4 * diameter**2 * length
    across = mass * length * (length**2 / 12 + diameter**2 / 16)
    area, water = drag[0] * diameter * length, added[0] * density * volume
    caps = added[1] * density * pi / 12 * diameter**3 * 2  # two half spheres
    start, end = map(np.array, ends)
    return Body(name, vector_of((start + end) / 2), mass * length, (mass * length * diameter**2 / 8, across, across), volume=volume, drag_area=(drag[1] * face, area, area),
                added_mass=(caps, water, water), rotation_vector=vector_of(turn_to((end - start) / length)))


def turn_to(direction: Array) -> Array:
    """The rotation vector from x to a direction."""
    axis = np.cross([1.0, 0.0, 0.0], direction)
    size = float(np.linalg.norm(axis))
    if size < 1e-12:
        return np.array([0.0, 0.0, 0.0 if direction[0] > 0.0 else pi])
    return axis / size * acos(max(-1.0, min(1.0, float(direction[0]))))


def point_mass(at: Vector, mass: float, volume: float, drag_area: float, added_mass: float, density: float) -> Body:
    water = added_mass * density * volume
    return Body("", at, mass, volume=volume, drag_area=(drag_area,) * 3, added_mass=(water,) * 3)


def rotation_of(body: Body) -> Array:
    """Columns: its axes."""
    return rotation_by(np.array(body.rotation_vector))


def euler_rotation(roll: float, pitch: float, yaw: float) -> Array:
    """The rotation by MoorDyn's angles in rad: about x, then about the new y, then about the new z."""
    return rotation_by(np.array([roll, 0.0, 0.0])) @ rotation_by(np.array([0.0, pitch, 0.0])) @ rotation_by(np.array([0.0, 0.0, yaw]))


def rotation_vector_of(rotation: Array) -> Vector:
    """The rotation vector of a rotation matrix, by its quaternion."""
    whole = 1.0 + np.array([np.trace(rotation), *(2.0 * np.diag(rotation) - np.trace(rotation))])  # four times the squares
    largest = int(np.argmax(whole))
    skew = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]])
    if largest == 0:
        quaternion = np.array([whole[0], *skew])
    else:
        column = rotation[:, largest - 1] + rotation[largest - 1]
        column[largest - 1] = whole[largest]
        quaternion = np.array([skew[largest - 1], *column])
    quaternion *= (1.0 if quaternion[0] >= 0.0 else -1.0) / np.linalg.norm(quaternion)
    sine = float(np.linalg.norm(quaternion[1:]))
    angle = 2.0 * atan2(sine, float(quaternion[0]))
    return vector_of(quaternion[1:] * (angle / sine if sine > 0.0 else 2.0))


def rotation_by(vector: Array) -> Array:
    """The rotation matrix of a rotation vector."""
    angle = float(np.linalg.norm(vector))
    if angle == 0.0:
        return np.eye(3)
    x, y, z = vector / angle
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * skew + (1.0 - np.cos(angle)) * skew @ skew


def along_axes(values: Vector, axes: Array) -> Array:
    """The diagonal of a tensor whose own axes are the columns, in which it is diagonal."""
    return np.diag(axes @ np.diag(values) @ axes.T)


def joined(body: Body, other: Body) -> Body:
    """A body with another one fixed to it, in its own axes. Of tensors the diagonals are summed; buoyancy stays at the body's point."""
    own = rotation_of(body)
    axes, apart = own.T @ rotation_of(other), own.T @ (np.array(other.at) - np.array(body.at))
    mass = body.mass + other.mass
    first, second = np.array(body.centre_of_mass), apart + axes @ np.array(other.centre_of_mass)
    centre = (body.mass * first + other.mass * second) / mass if mass > 0.0 else first
    inertia = np.array(body.inertia) + along_axes(other.inertia, axes)
    for part, at in ((body.mass, first - centre), (other.mass, second - centre)):
        inertia = inertia + part * (at @ at - at**2)
    sums = {key: vector_of(np.array(getattr(body, key)) + along_axes(getattr(other, key), axes)) for key in ("drag_area", "added_mass")}
    return replace(body, mass=mass, inertia=vector_of(inertia), centre_of_mass=vector_of(centre), volume=body.volume + other.volume, **sums)


def completed(body: Body, density: float) -> tuple[Body, str]:
    """With mass and inertia to move with, where the file has none; and what was taken."""
    if body.mass > 0.0 and min(body.inertia) > 0.0:
        return body, ""
    mass = body.mass if body.mass > 0.0 else max(LEAST * density * body.volume, LEAST)
    radius = max((0.75 * body.volume / pi) ** (1.0 / 3.0), LEAST)
    whole = [each if each > 0.0 else ROUND * mass * radius**2 for each in body.inertia]
    return (replace(body, mass=mass, inertia=(whole[0], whole[1], whole[2])),
            f"{body.name} has no mass or no inertia in the file: taken are {mass:.4g} kg, at least a thousandth of its water, and the inertia of a sphere of its volume")
