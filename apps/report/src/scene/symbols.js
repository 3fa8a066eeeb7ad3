import {
  BoxGeometry, CanvasTexture, ConeGeometry, CylinderGeometry, Group, Mesh, SphereGeometry, Sprite, SpriteMaterial,
  SRGBColorSpace, TorusGeometry, Vector3,
} from "three";
import { makeArrow, materialOf, setLength } from "./arrows.js";
import { symbolColours } from "../theme.js";

const z = new Vector3(0, 0, 1);
const axes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), z];

// What holds a node: a block where nothing can move, a ball where it can turn, a cylinder along the axis of a hinge; else a
// cone for each displacement and a ring for each rotation held, in the support's own axes. What moves as prescribed has
// another colour.
export class Supports {
  constructor(data, motion, size) {
    this.motion = motion;
    this.group = new Group();
    this.marks = data.info.supports.map((support) => {
      const mark = makeSupport(support, 0.017 * size);
      mark.node = support.node;
      mark.name = support.name;
      this.group.add(mark);
      return mark;
    });
  }

  move() {
    for (const mark of this.marks) mark.position.fromArray(this.motion.positions, 3 * mark.node);
  }
}

function makeSupport(support, size) {
  const mark = new Group();
  const [w, x, y, zz] = support.axes;
  mark.quaternion.set(x, y, zz, w);
  const whole = wholeSymbol(support, size);
  if (whole) {
    mark.add(whole);
    return mark;
  }
  const cone = new ConeGeometry(0.6 * size, 1.6 * size, 20).rotateX(Math.PI / 2).translate(0, 0, -0.8 * size);
  const ring = new TorusGeometry(1.25 * size, 0.12 * size, 8, 32);
  for (let i = 0; i < 6; i++) {
    if (!support.fixed[i] && !support.moved[i]) continue;
    const colour = support.moved[i] ? symbolColours.moved : symbolColours.support;
    const part = new Mesh(i < 3 ? cone : ring, materialOf(colour));
    part.quaternion.setFromUnitVectors(z, axes[i % 3]);
    mark.add(part);
  }
  return mark;
}

// Of a support that fixes the position: block, ball or hinge; null of others.
function wholeSymbol({ fixed, moved }, size) {
  if (moved.some(Boolean) || !fixed.slice(0, 3).every(Boolean)) return null;
  const turns = [3, 4, 5].filter((i) => !fixed[i]);
  const material = materialOf(symbolColours.support);
  if (turns.length === 0) return new Mesh(new BoxGeometry(2 * size, 2 * size, 2 * size), material);
  if (turns.length === 3) return new Mesh(new SphereGeometry(0.9 * size, 32, 24), material);
  if (turns.length !== 1) return null;
  const hinge = new Mesh(new CylinderGeometry(0.7 * size, 0.7 * size, 2.6 * size, 32).rotateX(Math.PI / 2), material);
  hinge.quaternion.setFromUnitVectors(z, axes[turns[0] - 3]);
  return hinge;
}

// Forces as arrows, moments as arrows with two heads, each as long as its present value relative to the
// largest of its kind over all frames; those per length half as long.
export class Loads {
  constructor(data, motion, size) {
    this.data = data;
    this.motion = motion;
    this.size = size;
    this.group = new Group();
    this.arrows = data.info.arrows.flatMap((arrow, index) =>
      [0, 3].map((first) => {
        const colour = first === 0 ? symbolColours.force : symbolColours.moment;
        const mark = makeArrow(colour, size, 0.003 * size, first === 0 ? 1 : 2);
        this.group.add(mark);
        return { ...arrow, mark, at: 6 * index + first, kind: `${first} ${arrow.along_rod}` };
      }),
    );
    this.largest = this.findLargest();
  }

  findLargest() {
    const largest = {};
    const count = 6 * this.data.info.arrows.length;
    for (const { kind, at } of this.arrows) {
      for (let i = at; i < this.data.arrows.length; i += count) {
        const size = Math.hypot(...this.data.arrows.subarray(i, i + 3));
        if (size > (largest[kind] ?? 0)) largest[kind] = size;
      }
    }
    return largest;
  }

  // [least, largest] corners of the arrows of all frames that show something.
  bounds() {
    const least = [Infinity, Infinity, Infinity];
    const largest = [-Infinity, -Infinity, -Infinity];
    const value = new Vector3();
    const count = 6 * this.data.info.arrows.length;
    for (let frame = 0; this.arrows.length > 0 && frame < this.motion.frames; frame++) {
      this.motion.moveTo(frame);
      for (const { node, at, kind, along_rod: isAlongRod } of this.arrows) {
        value.fromArray(this.data.arrows, frame * count + at);
        const share = value.length() / (this.largest[kind] ?? 1);
        if (!(share > 1e-3)) continue;
        value.setLength(this.lengthOf(isAlongRod, share));
        value.toArray().forEach((part, i) => {
          const tip = this.motion.positions[3 * node + i] + part;
          least[i] = Math.min(least[i], tip);
          largest[i] = Math.max(largest[i], tip);
        });
      }
    }
    return [least, largest];
  }

  lengthOf(isAlongRod, share) {
    return (isAlongRod ? 0.08 : 0.16) * this.size * share;
  }

  move() {
    const { frame, part, frames, positions } = this.motion;
    const count = 6 * this.data.info.arrows.length;
    const value = new Vector3();
    const next = new Vector3();
    for (const { mark, node, at, kind, along_rod: isAlongRod } of this.arrows) {
      value.fromArray(this.data.arrows, frame * count + at);
      value.lerp(next.fromArray(this.data.arrows, Math.min(frame + 1, frames - 1) * count + at), part);
      const share = value.length() / (this.largest[kind] ?? 1);
      mark.visible = share > 1e-3;
      if (!mark.visible) continue;
      setLength(mark, this.lengthOf(isAlongRod, share), (isAlongRod ? 0.002 : 0.0035) * this.size);
      mark.position.fromArray(positions, 3 * node);
      mark.quaternion.setFromUnitVectors(z, value.normalize());
    }
  }
}

// Rings around the nodes that the reason of a failure names; they shine through everything.
export class FailMarks {
  constructor(data, motion, size) {
    this.motion = motion;
    this.group = new Group();
    const material = new SpriteMaterial({ map: drawRing(), depthTest: false, transparent: true });
    this.marks = data.info.fail_nodes.map((node, i) => {
      const mark = new Sprite(material);
      mark.scale.setScalar((i === 0 ? 0.1 : 0.07) * size);
      mark.renderOrder = 10;
      mark.node = node;
      this.group.add(mark);
      return mark;
    });
  }

  move() {
    for (const mark of this.marks) mark.position.fromArray(this.motion.positions, 3 * mark.node);
  }
}

function drawRing() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 128;
  const pen = canvas.getContext("2d");
  pen.strokeStyle = symbolColours.failure;
  pen.lineWidth = 12;
  pen.beginPath();
  pen.arc(64, 64, 54, 0, 2 * Math.PI);
  pen.stroke();
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

