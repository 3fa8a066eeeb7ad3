import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments } from "three";
import { shapeFunctions } from "./lagrange.js";

const mostShapes = 24;
const mostPoints = 200000;

function makeLines(points, opacity) {
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  const lines = new LineSegments(geometry, new LineBasicMaterial({ transparent: true, opacity, depthWrite: false }));
  lines.frustumCulled = false;
  return lines;
}

// Segments along all cells between nodes at these positions; a few per curve.
function addSegments({ connectivity, offsets }, positions, points) {
  const weights = new Map();
  for (let cell = 0; cell + 1 < offsets.length; cell++) {
    const nodes = connectivity.subarray(offsets[cell], offsets[cell + 1]);
    if (!weights.has(nodes.length)) weights.set(nodes.length, listWeights(nodes.length));
    let before = null;
    for (const shape of weights.get(nodes.length)) {
      const point = [0, 1, 2].map((i) => shape.reduce((sum, w, j) => sum + w * positions[3 * nodes[j] + i], 0));
      if (before) points.push(...before, ...point);
      before = point;
    }
  }
}

function listWeights(nodes) {
  const pieces = nodes === 2 ? 1 : 4;
  return Array.from({ length: pieces + 1 }, (_, i) => shapeFunctions(nodes, (2 * i) / pieces - 1));
}

// The rods at t = 0.
export function makeReference(data) {
  const points = [];
  addSegments(data, data.reference, points);
  return makeLines(points, 0.55);
}

// The rods with their nodes at these places.
export function makeState(data, places) {
  const points = [];
  addSegments(data, places, points);
  return makeLines(points, 0.7);
}

// The rods at some frames, evenly over all of them.
export function makeShapes(data, motion) {
  const points = [];
  const count = Math.min(mostShapes, data.times.length, Math.floor(mostPoints / data.offsets.length));
  for (let i = 0; i < count; i++) {
    motion.moveTo(Math.round((i * (data.times.length - 1)) / Math.max(count - 1, 1)));
    addSegments(data, motion.positions, points);
  }
  return makeLines(points, 0.22);
}
