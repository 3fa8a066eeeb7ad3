"""Whether rods of a results file intersect, by ipctk, which knows nothing of gxrod."""

import collections

import h5py
import ipctk
import numpy as np

PARTS = 6  # segments of an element


class Lines:
    """The lines of all rods, cut into segments: positions of a frame, ends of segments, rods, arc lengths."""

    def __init__(self, file):
        vtk = file["VTKHDF"]
        cells = vtk["Connectivity"][()].reshape(-1, 3)  # start, end, middle
        self.points, self.offsets = vtk["Points"], vtk["Steps/PointOffsets"][()]
        self.count = vtk["PointData/rod"].shape[0]
        xi = np.linspace(-1, 1, PARTS + 1)
        shapes = np.stack([0.5 * xi * (xi - 1), 0.5 * xi * (xi + 1), 1 - xi * xi])
        self.cells, self.shapes = cells, shapes
        arc = vtk["PointData/arc_length"][()][: self.count]
        ends = np.einsum("ci,ij->cj", arc[cells], shapes)
        self.arc = 0.5 * (ends[:, :-1] + ends[:, 1:]).ravel()
        self.rod = np.repeat(vtk["CellData/rod"][()][: len(cells)], PARTS)
        self.radius = np.repeat(vtk["CellData/radius"][()][: len(cells)], PARTS)

    def segments(self, frame):
        first = int(self.offsets[frame])
        nodes = self.points[first:first + self.count]
        places = np.einsum("cik,ij->cjk", nodes[self.cells], self.shapes)
        starts, ends = places[:, :-1].reshape(-1, 3), places[:, 1:].reshape(-1, 3)
        # How far the line bulges out of its chords: an eighth of the second difference.
        second = nodes[self.cells[:, 0]] + nodes[self.cells[:, 1]] - 2 * nodes[self.cells[:, 2]]
        bulge = np.repeat(np.linalg.norm(second, axis=1) * 4 / PARTS**2 / 8, PARTS)
        return starts, ends, bulge


def tightest_bend(lines, starts, ends):
    """Its radius, in radii of the rod."""
    along = ends - starts
    length = np.linalg.norm(along, axis=1)
    along = along / length[:, None]
    turn = np.arccos(np.clip(np.sum(along[1:] * along[:-1], axis=1), -1, 1)) * (lines.rod[1:] == lines.rod[:-1])
    return 1 / max(float(np.max(turn * lines.radius[1:] / (0.5 * (length[1:] + length[:-1])))), 1e-9)


def _near(lines, starts, ends, reach, bend):
    """Pairs of segments that may be within reach, but for neighbours on a rod, and all of a rod that is bent as tightly as it is thick."""
    middles, halves = 0.5 * (starts + ends), 0.5 * np.linalg.norm(ends - starts, axis=1)
    # Neighbours as the rod is: pressed together, it is thicker than what was apart is far.
    arc = np.cumsum(2.0 * halves) - halves
    for first in range(len(middles)):
        distance = np.linalg.norm(middles[first + 1:] - middles[first], axis=1)
        others = first + 1 + np.flatnonzero(distance < halves[first] + halves[first + 1:] + reach)
        for second in others:
            same = lines.rod[first] == lines.rod[second]
            if same and bend < 2:
                continue
            apart = abs(arc[first] - arc[second]) - halves[first] - halves[second]
            if not same or apart > np.pi * lines.radius[first]:
                yield first, second


def least_gaps(path, obstacles=()):
    """Of each frame the least gap between rods, and to obstacles, and by how much these may be off: segments are chords, and rods touch as
    straight pieces that stay within a quarter of a skin of them at a bend of 10 radii."""
    rows = []
    with h5py.File(path) as file:
        lines = Lines(file)
        for frame in range(len(lines.offsets)):
            starts, ends, bulge = lines.segments(frame)
            gap, off, bend = np.inf, 0.0, tightest_bend(lines, starts, ends)
            for a, b in _near(lines, starts, ends, 2.2 * lines.radius.max(), bend):
                d = np.sqrt(ipctk.edge_edge_distance(starts[a], ends[a], starts[b], ends[b])) - lines.radius[a] - lines.radius[b]
                if d < gap:
                    gap, off = d, bulge[a] + bulge[b] + 0.01 * lines.radius[a] * max(1, 10 / bend)
            kinks = 0.005 * lines.radius.max() * max(1, 10 / bend)
            # On planes elements touch at their nodes alone, half an element apart: between them the line may bulge.
            rows.append((gap, off, *min(((_obstacle_gap(each, starts, ends, lines.radius), kinks + bulge.max() * (PARTS**2 / 4 if each[0] == "plane" else 1))
                                         for each in obstacles), key=sum, default=(np.inf, 0.0))))
    return rows


def _obstacle_gap(obstacle, starts, ends, radius):
    if obstacle[0] == "plane":
        return float(np.min(np.minimum(starts[:, 2], ends[:, 2]) - obstacle[1] - radius))
    if obstacle[0] == "sphere":
        centre = np.array(obstacle[1])
        return min(np.sqrt(ipctk.point_edge_distance(centre, a, b)) - obstacle[2] - r for a, b, r in zip(starts, ends, radius))
    low, high = np.array(obstacle[1]), np.array(obstacle[2])
    return min(np.sqrt(ipctk.edge_edge_distance(a, b, low, high)) - obstacle[3] - r for a, b, r in zip(starts, ends, radius))


def crossings(path):
    """Pairs of rods whose lines cross on straight ways from a frame to the next, (frame, rod, rod), but for segments that are so near to the
    end of a rod that they can have gone around it. Rods bend on their ways: what crosses twice is on its side again."""
    found = []
    ccd = ipctk.TightInclusionCCD()
    with h5py.File(path) as file:
        lines = Lines(file)
        before = lines.segments(0)
        last = np.array([lines.arc[lines.rod == rod].max() for rod in lines.rod])
        to_ends = np.minimum(lines.arc, last - lines.arc)
        for frame in range(1, len(lines.offsets)):
            now = lines.segments(frame)
            times = collections.defaultdict(list)
            low = np.minimum(np.minimum(before[0], before[1]), np.minimum(now[0], now[1]))
            high = np.maximum(np.maximum(before[0], before[1]), np.maximum(now[0], now[1]))
            for a in range(len(low)):
                boxes = np.all((low[a + 1:] <= high[a]) & (high[a + 1:] >= low[a]), axis=1)
                for b in a + 1 + np.flatnonzero(boxes):
                    if lines.rod[a] == lines.rod[b] and abs(lines.arc[a] - lines.arc[b]) < 8 * lines.radius[a] + np.linalg.norm(now[1][a] - now[0][a]):
                        continue
                    moved = max(np.linalg.norm(now[0][each] - before[0][each]) for each in (a, b))
                    if min(to_ends[a], to_ends[b]) < moved:
                        continue
                    hit = ccd.edge_edge_ccd(before[0][a], before[1][a], before[0][b], before[1][b], now[0][a], now[1][a], now[0][b], now[1][b])
                    if hit[0]:
                        times[int(lines.rod[a]), int(lines.rod[b])].append(hit[1])
            # At the end of a segment the next one meets at the same time.
            found += [(frame, *rods) for rods, of_pair in times.items() if (1 + np.sum(np.diff(np.sort(of_pair)) > 5e-3)) % 2]
            before = now
    return found
