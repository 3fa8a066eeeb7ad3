import { CylinderGeometry, Mesh, Quaternion, Vector3 } from "three";
import { materialOf } from "./arrows.js";

const z = new Vector3(0, 0, 1);
const along = new Vector3();
const bar = new CylinderGeometry(1, 1, 1, 12).translate(0, 0.5, 0).rotateX(Math.PI / 2);

export const toQuaternion = ([w, x, y, zz]) => new Quaternion(x, y, zz, w);

// An end of a joint, a spring or a bushing: a point that a node carries on an arm, or one of the ground.
export class End {
  constructor({ node, arm }, motion) {
    this.motion = motion;
    this.node = node;
    this.arm = new Vector3(...arm);
    this.isGround = node < 0;
    this.start = new Vector3(); // of the arm, now
    this.place = new Vector3();
    this.turn = new Quaternion(); // since t = 0
  }

  move() {
    if (this.isGround) {
      this.place.copy(this.arm);
      return;
    }
    const { positions, rotations } = this.motion;
    const [w, x, y, zz] = rotations.subarray(4 * this.node, 4 * this.node + 4);
    this.turn.set(x, y, zz, w);
    this.start.fromArray(positions, 3 * this.node);
    this.place.copy(this.arm).applyQuaternion(this.turn).add(this.start);
  }

  // Whether there is an arm to see.
  isApart(size) {
    return !this.isGround && this.arm.length() > 0.004 * size;
  }
}

// The two ends of a joint or spring as the page has them.
export const makeEnds = ({ ends }, motion) => ends.map((end) => new End(end, motion));

// A round bar between two points, which setBar() places.
export function makeBar(material, radius) {
  const mesh = new Mesh(bar, material);
  mesh.scale.set(radius, radius, 1);
  return mesh;
}

export const makeColouredBar = (colour, radius) => makeBar(materialOf(colour), radius);

export function setBar(mesh, from, to) {
  const length = along.subVectors(to, from).length();
  mesh.position.copy(from);
  mesh.scale.z = Math.max(length, 1e-12);
  if (length > 0) mesh.quaternion.setFromUnitVectors(z, along.divideScalar(length));
}

// [least, largest] corners of points.
export class Bounds {
  constructor() {
    this.least = [Infinity, Infinity, Infinity];
    this.largest = [-Infinity, -Infinity, -Infinity];
  }

  include(point) {
    point.toArray().forEach((x, i) => {
      if (x < this.least[i]) this.least[i] = x;
      if (x > this.largest[i]) this.largest[i] = x;
    });
  }

  get corners() {
    return [this.least, this.largest];
  }
}
