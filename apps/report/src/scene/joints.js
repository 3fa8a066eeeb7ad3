import { Group, MeshStandardMaterial, Quaternion, Vector3 } from "three";
import { materialOf } from "./arrows.js";
import { Bounds, makeBar, makeEnds, setBar, toQuaternion } from "./ends.js";
import { makeKnob, makeRail, makeRoller, makeSymbol, slides } from "./joint_symbols.js";
import { symbolColours } from "../theme.js";

const x = new Vector3(1, 0, 0);

// Joints as symbols at their points, with the axes that their sides carry; what slides is on a rail as long as its way in all
// frames. Bars join the points to the nodes that carry them, so that bodies on joints look like links, unless the deck says what they look like.
export class Joints {
  // `rods` and `bodies` say what is around the points, which symbols reach out of.
  constructor(data, motion, size, { rods, bodies }) {
    this.motion = motion;
    this.size = size;
    this.barRadius = 0.0045 * size;
    this.rods = rods;
    this.bodies = bodies;
    this.group = new Group();
    this.links = new MeshStandardMaterial({ roughness: 0.6 });
    this.marks = data.info.joints.map((joint) => this.makeMark(joint));
  }

  makeMark(joint) {
    const ends = makeEnds(joint, this.motion);
    const material = materialOf(colourOf(joint, ends));
    const axes = toQuaternion(joint.axes);
    const axis = x.clone().applyQuaternion(axes);
    const reach = joinReaches(ends.map((end) => this.bodies.reachFrom(end, axis)));
    const nodes = [...ends.map(({ node }) => node), joint.around ?? -1];
    const symbolSize = Math.max(0.016 * this.size, ...nodes.map((node) => 1.3 * this.rods.radiusAt(node)));
    // Of two sides the one with the rail: the ground, or A.
    const railEnd = slides.has(joint.type) && ends[1].isGround ? 1 : 0;
    const symbol = makeSymbol(joint, material, symbolSize, reach);
    const mark = { ...joint, ...symbol, ends, axes, axis, reach, material, railEnd, symbolSize, place: new Vector3() };
    this.group.add(mark.body);
    if (mark.cross) this.group.add(mark.cross);
    if (mark.cross) mark.secondAxis = new Quaternion().setFromUnitVectors(x, new Vector3(...joint.axis_b).normalize());
    if (joint.type === "distance") {
      mark.bar = makeBar(material, 0.35 * symbolSize);
      mark.knob = makeKnob(material, symbolSize);
      this.group.add(mark.bar, mark.knob);
    }
    if (joint.type === "cam") {
      mark.roller = makeRoller(material, joint.roller, symbolSize);
      mark.span = Math.max(...joint.curve.map(([y, z]) => Math.hypot(y, z)));
      this.group.add(mark.roller);
    }
    mark.arms = ends.map((end) => (end.isApart(this.size) && !this.bodies.hasLooks(end.node) ? makeBar(this.links, this.barRadius) : null));
    for (const arm of mark.arms) if (arm) this.group.add(arm);
    return mark;
  }

  // What depends on all frames: how far they slide, and [least, largest] corners of their points.
  survey() {
    const bounds = new Bounds();
    for (const mark of this.marks) Object.assign(mark, { least: Infinity, most: -Infinity });
    for (let frame = 0; this.marks.length > 0 && frame < this.motion.frames; frame++) {
      this.motion.moveTo(frame);
      for (const mark of this.marks) {
        for (const end of mark.ends) {
          end.move();
          bounds.include(end.place);
        }
        for (const side of mark.span ? [-1, 1] : []) bounds.include(mark.ends[0].place.clone().addScalar(side * mark.span));
        const way = slideOf(mark);
        mark.least = Math.min(mark.least, way);
        mark.most = Math.max(mark.most, way);
      }
    }
    this.marks.filter(({ type }) => slides.has(type)).forEach((mark) => this.layRail(mark, bounds));
    this.bounds = bounds.corners;
  }

  layRail(mark, bounds) {
    const [behind, before] = mark.reach;
    const margin = 3.2 * mark.symbolSize;
    if (mark.rail) this.group.remove(mark.rail);
    const [first, last] = [mark.least - behind - margin, mark.most + before + margin];
    mark.rail = makeRail(mark.type, mark.material, mark.symbolSize, first, last);
    this.group.add(mark.rail);
    const end = mark.ends[mark.railEnd];
    for (const at of [first, last]) bounds.include(directionOf(mark, end).multiplyScalar(at).add(end.place));
  }

  move() {
    for (const mark of this.marks) this.moveMark(mark);
  }

  moveMark(mark) {
    const [a, b] = mark.ends;
    a.move();
    b.move();
    const { type, body, axes, place } = mark;
    const rider = mark.ends[1 - mark.railEnd];
    if (slides.has(type)) place.copy(rider.place);
    else if (type === "plane") place.copy(b.place);
    else if (type === "distance" || type === "cam") place.copy(a.place);
    else place.addVectors(a.place, b.place).multiplyScalar(0.5);
    body.position.copy(place);
    body.quaternion.copy(slides.has(type) ? rider.turn : a.turn).multiply(axes);
    if (mark.cross) {
      mark.cross.position.copy(place);
      mark.cross.quaternion.copy(b.turn).multiply(mark.secondAxis);
    }
    if (mark.rail) {
      mark.rail.position.copy(mark.ends[mark.railEnd].place);
      mark.rail.quaternion.copy(mark.ends[mark.railEnd].turn).multiply(axes);
    }
    if (mark.bar) {
      setBar(mark.bar, a.place, b.place);
      mark.knob.position.copy(b.place);
      place.lerp(b.place, 0.5); // of its name
    }
    if (mark.roller) {
      mark.roller.position.copy(b.place);
      mark.roller.quaternion.copy(body.quaternion);
    }
    // With magnified displacements the two points are apart; arms still meet.
    const meets = !mark.rail && !mark.bar && !mark.roller && type !== "plane";
    mark.ends.forEach((end, i) => mark.arms[i] && setBar(mark.arms[i], end.start, meets ? place : end.place));
  }

  setColours(theme) {
    this.links.color.set(theme.body);
  }
}

function colourOf(joint, ends) {
  if (joint.moved) return symbolColours.moved;
  return ends.some(({ isGround }) => isGround) ? symbolColours.support : symbolColours.joint;
}

function directionOf({ axis }, end) {
  return axis.clone().applyQuaternion(end.turn);
}

// Of what rides on the rail.
function slideOf(mark) {
  const end = mark.ends[mark.railEnd];
  return mark.ends[1 - mark.railEnd].place.clone().sub(end.place).dot(directionOf(mark, end));
}

function joinReaches(reaches) {
  return [0, 1].map((side) => Math.max(...reaches.map((reach) => reach[side])));
}
