"""What bodies look like."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .source import read_column

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .frames import Frame
    from .source import Source

GROUP = "bodies"


@dataclass
class Outline:
    """What a body looks like: `corners` [P,3] from its node, at t = 0, in global axes; `triangles` [T,3] and `lines` [L,2] number them."""

    name: str
    point: int  # of the frames
    is_given: bool  # by `looks` in the deck; otherwise by mass, inertia, contact and joints
    corners: NDArray[np.float64]
    triangles: NDArray[np.int64]
    lines: NDArray[np.int64]

    def in_frame(self, frame: Frame) -> NDArray[np.float64]:
        """The corners [P,3] in a frame, as `results.frames[-1]`."""
        return place_corners(self.corners, frame["position"][self.point], frame["rotation_vector"][self.point])


def place_corners(corners, place, rotation_vector):
    """Corners [P,3] turned by a rotation vector [3], and moved to a place [3]."""
    angle = np.linalg.norm(rotation_vector)
    axis = rotation_vector / angle if angle > 0.0 else np.zeros(3)
    along = np.outer(corners @ axis, axis)
    return place + along + np.cos(angle) * (corners - along) + np.sin(angle) * np.cross(axis, corners)


def read_outlines(source: Source) -> dict[str, Outline]:
    """Of all bodies by their names; none of files of earlier versions."""
    def read(file):
        if GROUP not in file:
            return {}
        group = file[GROUP]
        columns = {name: group[name][()] for name in ("point", "given", "outline", "triangles", "lines", "outline_offsets", "triangle_offsets", "line_offsets")}
        part = lambda name, offsets, i: columns[name][columns[offsets][i] : columns[offsets][i + 1]]
        outlines = {}
        for i, name in enumerate(read_column(group["name"])):
            first = columns["outline_offsets"][i]
            outlines[name] = Outline(name, int(columns["point"][i]), bool(columns["given"][i]), part("outline", "outline_offsets", i),
                                     part("triangles", "triangle_offsets", i) - first, part("lines", "line_offsets", i) - first)
        return outlines

    return source.once("outlines", read)
