#!/usr/bin/env python3
"""Writes vessel.stl: a straight tube that bends by 90 degrees in a plane, then by 90 degrees out of it, in mm."""

import math
import pathlib
import struct

BORE = 2.0  # radius
FACETS = 24  # around
# Along the centreline: length or radius, angle, rings, and the axis of the frame about which it bends.
PIECES = [(60.0, 0.0, 8, None), (30.0, math.pi / 2, 20, 2), (25.0, math.pi / 2, 20, 1), (10.0, 0.0, 2, None)]


def add(*terms):
    """The sum of factors times vectors."""
    return tuple(sum(factor * vector[i] for factor, vector in terms) for i in range(3))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def centreline():
    """Points of the centreline, each with its tangent and two normals."""
    point, frame = (-60.0, 0.0, 0.0), [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
    yield point, frame
    for size, angle, count, axis in PIECES:
        for _ in range(count):
            if axis is None:
                point = add((1, point), (size / count, frame[0]))
            else:
                cosine, sine = math.cos(angle / count), math.sin(angle / count)
                about, tangent = frame[axis], frame[0]
                inwards = cross(about, tangent)
                point = add((1, point), (size * sine, tangent), (size * (1 - cosine), inwards))
                frame = [add((cosine, v), (sine, cross(about, v))) if v is not about else v for v in frame]
            yield point, frame


def main():
    angles = [2 * math.pi * i / FACETS for i in range(FACETS)]
    rings = [
        [add((1, point), (BORE * math.cos(a), frame[1]), (BORE * math.sin(a), frame[2])) for a in angles]
        for point, frame in centreline()
    ]
    triangles = []
    for one, other in zip(rings, rings[1:]):
        for i in range(FACETS):
            j = (i + 1) % FACETS
            triangles += [(one[i], other[i], other[j]), (one[i], other[j], one[j])]
    with open(pathlib.Path(__file__).parent / "vessel.stl", "wb") as file:
        file.write(b"a bent vessel, in mm".ljust(80) + struct.pack("<I", len(triangles)))
        for a, b, c in triangles:
            normal = cross(add((1, b), (-1, a)), add((1, c), (-1, a)))
            size = math.hypot(*normal)
            file.write(struct.pack("<12fH", *(x / size for x in normal), *a, *b, *c, 0))


if __name__ == "__main__":
    main()
