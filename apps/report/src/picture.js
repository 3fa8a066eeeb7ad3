import { BufferGeometry, Float32BufferAttribute, GridHelper, Group, LineBasicMaterial, LineSegments } from "three";
import { Bodies } from "./bodies.js";
import { ColourScale } from "./colours.js";
import { rangeOf } from "./motion.js";
import { FailMarks, Loads, Supports } from "./symbols.js";
import { Stage } from "./stage.js";
import { Tubes } from "./tubes.js";

// All that the 3D view shows.
export class Picture {
  constructor(canvas, data, motion) {
    this.data = data;
    this.motion = motion;
    this.stage = new Stage(canvas);
    this.size = measure(data, motion);
    this.parts = {
      rods: new Tubes(data, motion, this.size),
      bodies: new Bodies(data, motion, this.size),
      supports: new Supports(data, motion, this.size),
      loads: new Loads(data, motion, this.size),
      failure: new FailMarks(data, motion, this.size),
    };
    const { rods, bodies, ...marks } = this.parts;
    this.reference = makeReference(data);
    this.grid = new Group();
    this.stage.scene.add(rods.mesh, bodies.group, bodies.paths, this.reference, this.grid);
    this.stage.scene.add(...Object.values(marks).map((mark) => mark.group));
    this.updateBox();
  }

  // Colours the rods by a component (3: the size) of a quantity, or plainly. Returns the scale, if any.
  colourBy(name, component) {
    this.quantity = this.data.quantities[name];
    this.component = component;
    this.scale = this.quantity ? new ColourScale(rangeOf(this.quantity, component)) : null;
    const count = this.quantity?.of === "cell" ? this.data.offsets.length - 1 : this.motion.count;
    this.values = new Float32Array(count);
    this.paint();
    return this.scale;
  }

  paint() {
    if (this.scale) this.motion.sample(this.quantity, this.component, this.values);
    this.parts.rods.paint(this.scale, this.quantity?.of, this.values);
    this.stage.draw();
  }

  move(position) {
    this.motion.moveTo(position);
    for (const part of Object.values(this.parts)) part.move();
    this.parts.bodies.showPathsUpTo(Math.round(position));
    this.paint();
  }

  updateBox() {
    this.stage.setBox(this.boxOfAll());
    this.placeGrid();
  }

  // Of all frames, bodies and thickness included.
  boxOfAll() {
    const [least, largest] = this.motion.bounds();
    const margin = 0.03 * this.size;
    const bodies = this.parts.bodies.bodies;
    const reach = Math.max(0, ...bodies.map((body) => body.centre.length() + 0.8 * body.reach));
    const room = Math.max(margin, reach);
    return [least.map((x) => x - room), largest.map((x) => x + room)];
  }

  // Along the shortest side of what is flat, else from above and beside.
  resetView() {
    const [least, largest] = this.motion.bounds();
    const sides = least.map((x, i) => largest[i] - x);
    const flat = sides.map((side) => side < 1e-3 * this.size);
    const isBodyAlone = sides.every((side) => side === 0);
    if (!isBodyAlone && flat[2]) this.stage.look([0, 0, -1], [0, 1, 0]);
    else if (!isBodyAlone && flat[1]) this.stage.look([0, 1, 0], [0, 0, 1]);
    else if (!isBodyAlone && flat[0]) this.stage.look([-1, 0, 0], [0, 0, 1]);
    else this.stage.look([-0.62, 1, -0.55], [0, 0, 1]);
  }

  // Below all that moves, in a step of 1, 2 or 5.
  placeGrid() {
    const [least, largest] = [this.stage.box[0], this.stage.box[1]];
    const span = Math.max(largest.x - least.x, largest.y - least.y, 1e-30);
    const power = 10 ** Math.floor(Math.log10(span / 4));
    this.gridStep = power * [1, 2, 5, 10].find((step) => step * power >= span / 8);
    const count = 2 * Math.ceil((0.6 * span) / this.gridStep);
    const grid = new GridHelper(count * this.gridStep, count);
    grid.material.transparent = true;
    grid.material.opacity = 0.55;
    grid.material.vertexColors = false;
    grid.rotation.x = Math.PI / 2;
    const snap = (x) => Math.round(x / this.gridStep) * this.gridStep;
    grid.position.set(snap(this.stage.centre.x), snap(this.stage.centre.y), least.z);
    this.grid.clear();
    this.grid.add(grid);
    if (this.theme) grid.material.color.set(this.theme.line);
  }

  setColours(theme) {
    this.theme = theme;
    this.parts.rods.plain.set(theme.rod);
    this.parts.bodies.setColours(theme);
    this.reference.material.color.set(theme.muted);
    for (const grid of this.grid.children) grid.material.color.set(theme.line);
    this.paint();
  }
}

// The largest side of what the nodes pass through and, of bodies that turn on the spot, of themselves.
function measure(data, motion) {
  const [least, largest] = motion.bounds();
  const path = Math.hypot(...least.map((x, i) => largest[i] - x));
  const bodies = data.info.bodies.map((body) => 2.5 * (Math.max(...body.half_sizes) + Math.hypot(...body.centre)));
  return Math.max(path, ...bodies) || 1;
}

// The centreline at t = 0.
function makeReference(data) {
  const { connectivity, offsets, reference } = data;
  const points = [];
  for (let cell = 0; cell + 1 < offsets.length; cell++) {
    const [start, end, ...between] = connectivity.subarray(offsets[cell], offsets[cell + 1]);
    const line = [start, ...between, end];
    for (let i = 0; i + 1 < line.length; i++) {
      for (const node of [line[i], line[i + 1]]) points.push(...reference.subarray(3 * node, 3 * node + 3));
    }
  }
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  return new LineSegments(geometry, new LineBasicMaterial({ transparent: true, opacity: 0.7 }));
}
