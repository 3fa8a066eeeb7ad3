import { BoxGeometry, Group, Mesh, Quaternion, TubeGeometry, Vector3 } from "three";
import { materialOf } from "./arrows.js";
import { Coil } from "./coil.js";
import { Bounds, makeBar, makeColouredBar, makeEnds, setBar, toQuaternion } from "./ends.js";
import { makeKnob } from "./joint_symbols.js";
import { symbolColours } from "../theme.js";

// Springs as coils between their points, dampers as a piston in a tube, bushings as a box on half the way between theirs; bars
// join the points to the nodes that carry them. Grey knobs are on the ground.
export class Springs {
  constructor(data, motion, size) {
    this.motion = motion;
    this.size = size;
    this.symbolSize = 0.016 * size;
    this.group = new Group();
    this.material = materialOf(symbolColours.spring);
    this.springs = data.info.springs.map((spring) => this.makeSpring(spring));
    this.bushings = data.info.bushings.map((bushing) => this.makeBushing(bushing));
    this.marks = [...this.springs, ...this.bushings];
  }

  makeMark(part) {
    const ends = makeEnds(part, this.motion);
    const arms = ends.map((end) => (end.isApart(this.size) ? makeColouredBar(symbolColours.spring, 0.2 * this.symbolSize) : null));
    for (const arm of arms) if (arm) this.group.add(arm);
    for (const end of ends.filter(({ isGround }) => isGround)) {
      const knob = makeKnob(materialOf(symbolColours.support), this.symbolSize);
      knob.position.copy(end.arm);
      this.group.add(knob);
    }
    return { ...part, ends, arms, place: new Vector3() };
  }

  makeSpring(spring) {
    const mark = this.makeMark({ ...spring, type: spring.pulls ? "spring" : "damper" });
    mark.line = spring.pulls ? this.makeCoil(lengthOf(mark.ends, this.motion.data.reference)) : this.makePiston();
    this.group.add(mark.line);
    return mark;
  }

  // Of length 1 along z, with the proportions that it has at this length.
  makeCoil(length) {
    const { symbolSize } = this;
    const drawn = Math.max(length, 4 * symbolSize);
    const turns = Math.min(Math.max(Math.round(drawn / (2.2 * symbolSize)), 5), 12);
    const coil = new TubeGeometry(new Coil(1.1 * symbolSize, drawn, turns, 0.1), 24 * turns, 0.2 * symbolSize, 8);
    return new Mesh(coil.scale(1, 1, 1 / drawn), this.material);
  }

  makePiston() {
    const group = new Group();
    const parts = [[0, 1, 0.2], [0.3, 0.65, 0.75]];
    for (const [from, to, radius] of parts) {
      const part = makeBar(this.material, radius * this.symbolSize);
      part.position.z = from;
      part.scale.z = to - from;
      group.add(part);
    }
    return group;
  }

  makeBushing(bushing) {
    const mark = this.makeMark({ ...bushing, type: "bushing" });
    mark.axes = toQuaternion(bushing.axes);
    const side = 2.2 * this.symbolSize;
    mark.box = new Mesh(new BoxGeometry(side, side, side), this.material);
    this.group.add(mark.box);
    return mark;
  }

  // [least, largest] corners of their points in all frames.
  survey() {
    const bounds = new Bounds();
    for (let frame = 0; this.marks.length > 0 && frame < this.motion.frames; frame++) {
      this.motion.moveTo(frame);
      for (const end of this.marks.flatMap(({ ends }) => ends)) {
        end.move();
        bounds.include(end.place);
      }
    }
    this.bounds = bounds.corners;
  }

  move() {
    const turn = new Quaternion();
    for (const { ends, arms, place, line, box, axes } of this.marks) {
      const [a, b] = ends;
      a.move();
      b.move();
      place.addVectors(a.place, b.place).multiplyScalar(0.5);
      if (line) setBar(line, a.place, b.place);
      if (box) {
        box.position.copy(place);
        box.quaternion.copy(turn.slerpQuaternions(a.turn, b.turn, 0.5)).multiply(axes);
      }
      ends.forEach((end, i) => arms[i] && setBar(arms[i], end.start, box ? place : end.place));
    }
  }
}

// At t = 0.
function lengthOf(ends, reference) {
  const [a, b] = ends.map(({ node, arm }) => (node < 0 ? arm.clone() : new Vector3().fromArray(reference, 3 * node).add(arm)));
  return a.distanceTo(b);
}
