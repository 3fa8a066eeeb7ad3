import { between, fromVector } from "./rotation.js";

// Where the nodes are and how they are turned at the position of the clock.
export class Motion {
  constructor(data) {
    this.data = data;
    this.count = data.reference.length / 3;
    this.frames = data.times.length;
    this.seams = new Set(); // frames from which the motion jumps to the next
    this.scale = 1; // of the displacements, and of rotations since t = 0
    this.positions = new Float32Array(3 * this.count);
    this.rotations = new Float32Array(4 * this.count); // since t = 0
    this.next = new Float32Array(4);
    this.frame = 0;
    this.part = 0;
  }

  moveTo(position) {
    this.frame = Math.min(Math.floor(position), this.frames - 1);
    this.part = position - this.frame;
    if (this.seams.has(this.frame) && this.part > 0) {
      if (this.part >= 0.5) this.frame++;
      this.part = 0;
    }
    const following = Math.min(this.frame + 1, this.frames - 1);
    const { displacement, rotation_vector: rotation } = this.data.quantities;
    const first = 3 * this.count * this.frame;
    const second = 3 * this.count * following;
    for (let i = 0; i < 3 * this.count; i++) {
      const u = mix(displacement.values[first + i], displacement.values[second + i], this.part);
      this.positions[i] = this.data.reference[i] + this.scale * u;
    }
    for (let node = 0; node < this.count; node++) {
      fromVector(rotation.values, first + 3 * node, this.scale, this.rotations, 4 * node);
      if (this.part === 0) continue;
      fromVector(rotation.values, second + 3 * node, this.scale, this.next, 0);
      between(this.rotations, 4 * node, this.next, 0, this.part, this.rotations, 4 * node);
    }
  }

  // Component (0, 1, 2) or magnitude (3) of a quantity, for each node or cell, into `out`.
  sample(quantity, component, out) {
    const count = out.length;
    const following = Math.min(this.frame + 1, this.frames - 1);
    for (let i = 0; i < count; i++) {
      const a = valueOf(quantity, count * this.frame + i, component);
      const b = valueOf(quantity, count * following + i, component);
      out[i] = mix(a, b, this.part);
    }
  }

  // [least, largest] x, y, z of all nodes in all frames.
  bounds() {
    const { values } = this.data.quantities.displacement;
    const least = [Infinity, Infinity, Infinity];
    const largest = [-Infinity, -Infinity, -Infinity];
    const size = 3 * this.count;
    for (let i = 0; i < values.length; i++) {
      const x = this.data.reference[i % size] + this.scale * values[i];
      const axis = i % 3;
      if (x < least[axis]) least[axis] = x;
      if (x > largest[axis]) largest[axis] = x;
    }
    return [least, largest];
  }
}

function mix(a, b, part) {
  return part === 0 ? a : a + part * (b - a);
}

// Of a row of a quantity, whose rows are vectors or numbers.
const valueOf = ({ values, isScalar }, row, component) => (isScalar ? values[row] : componentOf(values, 3 * row, component));

export function componentOf(values, at, component) {
  if (component < 3) return values[at + component];
  return Math.hypot(values[at], values[at + 1], values[at + 2]);
}

// [least, largest] of a component or of the magnitude over all frames.
export function rangeOf(quantity, component) {
  let least = Infinity;
  let largest = -Infinity;
  const rows = quantity.values.length / (quantity.isScalar ? 1 : 3);
  for (let row = 0; row < rows; row++) {
    const value = valueOf(quantity, row, component);
    if (value < least) least = value;
    if (value > largest) largest = value;
  }
  return least <= largest ? [least, largest] : [0, 0];
}
