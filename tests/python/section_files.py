"""Small sections of plies, meshed here and written as the files of VABS and BECAS."""

from dataclasses import dataclass

import numpy as np

# (E1 E2 E3 G12 G13 G23 nu12 nu13 nu23 density) of the box X10, the pipe X9 and the square X6 of the benchmarks.
BOX = (20.59e6, 1.42e6, 1.42e6, 0.87e6, 0.87e6, 0.696e6, 0.30, 0.30, 0.34, 2.0)
PIPE = (20.59e6, 1.42e6, 1.42e6, 0.87e6, 0.87e6, 0.87e6, 0.42, 0.42, 0.42, 1.0)
SQUARE = (480.0, 120.0, 120.0, 60.0, 50.0, 60.0, 0.19, 0.19, 0.26, 1.0)


@dataclass
class Mesh:
    """Elements of order 1 or 2 (nodes from 0, corners, sides, middle), each with its material, fibre angle and the angles of its wall at the nodes, degrees."""

    nodes: list
    elements: list
    materials: list
    fibres: list
    walls: list


class Builder:
    """Quadrangles of patches: a map from the unit square, cut in both directions. Points that coincide are one node."""

    def __init__(self, order=2, with_middle=True):
        self.order, self.with_middle = order, with_middle
        self.known, self.mesh = {}, Mesh([], [], [], [], [])

    def node(self, point):
        key = tuple(np.round(point, 9) + 0.0)
        if key not in self.known:
            self.known[key] = len(self.mesh.nodes)
            self.mesh.nodes.append(point)
        return self.known[key]

    def patch(self, place, columns, rows, material, fibre, wall):
        """place(u, v): the point, counterclockwise. columns, rows: cuts from 0 to 1. wall(u, v): degrees, not in steps of 360."""
        for u0, u1 in zip(columns, columns[1:]):
            for v0, v1 in zip(rows, rows[1:]):
                spots = [(u0, v0), (u1, v0), (u1, v1), (u0, v1)]
                if self.order == 2:
                    um, vm = (u0 + u1) / 2, (v0 + v1) / 2
                    spots += [(um, v0), (u1, vm), (um, v1), (u0, vm)] + [(um, vm)] * self.with_middle
                self.mesh.elements.append([self.node(place(*spot)) for spot in spots])
                self.mesh.walls.append([wall(*spot) for spot in spots])
                self.mesh.materials.append(material)
                self.mesh.fibres.append(fibre)


def graded(count):
    """Cuts that are narrow at both ends."""
    return (1 - np.cos(np.linspace(0, np.pi, count + 1))) / 2


def square(turn=0.0, fibre=22.5, order=2, count=12):
    """A square of side 0.1 of one ply, turned with its wall by degrees from y towards z."""
    c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    builder = Builder(order)
    cuts = graded(count)
    builder.patch(lambda u, v: (0.1 * (c * (u - 0.5) - s * (v - 0.5)), 0.1 * (s * (u - 0.5) + c * (v - 0.5))), cuts, cuts, 1, fibre, lambda u, v: turn)
    return builder.mesh


def box(fibre=15.0, plies=6, along=(24, 16), with_middle=True):
    """The box X10, .953 × .53 with walls of .03 and mitred corners; walls are walked anticlockwise."""
    outer = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * (0.4765, 0.265)
    inner = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * (0.4465, 0.235)
    builder = Builder(2, with_middle)
    for side in range(4):
        a, b, c, d = outer[side], outer[(side + 1) % 4], inner[(side + 1) % 4], inner[side]
        builder.patch(lambda u, v: (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d, graded(along[side % 2]), np.linspace(0, 1, plies + 1), 1, fibre, lambda u, v: 90.0 * side)
    return builder.mesh


def pipe(across=12, along=12):
    """The pipe X9: straight walls from y −1 to 1 at z ±(.3 … .5), half circles; inner half of the wall 90°, outer 0° on the straight parts, −45° and 45° on the arcs."""
    builder = Builder(2)
    halves = ((np.linspace(0, 0.5, across // 2 + 1), 0.0, 45.0), (np.linspace(0.5, 1, across // 2 + 1), 90.0, -45.0))
    for sign, turn in ((1, 0.0), (-1, 180.0)):  # below and at the right, above and at the left
        for cuts, straight, round in halves:
            builder.patch(lambda u, v: (sign * (2 * u - 1), -sign * (0.5 - 0.2 * v)), graded(along), cuts, 1, straight, lambda u, v: turn)
            arc = lambda u: np.pi * u - np.pi / 2
            builder.patch(lambda u, v: (sign * (1 + (0.5 - 0.2 * v) * np.cos(arc(u))), sign * (0.5 - 0.2 * v) * np.sin(arc(u))), np.linspace(0, 1, along + 1), cuts, 1, round,
                          lambda u, v: turn + 180.0 * u)
    return builder.mesh


# Files

def row(values):
    return " ".join(f"{each:.15g}" for each in values)


def nine(nodes):
    """The nodes of an element in VABS's nine places."""
    spots = [node + 1 for node in nodes]
    if len(spots) in (3, 6):
        spots = [*spots[:3], 0, *spots[3:]]
    return spots + [0] * (9 - len(spots))


def vabs_material(number, values):
    return [f"{number} 1", row(values[:3]), row(values[3:6]), row(values[6:9]), row(values[9:])]


def write_vabs(path, mesh, materials, new=True, by_node=False):
    """The new format, with layers and one wall angle for each element, or the old one; by_node: angles at nodes."""
    pairs = sorted(set(zip(mesh.materials, mesh.fibres)))
    middle = [walls[-1] if len(walls) == 9 else float(np.mean(walls)) for walls in mesh.walls]
    lines = [f"{int(new)} {len(pairs)}", "1 0 0", "0 0 0 0", "", f"{len(mesh.nodes)} {len(mesh.elements)} {len(materials)}", ""]
    lines += [f"{i} {row(node)}" for i, node in enumerate(mesh.nodes, 1)]
    lines += [f"{i} {row(nine(nodes))}" for i, nodes in enumerate(mesh.elements, 1)] + [""]
    for i, (material, fibre, walls) in enumerate(zip(mesh.materials, mesh.fibres, mesh.walls), 1):
        if new:
            lines.append(f"{i} {pairs.index((material, fibre)) + 1} {middle[i - 1]:.15g}")
        else:
            angles = (list(walls) if by_node else [middle[i - 1], 540]) + [0] * 9
            lines.append(f"{i} {material} {fibre:g} {row(angles[:9])}")
    if new:
        lines += [""] + [f"{i} {material} {fibre:g}" for i, (material, fibre) in enumerate(pairs, 1)]
    for i, values in enumerate(materials, 1):
        lines += ["", *vabs_material(i, values)]
    path.write_text("\n".join(lines) + "\n")
    return path


def write_becas(folder, mesh, materials):
    folder.mkdir(exist_ok=True)
    tables = {"N2D.in": [(i, *node) for i, node in enumerate(mesh.nodes, 1)],
              "E2D.in": [(i, *(node + 1 for node in nodes[:8]), *[0] * (8 - min(len(nodes), 8))) for i, nodes in enumerate(mesh.elements, 1)],
              "EMAT.in": [(i, material, fibre, walls[-1] if len(walls) == 9 else np.mean(walls)) for i, (material, fibre, walls) in enumerate(zip(mesh.materials, mesh.fibres, mesh.walls), 1)],
              "MATPROPS.in": materials}
    for name, rows in tables.items():
        (folder / name).write_text("".join(row(each) + "\n" for each in rows))
    return folder
