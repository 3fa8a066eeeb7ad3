import { Color, ConeGeometry, CylinderGeometry, Group, InstancedMesh, Matrix4, MeshStandardMaterial, Quaternion, Vector3 } from "three";
import { make } from "../elements.js";
import { contactColours } from "../theme.js";

const numbers = 7; // of what touches: point, force, kind
const z = new Vector3(0, 0, 1);

// What touches pushes the rod: an arrow from there, as long as the root of its force; between rods one on each. The colours
// of friction that holds and of what slides differ in lightness, too.
export class Contacts {
  constructor({ info, contacts, contactOffsets }, motion, size) {
    Object.assign(this, { motion, size, contacts, offsets: contactOffsets });
    this.group = new Group();
    this.count = contacts.length / numbers;
    this.hasFriction = info.has_contact_friction ?? false;
    this.largest = 0;
    this.most = 0;
    for (let i = 0; i < this.count; i++) this.largest = Math.max(this.largest, this.forceOf(i).length());
    for (let i = 1; i < this.offsets.length; i++) this.most = Math.max(this.most, this.offsets[i] - this.offsets[i - 1]);
    const material = new MeshStandardMaterial({ roughness: 0.6 });
    const shaft = new CylinderGeometry(1, 1, 1, 10).translate(0, 0.5, 0).rotateX(Math.PI / 2);
    const head = new ConeGeometry(1, 1, 14).translate(0, 0.5, 0).rotateX(Math.PI / 2);
    this.parts = [shaft, head].map((geometry) => new InstancedMesh(geometry, material, Math.max(1, 2 * this.most)));
    for (const part of this.parts) part.frustumCulled = false;
    this.group.add(...this.parts);
  }

  // Whether arrows are mostly along an axis, so that a view along it would hide them.
  areAlong(axis) {
    let [along, all] = [0, 0];
    for (let i = 0; i < this.count; i++) {
      const force = this.forceOf(i);
      along += Math.abs(force.getComponent(axis));
      all += force.length();
    }
    return along > 0.5 * all;
  }

  forceOf(i) {
    return new Vector3().fromArray(this.contacts, numbers * i + 3);
  }

  // Forces are those of the nearest frame; none where displacements are not drawn as they are.
  move() {
    const { frame, part, frames, scale } = this.motion;
    const shown = part < 0.5 ? frame : Math.min(frame + 1, frames - 1);
    let arrow = 0;
    for (let i = this.offsets[shown]; scale === 1 && i < this.offsets[shown + 1]; i++) {
      const force = this.forceOf(i);
      const kind = this.contacts[numbers * i + 6];
      const point = new Vector3().fromArray(this.contacts, numbers * i);
      const colour = new Color(this.colourOf(kind % 2 === 1));
      const length = 0.11 * this.size * Math.sqrt(force.length() / this.largest);
      if (!(length > 0)) continue;
      const ways = kind >= 2 ? [1, -1] : [1];
      for (const way of ways) this.put(arrow++, point, force.clone().multiplyScalar(way).normalize(), length, colour);
    }
    for (const part of this.parts) {
      part.count = arrow;
      part.instanceMatrix.needsUpdate = true;
      if (part.instanceColor) part.instanceColor.needsUpdate = true;
    }
  }

  put(index, point, direction, length, colour) {
    const radius = Math.min(0.0022 * this.size, 0.06 * length);
    const head = Math.min(7 * radius, 0.5 * length);
    const turn = new Quaternion().setFromUnitVectors(z, direction);
    const [shaft, cone] = this.parts;
    const matrix = new Matrix4();
    shaft.setMatrixAt(index, matrix.compose(point, turn, new Vector3(radius, radius, length - head)));
    const start = point.clone().addScaledVector(direction, length - head);
    cone.setMatrixAt(index, matrix.compose(start, turn, new Vector3(2.6 * radius, 2.6 * radius, head)));
    for (const part of this.parts) part.setColorAt(index, colour);
  }

  colourOf(slides) {
    if (!this.hasFriction) return contactColours.force;
    return slides ? contactColours.slides : contactColours.sticks;
  }

  makeLegend() {
    const words = this.hasFriction
      ? [[contactColours.sticks, "contact: holds"], [contactColours.slides, "slides"]]
      : [[contactColours.force, "contact"]];
    return words.map(([colour, text]) => {
      const key = make("span", { className: "key", title: "Length by the root of the force on the rod" }, make("i"), text);
      key.style.setProperty("--series", colour);
      return key;
    });
  }
}
