"""Random meshes of lines as Gmsh writes them: a line, a star or a closed loop of elements of order 1 to 3."""

import dataclasses

import numpy as np

GMSH_TYPES = {1: 1, 2: 8, 3: 26}


@dataclasses.dataclass
class Mesh:
    file: str
    text: str
    group: object  # the name or number of its lines
    points: list  # names of its points
    order: int
    elements: int
    length: float
    has_ends: bool  # one line: it has a start, an end and fractions


def members_of(draw, origin, length):
    """The ends of straight members, and whether they are one line."""
    kind = draw.pick(["line", "star", "loop"])
    if kind == "line":
        corner = origin + 0.5 * length * draw.direction()
        return [(origin, corner), (corner, corner + 0.5 * length * draw.direction())], True
    if kind == "star":
        return [(origin, origin + length / 3 * draw.direction()) for _ in range(3)], False
    corners = [origin, origin + length / 3 * draw.direction(), origin + length / 3 * draw.direction()]
    return [(corners[i], corners[(i + 1) % 3]) for i in range(3)], False


class Writer:
    def __init__(self, order):
        self.order = order
        self.nodes = []
        self.elements = []

    def node(self, position):
        for number, known in enumerate(self.nodes):
            if np.array_equal(known, position):
                return number + 1
        self.nodes.append(position)
        return len(self.nodes)

    def member(self, start, end, count):
        at = [start + (end - start) * i / count for i in range(count + 1)]
        at[-1] = end
        for first, last in zip(at, at[1:]):
            inner = [first + (last - first) * i / self.order for i in range(1, self.order)]
            self.elements.append([self.node(first), self.node(last), *map(self.node, inner)])

    def text(self, points, group):
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(points) + 1)]
        lines += [f'0 {number + 1} "{name}"' for number, name in enumerate(points)]
        lines += [f'1 21 "{group}"', "$EndPhysicalNames", "$Nodes", str(len(self.nodes))]
        lines += [f"{i + 1} " + " ".join(repr(float(x)) for x in node) for i, node in enumerate(self.nodes)]
        lines += ["$EndNodes", "$Elements", str(len(points) + len(self.elements))]
        lines += [f"{i + 1} 15 2 {i + 1} {node} {node}" for i, node in enumerate(points.values())]
        lines += [f"{len(points) + i + 1} {GMSH_TYPES[self.order]} 2 21 1 " + " ".join(map(str, nodes))
                  for i, nodes in enumerate(self.elements)]
        return "\n".join([*lines, "$EndElements", ""])


def make_mesh(draw, file, origin, length):
    members, is_line = members_of(draw, np.asarray(origin, float), length)
    writer = Writer(draw.integer(1, 3))
    count = draw.integer(1, 3)
    for start, end in members:
        writer.member(start, end, count)
    points = {"foot": writer.node(members[0][0]), "top": writer.node(members[-1][1 if is_line else 0])}
    if not is_line:
        points["top"] = writer.node(members[1][1])
    group = draw.pick(["net", 21])
    return Mesh(file, writer.text(points, "net"), group, list(points), writer.order, len(writer.elements),
                length, is_line)
