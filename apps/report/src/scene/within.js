import { Vector3 } from "three";

// Whether a point is inside an obstacle, where it is at t = 0: behind a plane, within a round shape, or surrounded by a mesh. A hollow cylinder ends where
// it is drawn.
export function isWithin(mark, point) {
  if (mark.shape === "plane") return point.clone().sub(toVector(mark.line[0])).dot(toVector(mark.normal)) < 0;
  if (mark.shape === "mesh") return isSurrounded(mark, point.toArray());
  return distanceTo(mark, point) < mark.radius;
}

const toVector = (numbers) => new Vector3(...numbers);

// From the point, the straight line or the curve about which it is round.
function distanceTo({ line, span }, point) {
  const points = line.map(toVector);
  if (points.length === 1) return point.distanceTo(points[0]);
  let least = Infinity;
  for (let i = 0; i + 1 < points.length; i++) {
    const way = points[i + 1].clone().sub(points[i]);
    const length = way.length();
    const along = point.clone().sub(points[i]).dot(way) / length;
    const [start, end] = span ?? [0, length];
    if (span && (along < start || along > end)) continue;
    const foot = points[i].clone().addScaledVector(way, Math.min(Math.max(along, start), end) / length);
    least = Math.min(least, point.distanceTo(foot));
  }
  return least;
}

// Whether triangles are on both sides of it along two of the three axes, as in a vessel that is open at its ends.
function isSurrounded({ corners, triangles }, point) {
  const axes = [0, 1, 2].filter((axis) => {
    const [across, up] = [(axis + 1) % 3, (axis + 2) % 3];
    const sides = new Set();
    for (let i = 0; i < (triangles?.length ?? 0) && sides.size < 2; i += 3) {
      const [a, b, c] = [0, 1, 2].map((j) => corners.subarray(3 * triangles[i + j], 3 * triangles[i + j] + 3));
      const cross = (p, q) => (p[across] - point[across]) * (q[up] - point[up]) - (q[across] - point[across]) * (p[up] - point[up]);
      const shares = [cross(b, c), cross(c, a), cross(a, b)];
      const area = shares[0] + shares[1] + shares[2];
      if (area === 0 || shares.some((share) => share * area < 0)) continue;
      const height = (shares[0] * a[axis] + shares[1] * b[axis] + shares[2] * c[axis]) / area;
      sides.add(height > point[axis]);
    }
    return sides.size === 2;
  });
  return axes.length >= 2;
}
