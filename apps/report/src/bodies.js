import {
  BoxGeometry, BufferAttribute, BufferGeometry, EdgesGeometry, Group, Line, LineBasicMaterial, LineSegments, Mesh,
  MeshStandardMaterial, Quaternion, Vector3,
} from "three";
import { makeArrow } from "./arrows.js";
import { axisColours } from "./theme.js";

const mostPaths = 100;
const axes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
const toQuaternion = ([w, x, y, z]) => new Quaternion(x, y, z, w);

// Rigid bodies: the cuboid of their mass and inertia, the body axes, an arm from the node to the centre of mass, and the
// path.
export class Bodies {
  constructor(data, motion, size) {
    this.motion = motion;
    this.group = new Group();
    this.paths = new Group();
    this.bodies = data.info.bodies.map((body) => this.makeBody(body, size));
    this.lines = this.bodies.slice(0, mostPaths).map(() => this.makePath(data.times.length));
  }

  makeBody(body, size) {
    const group = new Group();
    const half = body.half_sizes;
    const largest = Math.max(...half);
    const drawn = largest > 0 ? Math.max(largest, 0.015 * size) : 0.02 * size;
    const sides = half.map((h) => 2 * Math.max(largest > 0 ? h * (drawn / largest) : drawn, 0.04 * drawn));
    const box = new BoxGeometry(...sides);
    const cuboid = new Mesh(box, this.surface());
    const edges = new LineSegments(new EdgesGeometry(box), new LineBasicMaterial({ transparent: true, opacity: 0.6 }));
    this.edgeMaterials = [...(this.edgeMaterials ?? []), edges.material];
    const centre = new Vector3(...body.centre);
    for (const part of [cuboid, edges]) {
      part.position.copy(centre);
      part.quaternion.copy(toQuaternion(body.axes));
      group.add(part);
    }
    axes.forEach((axis, i) => {
      const arrow = makeArrow(axisColours[i], 0.9 * Math.max(...sides) + 0.02 * size, 0.0018 * size + 0.006 * Math.max(...sides));
      arrow.position.copy(centre);
      arrow.quaternion.setFromUnitVectors(axes[2], axis);
      group.add(arrow);
    });
    if (centre.length() > 0) {
      const arm = new BufferGeometry().setFromPoints([new Vector3(), centre]);
      group.add(new Line(arm, edges.material));
    }
    this.group.add(group);
    return { ...body, group, centre, attitude: toQuaternion(body.attitude), reach: Math.max(...sides) };
  }

  surface() {
    this.material = this.material ?? new MeshStandardMaterial({ roughness: 0.6, polygonOffset: true, polygonOffsetFactor: 1 });
    return this.material;
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
      const room = 0.75 * this.bodies[body].reach;
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
    this.surface().color.set(theme.body);
    for (const material of this.edgeMaterials ?? []) material.color.set(theme.ink);
    for (const line of this.lines) line.material.color.set(theme.path);
  }
}

function extent(points) {
  let largest = 0;
  for (let i = 3; i < points.length; i++) largest = Math.max(largest, Math.abs(points[i] - points[i % 3]));
  return largest;
}
