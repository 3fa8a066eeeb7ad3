"""Meshes the section of a blade: a wall of layers round an airfoil, from its surface inwards, and webs across.

The outline is walked from the trailing edge over the suction side, round the leading edge and back on the pressure side, as windIO does; s goes from 0 to 1
along it. Layers that begin or end do so over a short ramp, in which they become triangles. Where the walls of both sides meet, towards the trailing edge,
they end at the middle between them and are joined there; if they do not meet, the wall goes on across the blunt edge.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..typed import Array
from .section_mesh import SectionLayer, SectionMesh

CELLS = 160  # round the outline, about
RAMP, LONGEST_RAMP = 2.0, 0.003  # length of a ramp over the thickness of its layer, and over the length of the outline at most
JOINED = 0.5  # of the chord, behind which both sides have nodes at the same place along it
FREE = 0.9  # of the radius of the largest circle inside, which walls may fill elsewhere
NEAR = 1e-9  # coordinates, over the length of the outline, nearer than that are one


@dataclass
class WallLayer:
    """A layer of the wall between `start` and `end` along the outline, or of a web."""

    layer: int  # an index in the layers of the section
    thickness: float
    start: float = 0.0
    end: float = 1.0


@dataclass
class Web:
    """Layers across, from the leading edge to the trailing one, between two places of the outline."""

    start: float
    end: float
    layers: list[WallLayer] = field(default_factory=list)

    @property
    def thickness(self) -> float:
        return sum(layer.thickness for layer in self.layers)


class Outline:
    """A polygon [n,2], from the trailing edge over the suction side and back, by s."""

    def __init__(self, points: Array) -> None:
        self.points = points
        lengths = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))))
        self.length, self.s = float(lengths[-1]), lengths / lengths[-1]
        self.nose = int(np.argmin(points[:, 1]))
        self.chord = float(np.ptp(points[:, 1]))
        # A circle, or a blunt trailing edge: the wall goes on round it. Else both sides end at it.
        self.is_ring = float(np.dot(points[1] - points[0], points[-1] - points[-2])) > 0.0

        self.tangents = self.find_tangents()

    def find_tangents(self) -> Array:
        """Unit tangents at the points, of the circle through a point and its neighbours; at ends those of the last sides."""
        sides = np.diff(self.points, axis=0)
        lengths = np.linalg.norm(sides, axis=1)
        before, after = np.arange(len(sides) + 1) - 1, np.arange(len(sides) + 1)
        before[0], after[-1] = (len(sides) - 1, 0) if self.is_ring else (0, len(sides) - 1)
        tangents = (sides[before] / lengths[before, None]) * lengths[after, None] + (sides[after] / lengths[after, None]) * lengths[before, None]
        return tangents / np.linalg.norm(tangents, axis=1)[:, None]

    def at(self, s: Array) -> Array:
        """Points at places along it."""
        return np.stack([np.interp(s, self.s, column) for column in self.points.T], axis=1)

    def inward(self, s: Array) -> Array:
        """Unit normals, inwards."""
        along = np.stack([np.interp(s, self.s, column) for column in self.tangents.T], axis=1)
        along /= np.linalg.norm(along, axis=1)[:, None]
        return np.stack([along[:, 1], -along[:, 0]], axis=1)

    def rooms(self, s: Array) -> Array:
        """The radius of the largest circle that touches at each place and lies inside."""
        at, normal = self.at(s), self.inward(s)
        across = self.points[None] - at[:, None]
        depth = np.einsum("ijk,ik->ij", across, normal)
        square = np.sum(across**2, axis=2)
        return np.min(np.where(depth > 1e-6 * self.chord, square / np.maximum(2.0 * depth, 1e-300), np.inf), axis=1)

    def opposite(self, s: Array) -> Array:
        """The place on the other side that is as far from the leading edge along the chord."""
        z = self.at(s)[:, 1]
        upper, lower = self.points[: self.nose + 1], self.points[self.nose:]
        to_upper = np.interp(z, upper[::-1, 1], self.s[self.nose::-1])
        to_lower = np.interp(z, lower[:, 1], self.s[self.nose:])
        return np.where(s < self.s[self.nose], to_lower, to_upper)


class AirfoilMesher:
    def __init__(self, outline: Outline, walls: list[WallLayer], webs: list[Web]) -> None:
        self.outline, self.walls, self.webs = outline, walls, webs
        self.nodes: list[Array] = []
        self.known: dict[tuple[int, int], int] = {}
        self.elements: list[Array] = []
        self.element_layers: list[int] = []
        self.angles: list[Array] = []
        edge = sum(layer.thickness for layer in walls if layer.start <= 0.0)
        self.is_blunt = not outline.is_ring and edge < 0.45 * float(np.linalg.norm(outline.points[0] - outline.points[-1]))
        self.edge = edge / outline.length if self.is_blunt else 0.0

    def make(self, title: str, source: str, layers: list[SectionLayer]) -> SectionMesh:
        feet = [self.feet_of(web) for web in self.webs]
        edges = self.shift_edges([foot for pair in feet for foot in pair])
        s = self.place_columns(feet, edges)
        interfaces = self.lay_interfaces(s, edges)
        self.add_walls(interfaces)
        for web, (first, second) in zip(self.webs, feet):
            self.add_web(web, *(interfaces[[int(np.argmin(np.abs(s - place))) for place in foot], -1] for foot in (first, second)))
        used, elements = np.unique(np.concatenate(self.elements), return_inverse=True)
        cuts = np.cumsum([len(element) for element in self.elements])[:-1]
        return SectionMesh(title, source, np.array(self.nodes)[used], np.split(elements, cuts), self.element_layers, self.angles, layers)

    # Places along the outline

    def feet_of(self, web: Web) -> tuple[Array, Array]:
        """Places of the interfaces of a web at its two ends, from its side to the leading edge on."""
        depths = np.concatenate(([0.0], np.cumsum([layer.thickness for layer in web.layers])))
        across = 0.5 * web.thickness - depths
        first, second = self.outline.at(np.array([web.start, web.end]))
        normal = np.array([first[1] - second[1], second[0] - first[0]]) / np.linalg.norm(second - first)
        normal *= -np.sign(normal[1])  # towards the leading edge
        return tuple(self.foot_at(place, normal, float(np.dot(point, normal)) + across) for place, point in ((web.start, first), (web.end, second)))

    def foot_at(self, place: float, normal: Array, wanted: Array) -> Array:
        """Places near one of the outline whose points on the inner surface are at wanted distances along a direction."""
        depth = sum(layer.thickness for layer in self.walls if layer.start < place < layer.end)
        along = lambda s: (self.outline.at(s) + depth * self.outline.inward(s)) @ normal
        step = 0.5 / len(self.outline.s)
        places = np.full(len(wanted), place)
        for _ in range(4):
            places = places + (wanted - along(places)) / ((along(places + step) - along(places - step)) / (2.0 * step))
        return places

    def shift_edges(self, feet: list[Array]) -> list[tuple[float, float, float]]:
        """Start, end and half the length of the ramps of each layer of the wall; ramps are moved out of the feet of webs."""
        return [(self.shift(layer.start, half, feet), self.shift(layer.end, half, feet), half)
                for layer in self.walls for half in [0.5 * min(RAMP * layer.thickness / self.outline.length, LONGEST_RAMP)]]

    @staticmethod
    def shift(edge: float, half: float, feet: list[Array]) -> float:
        for foot in feet:
            low, high = foot.min() - 1.1 * half, foot.max() + 1.1 * half
            if low < edge < high:
                return low if edge - low < high - edge else high
        return edge

    def place_columns(self, feet: list[tuple[Array, Array]], edges: list[tuple[float, float, float]]) -> Array:
        """Ends of ramps, feet of webs, and others between them; none else within feet. Near the trailing edge both sides have the same."""
        fixed = [0.0, 1.0, float(self.outline.s[self.outline.nose])]
        for start, end, half in edges:
            fixed += [place for edge in (start, end) if 0.0 < edge < 1.0 for place in (edge - half, edge + half)]
        spans = [foot for pair in feet for foot in pair]
        outside = lambda places: np.array([place for place in places if not any(foot.min() - NEAR < place < foot.max() + NEAR for foot in spans)])
        part = np.linspace(0.0, 1.0, CELLS // 2 + 1)
        half = 0.125 * (1.0 - np.cos(np.pi * part)) + 0.25 * part  # denser at both edges of the airfoil
        even = np.concatenate((half, 1.0 - half[::-1]))
        places = self.thin_out(np.array(sorted(fixed + [place for foot in spans for place in foot])), outside(even))
        places = places[(places == 0.0) | (places == 1.0) | (np.minimum(places, 1.0 - places) > 1.5 * self.edge)]
        behind = places[self.outline.at(places)[:, 1] > self.outline.points[self.outline.nose, 1] + JOINED * self.outline.chord]
        return self.thin_out(places, outside(self.outline.opposite(behind)), exact=True)

    def thin_out(self, fixed: Array, others: Array, exact: bool = False) -> Array:
        """Fixed places with those of others that are not next to one."""
        fixed = fixed[np.concatenate(([True], np.diff(fixed) > NEAR))]
        gap = NEAR if exact else 0.3 / CELLS
        kept = [place for place in others if np.min(np.abs(fixed - place)) > gap]
        return np.sort(np.concatenate((fixed, kept)))

    # The wall

    def lay_interfaces(self, s: Array, edges: list[tuple[float, float, float]]) -> Array:
        """Nodes [columns, layers + 1] of the interfaces, the outer surface first; layers that are not there have none of their own."""
        thickness = np.stack([layer.thickness * self.presence(s, *edge) for layer, edge in zip(self.walls, edges)], axis=1)
        depths = np.concatenate((np.zeros((len(s), 1)), np.cumsum(thickness, axis=1)), axis=1)
        at, way, room, is_joined = self.find_ways(s)
        depths = np.minimum(depths, room[:, None])
        nodes = np.zeros(depths.shape, dtype=int)
        for i in range(len(s)):
            if self.outline.is_ring and i == len(s) - 1:
                nodes[i] = nodes[0]
                break
            for k, depth in enumerate(depths[i]):
                if k and depth - depths[i, k - 1] < NEAR * self.outline.length:
                    nodes[i, k] = nodes[i, k - 1]
                else:
                    nodes[i, k] = self.node_at(at[i] + depth * way[i], shared=bool(is_joined[i] and depth > room[i] - NEAR * self.outline.length))
        return nodes

    @staticmethod
    def presence(s: Array, start: float, end: float, half: float) -> Array:
        """1 where a layer is, 0 where it is not, straight in between."""
        rise = np.ones_like(s) if start <= half else np.clip((s - start + half) / (2.0 * half), 0.0, 1.0)
        fall = np.ones_like(s) if end >= 1.0 - half else np.clip((end + half - s) / (2.0 * half), 0.0, 1.0)
        return np.minimum(rise, fall)

    def find_ways(self, s: Array) -> tuple[Array, Array, Array, Array]:
        """Places, directions inwards, how far walls may reach, and whether both sides meet there: at the middle between them."""
        at, normal = self.outline.at(s), self.outline.inward(s)
        middle = 0.5 * (at + self.outline.at(self.outline.opposite(s)))
        half = np.linalg.norm(middle - at, axis=1)
        is_behind = (not self.outline.is_ring) & (at[:, 1] > self.outline.points[self.outline.nose, 1] + JOINED * self.outline.chord)
        across = np.where(half[:, None] > 0.0, (middle - at) / np.maximum(half, 1e-300)[:, None], normal)
        # From the normals to the way across, over a tenth of the chord.
        part = np.clip((at[:, 1] - self.outline.points[self.outline.nose, 1] - JOINED * self.outline.chord) / (0.1 * self.outline.chord), 0.0, 1.0) * is_behind
        is_behind &= part >= 1.0
        way = (1.0 - part)[:, None] * normal + part[:, None] * across
        way /= np.linalg.norm(way, axis=1)[:, None]
        if self.is_blunt:  # mitred with the wall across
            way[[0, -1]] = across[[0, -1]] - [0.0, 1.0]
        return at, way, np.where(is_behind, half, FREE * self.outline.rooms(s)), is_behind

    def node_at(self, point: Array, shared: bool) -> int:
        """A node; shared ones are known by their place."""
        key = tuple(np.round(point / (1e-7 * self.outline.length)).astype(int)) if shared else None
        if key in self.known:
            return self.known[key]
        self.nodes.append(point)
        if key is not None:
            self.known[key] = len(self.nodes) - 1
        return len(self.nodes) - 1

    def add_walls(self, nodes: Array) -> None:
        columns = np.concatenate((nodes, nodes[:1])) if self.is_blunt else nodes
        for here, there in zip(columns, columns[1:]):
            back = self.nodes[here[0]] - self.nodes[there[0]]  # anticlockwise
            for k, layer in enumerate(self.walls):
                self.add_cell([there[k], here[k], here[k + 1], there[k + 1]], layer.layer, back)

    def add_cell(self, corners: list[int], layer: int, wall: Array) -> None:
        """A quadrangle, or what is left of it where corners are one; wall: its direction, so that the normal x × t points inwards."""
        element = np.array(list(dict.fromkeys(int(corner) for corner in corners)))
        if len(element) < 3:
            return
        self.elements.append(element)
        self.element_layers.append(layer)
        self.angles.append(np.array([np.arctan2(wall[1], wall[0])]))

    # Webs

    def add_web(self, web: Web, first: Array, second: Array) -> None:
        """Columns of quadrangles between nodes on the inner surfaces of both sides."""
        ends = np.array([[self.nodes[a], self.nodes[b]] for a, b in zip(first, second)])
        height = float(np.linalg.norm(ends[0, 0] - ends[0, 1]))
        rows = max(8, int(round(CELLS * height / self.outline.length)))
        grid = np.zeros((len(first), rows + 1), dtype=int)
        for q, (a, b) in enumerate(ends):
            inner = [self.node_at(a + (b - a) * j / rows, shared=False) for j in range(1, rows)]
            grid[q] = [first[q], *inner, second[q]]
        for q, layer in enumerate(web.layers):
            for j in range(rows):
                self.add_cell([grid[q, j], grid[q + 1, j], grid[q + 1, j + 1], grid[q, j + 1]], layer.layer, ends[q, 1] - ends[q, 0])
