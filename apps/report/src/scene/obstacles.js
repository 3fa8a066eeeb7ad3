import {
  BufferAttribute, BufferGeometry, CapsuleGeometry, CatmullRomCurve3, CylinderGeometry, DoubleSide, EdgesGeometry, Group, LineBasicMaterial,
  LineSegments, Mesh, MeshLambertMaterial, PlaneGeometry, Quaternion, SphereGeometry, TubeGeometry, Vector3,
} from "three";
import { decode } from "../data.js";
import { Bounds, toQuaternion } from "./ends.js";
import { isWithin } from "./within.js";

const nearby = 0.6; // of the model's size: what is farther from it does not widen the view
const margin = 0.1; // likewise, for what is around the model
const y = new Vector3(0, 1, 0);
const z = new Vector3(0, 0, 1);

// What rods touch, clear, where it is in the frame shown.
export class Obstacles {
  constructor({ info, obstacles }, motion, size) {
    Object.assign(this, { motion, size, motions: obstacles });
    this.group = new Group();
    this.solid = makeMaterial(0.4);
    this.hollow = makeMaterial(0.2);
    this.edges = new LineBasicMaterial({ transparent: true, opacity: 0.5 });
    const list = info.obstacles ?? [];
    this.movedCount = list.filter(({ moved }) => moved >= 0).length;
    this.marks = list.map((obstacle, number) => ({ ...obstacle, number, about: new Vector3(...obstacle.about), place: new Vector3(), group: new Group() }));
    for (const mark of this.marks) this.group.add(mark.group);
  }

  // Around the nodes' box of all frames; returns the box that shows the obstacles, too.
  lay([least, largest]) {
    const bounds = new Bounds();
    bounds.include(new Vector3(...least));
    bounds.include(new Vector3(...largest));
    const centre = new Vector3(...least).add(new Vector3(...largest)).multiplyScalar(0.5);
    const reach = new Vector3(...largest).sub(centre).length();
    for (const mark of this.marks) {
      mark.group.clear();
      const geometry = this.shape(mark, centre, reach);
      if (!geometry) continue;
      const mesh = new Mesh(geometry, this.isAround(mark) ? this.hollow : this.solid);
      mesh.renderOrder = 2;
      mark.group.add(mesh, new LineSegments(outline(mark, geometry), this.edges));
      geometry.computeBoundingBox();
      const { min, max } = geometry.boundingBox;
      geometry.boundingBox.getCenter(mark.place);
      // Of what is large, the part next to the rods; of a plane, which has no end, its nearest point.
      const limit = (this.isAround(mark) ? margin : nearby) * Math.max(reach, 0.5 * this.size);
      if (mark.shape === "plane") {
        if (mark.farness <= reach + limit) bounds.include(mark.foot);
        continue;
      }
      const clip = (corner) => corner.clone().clampScalar(-1e30, 1e30).clamp(centre.clone().subScalar(reach + limit), centre.clone().addScalar(reach + limit));
      bounds.include(clip(min));
      bounds.include(clip(max));
    }
    this.move();
    return bounds.corners;
  }

  isAround({ hollow, shape }) {
    return hollow || shape === "mesh";
  }

  // Whether a point is inside one of them, where they are now.
  contain(point) {
    return this.marks.some((mark) => {
      const { position, quaternion } = mark.group;
      return isWithin(mark, point.clone().sub(position).applyQuaternion(quaternion.clone().invert()));
    });
  }

  shape(mark, centre, reach) {
    const points = mark.line.map((point) => new Vector3(...point));
    if (mark.shape === "plane") {
      const normal = new Vector3(...mark.normal);
      const distance = centre.clone().sub(points[0]).dot(normal);
      mark.farness = Math.abs(distance);
      mark.foot = centre.clone().addScaledVector(normal, -distance);
      const side = 2.3 * reach;
      const turn = Math.abs(normal.z) > 0.999 ? new Quaternion().setFromUnitVectors(z, normal) : uprightTurn(normal);
      return new PlaneGeometry(side, side).applyQuaternion(turn).translate(...mark.foot.toArray());
    }
    if (mark.shape === "mesh") return shapeMesh(mark);
    // All others are round about a point, a straight line or a curve.
    if (points.length === 1) return new SphereGeometry(mark.radius, 48, 32).translate(...points[0].toArray());
    return points.length === 2 ? shapeCylinder(mark, points, centre, reach) : shapeTube(mark, points);
  }

  move() {
    const { frame, part, frames } = this.motion;
    const shown = part < 0.5 ? frame : Math.min(frame + 1, frames - 1);
    for (const { moved, about, group } of this.marks) {
      if (moved < 0) continue;
      const at = 7 * (this.movedCount * shown + moved);
      const motion = Array.from(this.motions.subarray(at, at + 7));
      if (!motion.every(Number.isFinite)) continue;
      group.quaternion.copy(toQuaternion(motion.slice(3)));
      group.position.copy(about).sub(about.clone().applyQuaternion(group.quaternion)).add(new Vector3(...motion.slice(0, 3)));
    }
  }

  setColours(theme) {
    for (const material of [this.solid, this.hollow]) material.color.set(theme.obstacle);
    this.edges.color.set(theme.muted);
  }
}

function makeMaterial(opacity) {
  return new MeshLambertMaterial({ opacity, transparent: true, depthWrite: false, side: DoubleSide });
}

// From z to a normal, one side of the patch level.
function uprightTurn(normal) {
  const side = new Vector3().crossVectors(z, normal).normalize();
  const up = new Vector3().crossVectors(normal, side);
  const [a, b, c] = [side, up, normal].map((axis) => axis.toArray());
  const trace = a[0] + b[1] + c[2];
  const w = 0.5 * Math.sqrt(Math.max(0, 1 + trace));
  if (w < 1e-6) return new Quaternion().setFromUnitVectors(z, normal);
  return new Quaternion((b[2] - c[1]) / (4 * w), (c[0] - a[2]) / (4 * w), (a[1] - b[0]) / (4 * w), w);
}

// A solid one has round ends, a hollow one none: it is drawn as far as the rods are.
function shapeCylinder(mark, [from, to], centre, reach) {
  const { radius, hollow } = mark;
  const axis = to.clone().sub(from);
  const length = axis.length();
  axis.divideScalar(length);
  if (!hollow) return placeOnAxis(new CapsuleGeometry(radius, length, 12, 48, Math.min(64, Math.ceil(length / radius))), from.clone().add(to).multiplyScalar(0.5), axis);
  const middle = centre.clone().sub(from).dot(axis);
  const [start, end] = [Math.min(0, middle - reach), Math.max(length, middle + reach)];
  mark.span = [start, end];
  return placeOnAxis(new CylinderGeometry(radius, radius, end - start, 64, 1, true), from.clone().addScaledVector(axis, 0.5 * (start + end)), axis);
}

function placeOnAxis(geometry, middle, axis) {
  return geometry.applyQuaternion(new Quaternion().setFromUnitVectors(y, axis)).translate(...middle.toArray());
}

function shapeTube({ radius }, points) {
  return new TubeGeometry(new CatmullRomCurve3(points), 4 * points.length, radius, 32, false);
}

// None where the page has no room for it.
function shapeMesh(mark) {
  mark.corners ??= decode(`mesh-corners-${mark.number}`, Float32Array);
  mark.triangles ??= decode(`mesh-triangles-${mark.number}`, Int32Array);
  if (mark.triangles.length === 0) return null;
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(mark.corners, 3));
  geometry.setIndex(new BufferAttribute(new Uint32Array(mark.triangles), 1));
  geometry.computeVertexNormals();
  return geometry;
}

// The border of a patch, the ends of what is hollow, the edges of a mesh.
function outline({ shape, hollow, line }, geometry) {
  const isOpen = shape === "plane" || shape === "mesh" || (hollow && line.length > 1);
  return isOpen ? new EdgesGeometry(geometry, 60) : new BufferGeometry();
}
