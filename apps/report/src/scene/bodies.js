import {
  BoxGeometry, BufferAttribute, BufferGeometry, CapsuleGeometry, EdgesGeometry, Group, Line, LineBasicMaterial, LineSegments, Mesh,
  MeshStandardMaterial, Quaternion, SphereGeometry, Vector3,
} from "three";
import { makeArrow } from "./arrows.js";
import { toQuaternion } from "./ends.js";
import { Outlines } from "./outlines.js";
import { axisColours } from "../theme.js";

const mostPaths = 100;
const axes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];

// Rigid bodies: their looks in the deck, or the shape with which they touch, or the cuboid of their mass and inertia; the body axes, an arm from the
// node to the centre of mass, and the path. Those on joints or bushings are clear unless their looks are given, so that these are seen in them.
export class Bodies {
  constructor(data, motion, size) {
    this.motion = motion;
    this.surface = makeSurface();
    this.clear = Object.assign(makeSurface(), { transparent: true, opacity: 0.26, depthWrite: false });
    this.group = new Group();
    this.paths = new Group();
    this.jointed = new Set([...data.info.joints, ...data.info.bushings].flatMap(({ ends }) => ends.map(({ node }) => node)));
    this.outlines = new Outlines(data.info.bodies);
    this.bodies = data.info.bodies.map((body) => this.makeBody(body, size));
    this.lines = this.bodies.slice(0, mostPaths).map(() => this.makePath(data.times.length));
  }

  makeBody(body, size) {
    const group = new Group();
    const half = body.half_sizes;
    const largest = Math.max(...half);
    const drawn = largest > 0 ? Math.max(largest, 0.015 * size) : 0.02 * size;
    const outline = this.outlines.of(body);
    const round = body.shape && !outline && new Round(body.shape);
    const cuboid = half.map((h) => 2 * Math.max(largest > 0 ? h * (drawn / largest) : drawn, 0.04 * drawn));
    const sides = outline?.sides ?? (round ? [round.reach, round.reach, round.reach] : cuboid);
    const box = outline?.surface ?? (round ? round.surface() : new BoxGeometry(...sides));
    const isClear = this.jointed.has(body.node) && !outline;
    const surface = new Mesh(box, isClear ? this.clear : this.surface);
    const lines = outline?.lines ?? (round ? round.lines() : new EdgesGeometry(box));
    const edges = new LineSegments(lines, new LineBasicMaterial({ transparent: true, opacity: 0.6 }));
    this.edgeMaterials = [...(this.edgeMaterials ?? []), edges.material];
    const centre = new Vector3(...body.centre);
    for (const part of outline ? [] : [surface, edges]) {
      part.position.copy(round ? round.centre : centre);
      part.quaternion.copy(round ? round.turn : toQuaternion(body.axes));
    }
    group.add(surface, edges);
    axes.forEach((axis, i) => {
      const share = isClear || outline ? 0.5 : 1; // joints have axes, too
      const longest = Math.max(...sides);
      const arrow = makeArrow(axisColours[i], share * (0.9 * longest + 0.02 * size), share * (0.0018 * size + 0.006 * longest));
      arrow.position.copy(centre);
      arrow.quaternion.setFromUnitVectors(axes[2], axis);
      group.add(arrow);
    });
    if (centre.length() > 0 && !outline) {
      const arm = new BufferGeometry().setFromPoints([new Vector3(), centre]);
      group.add(new Line(arm, edges.material));
    }
    this.group.add(group);
    const around = outline ?? { middle: centre, turn: toQuaternion(body.axes) }; // the box that has the sides
    return { ...body, group, centre, around, attitude: toQuaternion(body.attitude), sides, isClear, hasLooks: Boolean(outline), reach: Math.max(...sides) };
  }

  // Whether the node carries a body whose looks are given.
  hasLooks(node) {
    return this.bodies.some((body) => body.node === node && body.hasLooks);
  }

  // Distances behind and before an end of a joint at which a line along a direction of t = 0 leaves the cuboid of the body that
  // carries the end; 0 outside it.
  reachFrom({ node, arm }, direction) {
    const body = this.bodies.find((candidate) => candidate.node === node);
    if (!body) return [0, 0];
    const back = body.attitude.clone().invert();
    const boxBack = body.around.turn.clone().invert();
    const place = arm.clone().applyQuaternion(back).sub(body.around.middle).applyQuaternion(boxBack).toArray();
    const way = direction.clone().applyQuaternion(back).applyQuaternion(boxBack).toArray();
    const half = body.sides.map((side) => 0.5 * side);
    if (place.some((x, i) => Math.abs(x) > 1.001 * half[i])) return [0, 0];
    const wayOut = (sign, i) => Math.max(0, (half[i] - Math.sign(sign * way[i]) * place[i]) / Math.abs(way[i]));
    return [-1, 1].map((sign) => Math.min(...[0, 1, 2].filter((i) => way[i] !== 0).map((i) => wayOut(sign, i))));
  }

  move() {
    for (const body of this.bodies) this.place(body, body.group.position, body.group.quaternion);
  }

  place(body, position, quaternion) {
    const { positions, rotations } = this.motion;
    const node = body.node;
    position.fromArray(positions, 3 * node);
    const [w, x, y, z] = rotations.subarray(4 * node, 4 * node + 4);
    quaternion.set(x, y, z, w).multiply(body.attitude);
  }

  makePath(frames) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * frames), 3));
    const line = new Line(geometry, new LineBasicMaterial({ transparent: true, opacity: 0.9 }));
    line.frustumCulled = false;
    this.paths.add(line);
    return line;
  }

  // The path of each centre of mass over all frames; of a body that turns on the spot, that of its z axis.
  trace() {
    const { frames } = this.motion;
    const quaternion = new Quaternion();
    const node = new Vector3();
    this.lines.forEach((line, i) => {
      const body = this.bodies[i];
      const centres = new Float32Array(3 * frames);
      const tips = new Float32Array(3 * frames);
      const tip = new Vector3(0, 0, 0.9 * body.reach).add(body.centre);
      for (let frame = 0; frame < frames; frame++) {
        this.motion.moveTo(frame);
        this.place(body, node, quaternion);
        body.centre.clone().applyQuaternion(quaternion).add(node).toArray(centres, 3 * frame);
        tip.clone().applyQuaternion(quaternion).add(node).toArray(tips, 3 * frame);
      }
      line.geometry.attributes.position.copyArray(extent(centres) > 0.02 * body.reach ? centres : tips);
      line.geometry.attributes.position.needsUpdate = true;
    });
  }

  showPathsUpTo(frame) {
    for (const line of this.lines) line.geometry.setDrawRange(0, frame + 1);
  }

  // Corners of a box around all paths and the bodies along them.
  bounds() {
    const least = [Infinity, Infinity, Infinity];
    const largest = [-Infinity, -Infinity, -Infinity];
    this.lines.forEach((line, body) => {
      const { array } = line.geometry.attributes.position;
      const { sides, reach, isClear, around } = this.bodies[body];
      const room = around.farness ? around.farness : isClear ? 0.5 * Math.hypot(...sides) : 0.75 * reach;
      const include = (x, i) => {
        least[i % 3] = Math.min(least[i % 3], x - room);
        largest[i % 3] = Math.max(largest[i % 3], x + room);
      };
      array.forEach(include);
      this.bodies[body].group.position.toArray().forEach(include);
    });
    return [least, largest];
  }

  setColours(theme) {
    for (const surface of [this.surface, this.clear]) surface.color.set(theme.body);
    for (const material of this.edgeMaterials ?? []) material.color.set(theme.ink);
    for (const line of this.lines) line.material.color.set(theme.path);
  }
}

// A sphere or capsule about the y axis, with lines that show how it turns.
class Round {
  constructor({ ends, radius }) {
    const [from, to] = ends.map((end) => new Vector3(...end));
    this.radius = radius;
    this.length = from.distanceTo(to);
    this.reach = this.length + 2 * radius;
    this.centre = from.clone().add(to).multiplyScalar(0.5);
    this.turn = new Quaternion();
    if (this.length > 0) this.turn.setFromUnitVectors(axes[1], to.clone().sub(from).normalize());
  }

  surface() {
    return this.length > 0 ? new CapsuleGeometry(this.radius, this.length, 16, 48) : new SphereGeometry(this.radius, 48, 32);
  }

  // Once around lengthwise in two planes, and around each end, of the sphere once.
  lines() {
    const points = [];
    const pieces = 64;
    const half = 0.5 * this.length;
    const close = (point) => {
      for (let i = 0; i < pieces; i++) points.push(...[i, i + 1].map((at) => point((2 * Math.PI * at) / pieces).multiplyScalar(1.002)));
    };
    const rise = (height) => height + Math.sign(height) * half;
    const wave = (turn) => [this.radius * Math.cos(turn), this.radius * Math.sin(turn)];
    close((turn) => new Vector3(wave(turn)[0], rise(wave(turn)[1]), 0));
    close((turn) => new Vector3(0, rise(wave(turn)[1]), wave(turn)[0]));
    for (const height of half > 0 ? [-half, half] : [0]) close((turn) => new Vector3(wave(turn)[0], height, wave(turn)[1]));
    return new BufferGeometry().setFromPoints(points);
  }
}

function makeSurface() {
  return new MeshStandardMaterial({ roughness: 0.6, polygonOffset: true, polygonOffsetFactor: 1 });
}

function extent(points) {
  let largest = 0;
  for (let i = 3; i < points.length; i++) largest = Math.max(largest, Math.abs(points[i] - points[i % 3]));
  return largest;
}
