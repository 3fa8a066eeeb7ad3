import { BufferAttribute, BufferGeometry, Quaternion, Vector3 } from "three";
import { decode } from "../data.js";

// What the deck says that bodies look like, of all bodies in three blocks.
export class Outlines {
  constructor(bodies) {
    if (!bodies.some(({ outline }) => outline)) return;
    this.points = decode("outline-points", Float32Array);
    this.triangles = decode("outline-triangles", Int32Array);
    this.lines = decode("outline-lines", Int32Array);
  }

  // Geometries in body axes from the node, and the box around them: sides, middle, and how far the farthest corner is from the centre of mass; null where
  // the deck says nothing.
  of({ outline, centre }) {
    if (!outline) return null;
    const [points, triangles, lines] = outline;
    const corners = new BufferAttribute(this.points.slice(3 * points[0], 3 * points[1]), 3);
    const make = (numbers, size, [first, end]) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", corners);
      geometry.setIndex(new BufferAttribute(new Uint32Array(numbers.subarray(size * first, size * end)), 1));
      return geometry;
    };
    // Corners of their own for each triangle: edges are sharp.
    const surface = make(this.triangles, 3, triangles).toNonIndexed();
    surface.computeVertexNormals();
    const edges = make(this.lines, 2, lines);
    edges.computeBoundingBox();
    const box = edges.boundingBox; // of all corners
    const mass = new Vector3(...centre);
    const point = new Vector3();
    let farness = 0;
    for (let i = 0; i < corners.count; i++) farness = Math.max(farness, point.fromBufferAttribute(corners, i).distanceTo(mass));
    return {
      surface,
      lines: edges,
      sides: box.getSize(new Vector3()).toArray(),
      middle: box.getCenter(new Vector3()),
      turn: new Quaternion(),
      farness,
    };
  }
}
