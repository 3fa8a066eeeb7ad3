import { listTimedStages, partAt } from "../findings/stages.js";
import { DoubleSide, Group, Mesh, MeshLambertMaterial, PlaneGeometry } from "three";

const cells = 56; // along each side of what is not flat
const nearby = 0.8; // of the model's size: a surface that is farther from it is not drawn

// The surface of the water, with its waves at the time shown, and the ground, in the stages in which they are there.
export class Surroundings {
  constructor({ info, times }, motion, size) {
    Object.assign(this, { times, motion, size });
    this.group = new Group();
    const { water, ground } = info.surroundings ?? {};
    this.stages = listTimedStages(info);
    this.sheets = [];
    if (water) this.add((x, y, time) => heightOfWater(water, x, y, time), { isCurved: water.waves.length > 0, isMoving: true, color: 0x2f7fd1, opacity: 0.28, stages: water.stages });
    if (ground) this.add((x, y) => heightOfGround(ground, x, y), { isCurved: !!ground.z, isMoving: false, color: 0x9a7b4f, opacity: 0.55, stages: ground.stages });
  }

  // `stages`: names of those in which it is there; null: all.
  add(height, { isCurved, isMoving, color, opacity, stages }) {
    const material = new MeshLambertMaterial({ color, opacity, transparent: true, depthWrite: false, side: DoubleSide });
    const mesh = new Mesh(new PlaneGeometry(), material);
    mesh.renderOrder = 1;
    this.sheets.push({ mesh, height, count: isCurved ? cells : 1, isMoving: isMoving && isCurved, stages });
  }

  // Below and above a box of the model; returns the box that shows the sheets as well.
  lay([least, largest]) {
    this.group.clear();
    const margin = 0.15 * Math.max(largest[0] - least[0], largest[1] - least[1], 0.5 * this.size);
    const box = [[...least], [...largest]];
    for (const sheet of this.sheets) {
      const [x0, x1, y0, y1] = [least[0] - margin, largest[0] + margin, least[1] - margin, largest[1] + margin];
      const geometry = new PlaneGeometry(x1 - x0, y1 - y0, sheet.count, sheet.count);
      geometry.translate((x0 + x1) / 2, (y0 + y1) / 2, 0);
      sheet.mesh.geometry.dispose();
      sheet.mesh.geometry = geometry;
      this.shape(sheet);
      this.showInStage(sheet);
      geometry.computeBoundingBox();
      const { min, max } = geometry.boundingBox;
      if (min.z > largest[2] + nearby * this.size || max.z < least[2] - nearby * this.size) continue;
      this.group.add(sheet.mesh);
      [x0, y0, min.z].forEach((x, i) => (box[0][i] = Math.min(box[0][i], x)));
      [x1, y1, max.z].forEach((x, i) => (box[1][i] = Math.max(box[1][i], x)));
    }
    return box;
  }

  get time() {
    const { frame, part } = this.motion;
    const next = Math.min(frame + 1, this.times.length - 1);
    return (1 - part) * this.times[frame] + part * this.times[next];
  }

  showInStage({ mesh, stages }) {
    mesh.visible = !stages || stages.includes(partAt(this.stages, this.time)?.name);
  }

  shape({ mesh, height }) {
    const { time } = this;
    const places = mesh.geometry.getAttribute("position");
    for (let i = 0; i < places.count; i++) places.setZ(i, height(places.getX(i), places.getY(i), time));
    places.needsUpdate = true;
    mesh.geometry.computeVertexNormals();
    mesh.geometry.computeBoundingSphere();
  }

  move() {
    for (const sheet of this.sheets) {
      this.showInStage(sheet);
      if (sheet.isMoving && sheet.mesh.parent) this.shape(sheet);
    }
  }
}

// Waves are [amplitude, kx, ky, frequency, phase]; they grow over `ramp`.
function heightOfWater({ surface, waves, ramp, ramp_start }, x, y, time) {
  const q = ramp > 0 ? Math.min(Math.max((time - ramp_start) / ramp, 0), 1) : 1;
  const share = q ** 3 * (10 - 15 * q + 6 * q * q);
  let height = surface;
  if (share === 0) return height;
  for (const [a, kx, ky, omega, phase] of waves) height += share * a * Math.cos(kx * x + ky * y - omega * time + phase);
  return height;
}

// A plane { point, normal }, or a grid { x, y, z, turn }, z row by row of x.
export function heightOfGround({ point, normal, x: xs, y: ys, z, turn }, x, y) {
  if (!z) return point[2] - (normal[0] * (x - point[0]) + normal[1] * (y - point[1])) / normal[2];
  const [i, p] = findPlace(xs, Math.cos(turn) * x + Math.sin(turn) * y);
  const [j, q] = findPlace(ys, Math.cos(turn) * y - Math.sin(turn) * x);
  const at = (i, j) => z[i + j * xs.length];
  return (1 - q) * ((1 - p) * at(i, j) + p * at(i + 1, j)) + q * ((1 - p) * at(i, j + 1) + p * at(i + 1, j + 1));
}

// The interval of increasing numbers that holds one, and where in it, from 0 to 1.
function findPlace(numbers, x) {
  let i = numbers.findIndex((number) => number > x) - 1;
  if (i === -2) i = numbers.length - 2;
  i = Math.min(Math.max(i, 0), numbers.length - 2);
  return [i, Math.min(Math.max((x - numbers[i]) / (numbers[i + 1] - numbers[i]), 0), 1)];
}
