import { BufferAttribute, BufferGeometry, Color, DataTexture, Mesh, MeshStandardMaterial, SRGBColorSpace } from "three";
import { limitRadii, listRings } from "./rings.js";
import { multiply } from "../rotation.js";

const mostVertices = 120000;

// Rods as tubes: ellipses that follow the section axes, with a stripe on the side of section y.
export class Tubes {
  constructor(data, motion, size) {
    this.data = data;
    this.motion = motion;
    this.thickness = 1;
    this.cells = data.offsets.length - 1;
    this.drawnRadii = limitRadii(data, size);
    this.rings = listRings(data);
    for (const ring of this.rings) ring.radii = [0, 1].map((axis) => this.radiusOf(ring, this.drawnRadii, axis));
    this.sides = Math.max(4, Math.min(24, Math.floor(mostVertices / this.rings.length) - 3));
    this.mesh = new Mesh(this.makeGeometry(), makeMaterial());
    this.mesh.frustumCulled = false;
    this.plain = new Color();
    this.quaternion = new Float32Array(4);
  }

  // Vertices: sides + 1 a ring, for the texture's seam, then for each cap a ring and its middle.
  makeGeometry() {
    const { rings, sides } = this;
    this.caps = rings.flatMap((ring, i) => (ring.cap === 0 ? [] : [i]));
    const count = rings.length * (sides + 1) + this.caps.length * (sides + 2);
    const geometry = new BufferGeometry();
    const add = (name, width) => geometry.setAttribute(name, new BufferAttribute(new Float32Array(width * count), width));
    add("position", 3);
    add("normal", 3);
    add("color", 3);
    add("uv", 2);
    const index = [];
    for (let i = 0; i + 1 < rings.length; i++) {
      if (rings[i].cell !== rings[i + 1].cell) continue;
      for (let k = 0; k < sides; k++) {
        const a = i * (sides + 1) + k;
        const b = a + sides + 1;
        index.push(a, a + 1, b, b, a + 1, b + 1);
      }
    }
    this.caps.forEach((ring, i) => {
      const first = rings.length * (sides + 1) + i * (sides + 2);
      for (let k = 0; k < sides; k++) {
        const edge = rings[ring].cap > 0 ? [first + k, first + k + 1] : [first + k + 1, first + k];
        index.push(first + sides + 1, ...edge);
      }
    });
    const uv = geometry.attributes.uv.array;
    for (let i = 0; i < rings.length; i++) {
      for (let k = 0; k <= sides; k++) uv.set([k / sides, 0.5], 2 * (i * (sides + 1) + k));
    }
    uv.fill(0.5, 2 * rings.length * (sides + 1));
    geometry.setIndex(index);
    return geometry;
  }

  // A semi-axis of a ring, of radii at the nodes of its cell.
  radiusOf(ring, radii, axis) {
    const first = this.data.offsets[ring.cell];
    const sum = ring.weights.reduce((sum, w, j) => sum + w * radii[2 * (first + j) + axis], 0);
    return Math.max(sum, 0); // a polynomial can overshoot
  }

  // The largest semi-axis that is drawn of the cells at a node; 0 without any.
  radiusAt(node) {
    this.largestRadii = this.largestRadii ?? this.listLargestRadii();
    return this.largestRadii.get(node) ?? 0;
  }

  listLargestRadii() {
    const { connectivity, offsets } = this.data;
    const largest = new Map();
    for (let cell = 0; cell < this.cells; cell++) {
      for (let i = offsets[cell]; i < offsets[cell + 1]; i++) {
        const radius = Math.max(this.drawnRadii[2 * i], this.drawnRadii[2 * i + 1]);
        largest.set(connectivity[i], Math.max(radius, largest.get(connectivity[i]) ?? 0));
      }
    }
    return largest;
  }

  // Places all rings as the motion has them.
  move() {
    const { rings, sides } = this;
    const position = this.mesh.geometry.attributes.position.array;
    const normal = this.mesh.geometry.attributes.normal.array;
    this.frames = this.frames ?? new Float32Array(9 * rings.length);
    rings.forEach((ring, i) => {
      this.placeRing(ring, this.frames, 9 * i);
      if (ring.dome > 0) this.moveToDome(ring, 9 * i);
      const [cx, cy, cz, yx, yy, yz, zx, zy, zz] = this.frames.subarray(9 * i, 9 * i + 9);
      // Of the normal along the tangent y × z.
      const [tx, ty, tz] = [yy * zz - yz * zy, yz * zx - yx * zz, yx * zy - yy * zx].map((t) => t * Math.sin(ring.dome));
      const whole = ring.radii.map((radius) => radius * this.thickness);
      const [a, b] = whole.map((radius) => radius * Math.cos(ring.dome));
      for (let k = 0; k <= sides; k++) {
        const angle = (2 * Math.PI * k) / sides;
        const c = Math.cos(angle);
        const s = Math.sin(angle);
        const at = 3 * (i * (sides + 1) + k);
        position[at] = cx + a * c * yx + b * s * zx;
        position[at + 1] = cy + a * c * yy + b * s * zy;
        position[at + 2] = cz + a * c * yz + b * s * zz;
        const norm = Math.cos(ring.dome) / Math.hypot(c * b, s * a);
        normal[at] = (c * b * yx + s * a * zx) * norm + ring.side * tx;
        normal[at + 1] = (c * b * yy + s * a * zy) * norm + ring.side * ty;
        normal[at + 2] = (c * b * yz + s * a * zz) * norm + ring.side * tz;
      }
    });
    this.moveCaps(position, normal);
    this.mesh.geometry.attributes.position.needsUpdate = true;
    this.mesh.geometry.attributes.normal.needsUpdate = true;
  }

  // Centre, section y and z of a ring.
  placeRing(ring, out, at) {
    const { connectivity, offsets, axes } = this.data;
    const first = offsets[ring.cell];
    const q = this.quaternion;
    let x = 0, y = 0, z = 0, qw = 0, qx = 0, qy = 0, qz = 0;
    for (let j = 0; j < ring.weights.length; j++) {
      const w = ring.weights[j];
      const node = connectivity[first + j];
      x += w * this.motion.positions[3 * node];
      y += w * this.motion.positions[3 * node + 1];
      z += w * this.motion.positions[3 * node + 2];
      multiply(this.motion.rotations, 4 * node, axes, 4 * (first + j), q, 0);
      const sign = qw * q[0] + qx * q[1] + qy * q[2] + qz * q[3] < 0 ? -w : w;
      qw += sign * q[0];
      qx += sign * q[1];
      qy += sign * q[2];
      qz += sign * q[3];
    }
    const n = 2 / (qw * qw + qx * qx + qy * qy + qz * qz);
    out[at] = x;
    out[at + 1] = y;
    out[at + 2] = z;
    out[at + 3] = n * (qx * qy - qw * qz);
    out[at + 4] = 1 - n * (qx * qx + qz * qz);
    out[at + 5] = n * (qy * qz + qw * qx);
    out[at + 6] = n * (qx * qz + qw * qy);
    out[at + 7] = n * (qy * qz - qw * qx);
    out[at + 8] = 1 - n * (qx * qx + qy * qy);
  }

  // Along the tangent, out of the rod's end.
  moveToDome({ radii, side, dome }, at) {
    const [, , , yx, yy, yz, zx, zy, zz] = this.frames.subarray(at, at + 9);
    const reach = side * Math.sin(dome) * this.thickness * Math.max(...radii);
    this.frames[at] += reach * (yy * zz - yz * zy);
    this.frames[at + 1] += reach * (yz * zx - yx * zz);
    this.frames[at + 2] += reach * (yx * zy - yy * zx);
  }

  moveCaps(position, normal) {
    const { rings, sides } = this;
    this.caps.forEach((ring, i) => {
      const from = 3 * ring * (sides + 1);
      const to = 3 * (rings.length * (sides + 1) + i * (sides + 2));
      position.copyWithin(to, from, from + 3 * (sides + 1));
      const [cx, cy, cz, yx, yy, yz, zx, zy, zz] = this.frames.subarray(9 * ring, 9 * ring + 9);
      position.set([cx, cy, cz], to + 3 * (sides + 1));
      const side = rings[ring].cap;
      const out = [side * (yy * zz - yz * zy), side * (yz * zx - yx * zz), side * (yx * zy - yy * zx)];
      for (let k = 0; k < sides + 2; k++) normal.set(out, to + 3 * k);
    });
  }

  // Paints by values of the cells or nodes, or all alike.
  paint(scale, of, values) {
    const colour = this.mesh.geometry.attributes.color;
    const { rings, sides } = this;
    const rgb = [this.plain.r, this.plain.g, this.plain.b];
    const ringColours = new Float32Array(3 * rings.length);
    rings.forEach((ring, i) => {
      if (scale) this.colour(scale, of === "cell" ? values[ring.cell] : this.valueAt(ring, values), rgb);
      ringColours.set(rgb, 3 * i);
      for (let k = 0; k <= sides; k++) colour.array.set(rgb, 3 * (i * (sides + 1) + k));
    });
    this.caps.forEach((ring, i) => {
      const first = rings.length * (sides + 1) + i * (sides + 2);
      for (let k = 0; k < sides + 2; k++) colour.array.set(ringColours.subarray(3 * ring, 3 * ring + 3), 3 * (first + k));
    });
    colour.needsUpdate = true;
  }

  // Plain where there is no number: rods without stresses.
  colour(scale, value, rgb) {
    if (Number.isFinite(value)) scale.write(value, rgb, 0);
    else [rgb[0], rgb[1], rgb[2]] = [this.plain.r, this.plain.g, this.plain.b];
  }

  valueAt(ring, values) {
    const first = this.data.offsets[ring.cell];
    return ring.weights.reduce((sum, w, j) => sum + w * values[this.data.connectivity[first + j]], 0);
  }
}

function makeMaterial() {
  const width = 128;
  const texels = new Uint8Array(4 * width).fill(255);
  for (let i = 0; i < width; i++) {
    const isStripe = Math.min(i, width - 1 - i) < width * 0.035;
    if (isStripe) texels.set([96, 96, 104, 255], 4 * i);
  }
  const map = new DataTexture(texels, width, 1);
  map.colorSpace = SRGBColorSpace;
  map.needsUpdate = true;
  return new MeshStandardMaterial({ map, vertexColors: true, roughness: 0.55, metalness: 0.05 });
}
