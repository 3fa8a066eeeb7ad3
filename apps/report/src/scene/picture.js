import { Group, Vector3 } from "three";
import { Bodies } from "./bodies.js";
import { Centres } from "./centres.js";
import { makeReference, makeShapes, makeState } from "./centrelines.js";
import { ColourScale } from "./colours.js";
import { Bounds } from "./ends.js";
import { Contacts } from "./contacts.js";
import { makeGrid } from "./grid.js";
import { Joints } from "./joints.js";
import { rangeOf } from "../motion.js";
import { Obstacles } from "./obstacles.js";
import { PlaceMark } from "./place_mark.js";
import { Springs } from "./springs.js";
import { FailMarks, Loads, Supports } from "./symbols.js";
import { Stage } from "./stage.js";
import { Surroundings } from "./surroundings.js";
import { Tubes } from "./tubes.js";

// All that the 3D view shows.
export class Picture {
  constructor(canvas, data, motion) {
    this.data = data;
    this.motion = motion;
    this.stage = new Stage(canvas);
    this.stage.hides = (point) => this.parts.obstacles.contain(point);
    Object.assign(canvas, { motion: () => motion, picture: () => this }); // for tests
    this.size = measure(data, motion);
    const solid = { rods: new Tubes(data, motion, this.size), bodies: new Bodies(data, motion, this.size) };
    this.parts = {
      ...solid,
      centres: new Centres(data, solid.rods),
      joints: new Joints(data, motion, this.size, solid),
      springs: new Springs(data, motion, this.size),
      supports: new Supports(data, motion, this.size),
      loads: new Loads(data, motion, this.size),
      failure: new FailMarks(data, motion, this.size),
      obstacles: new Obstacles(data, motion, this.size),
      contacts: new Contacts(data, motion, this.size),
      surroundings: new Surroundings(data, motion, this.size),
      ...(data.info.sections ? { place: new PlaceMark(data, motion, { size: this.size, rods: solid.rods }) } : {}),
    };
    const { rods, bodies, ...marks } = this.parts;
    this.reference = makeReference(data);
    this.shapes = new Group();
    this.grid = new Group();
    this.ofRun = new Group().add(bodies.paths, this.reference, this.shapes); // what shows other times
    this.state = new Group(); // about which a shape swings
    this.isInState = false;
    this.stage.scene.add(rods.mesh, bodies.group, this.ofRun, this.state, this.grid);
    this.stage.scene.add(...Object.values(marks).map((mark) => mark.group));
    this.updateBox();
  }

  // Whether there is anything to colour.
  get hasColours() {
    return this.data.offsets.length > 1;
  }

  // Colours the rods by a component (3: the magnitude) of a quantity, or plainly. Returns the scale, if any.
  colourBy(name, component) {
    this.quantity = this.data.quantities[name];
    this.component = component;
    this.scale = this.quantity ? new ColourScale(widenRoundOff(this.quantity, component)) : null;
    const count = this.quantity?.of === "cell" ? this.data.offsets.length - 1 : this.motion.count;
    this.values = new Float32Array(count);
    this.paint();
    return this.scale;
  }

  // A shape that swings is plain.
  paint() {
    const scale = this.isInState ? null : this.scale;
    if (scale) this.motion.sample(this.quantity, this.component, this.values);
    this.parts.rods.paint(scale, this.quantity?.of, this.values);
    this.stage.draw();
  }

  // Marks a place along a rod, or none.
  markPlace(place, isVisible) {
    const mark = this.parts.place;
    if (!mark) return;
    if (isVisible) mark.choose(place.rod, place.s);
    mark.group.visible = isVisible && mark.ends !== null;
    this.stage.draw();
  }

  move(position) {
    if (this.isInState) return;
    this.motion.moveTo(position);
    this.moveParts();
    this.parts.bodies.showPathsUpTo(Math.round(position));
    this.paint();
  }

  moveParts() {
    for (const part of Object.values(this.parts)) part.move();
  }

  // From now on the nodes are where a shape about this state has them; loads are those of a frame. The bounds are
  // [least, largest] corners of all that the nodes reach.
  enterState({ places }, frame, bounds) {
    this.isInState = true;
    this.ofRun.visible = false;
    Object.assign(this.motion, { frame, part: 0 });
    replaceIn(this.state, makeState(this.data, places));
    this.state.visible = true;
    this.stateBounds = bounds;
    this.colourLines();
    this.showBox();
  }

  leaveState() {
    this.isInState = false;
    this.ofRun.visible = true;
    this.state.visible = false;
    this.showBox();
  }

  // After the nodes were placed.
  showState() {
    this.moveParts();
    this.paint();
  }

  // Turns to what is shown now, unless the reader has turned the view.
  showBox() {
    if (!this.isInState) this.stage.setBox(this.box);
    else this.stage.setBox(widenBox(this.stateBounds, 0.03 * this.size));
    if (!this.stage.isOwnView) this.resetView();
    else this.stage.draw();
  }

  // What depends on all frames; then the picture is that of the first.
  updateBox() {
    for (const part of [this.parts.joints, this.parts.springs]) part.survey();
    this.parts.bodies.trace();
    replaceIn(this.shapes, makeShapes(this.data, this.motion));
    this.move(0);
    this.box = this.parts.surroundings.lay(this.parts.obstacles.lay(this.boxOfAll()));
    this.stage.setBox(this.box);
    const { lines, step } = makeGrid(this.stage.box);
    this.gridStep = step;
    replaceIn(this.grid, lines);
    if (this.theme) this.colourLines();
  }

  // Of all frames: nodes and points of joints and springs.
  boundsOfPoints() {
    return joinBounds([this.motion.bounds(), this.parts.joints.bounds, this.parts.springs.bounds]);
  }

  // Of all frames; bodies, arrows of loads and thickness included.
  boxOfAll() {
    const [least, largest] = this.boundsOfPoints();
    const margin = 0.03 * this.size;
    return joinBounds([widenBox([least, largest], margin), this.parts.bodies.bounds(), this.parts.loads.bounds()]);
  }

  // Along the shortest side of what is flat, else obliquely from above; from the other side where an obstacle is in the way.
  resetView() {
    const [least, largest] = this.isInState ? this.stateBounds : this.boundsOfPoints();
    const sides = least.map((x, i) => largest[i] - x);
    const flat = sides.map((side, i) => side < 1e-3 * this.size && !this.parts.contacts.areAlong(i));
    const isBodyAlone = flat.every(Boolean); // or several about one point
    this.lookFreely(listViews(isBodyAlone ? [] : flat, sides));
  }

  // The first view from outside of all obstacles, or the one that steps back least.
  lookFreely(views) {
    let best = null;
    for (const view of views) {
      this.stage.look(...view);
      if (!best || this.stage.steps < best.steps) best = { view, steps: this.stage.steps };
      if (this.stage.steps === 0) return;
    }
    this.stage.look(...best.view);
  }

  setColours(theme) {
    this.theme = theme;
    this.parts.rods.plain.set(theme.rod);
    this.parts.bodies.setColours(theme);
    this.parts.joints.setColours(theme);
    this.parts.obstacles.setColours(theme);
    this.parts.place?.material.color.set(theme.bad);
    this.colourLines();
    this.paint();
  }

  colourLines() {
    this.reference.material.color.set(this.theme.ink);
    for (const lines of [...this.shapes.children, ...this.state.children]) lines.material.color.set(this.theme.muted);
    for (const grid of this.grid.children) grid.material.color.set(this.theme.line);
  }
}

// Directions and what is up in them: the best one first, then those from the other sides.
export function listViews(flat, sides) {
  if (flat[2]) return [[[0, 0, -1], [0, 1, 0]], [[0, 0, 1], [0, 1, 0]]];
  if (flat[1]) return [1, -1].map((y) => [[0, y, 0], [0, 0, 1]]);
  if (flat[0]) return [-1, 1].map((x) => [[x, 0, 0], [0, 0, 1]]);
  const [x, y] = sides[0] >= sides[1] ? [-0.38, 1] : [-1, -0.38];
  const above = [[x, y], [-x, y], [x, -y], [-x, -y]].map(([x, y]) => [[x, y, -0.42], [0, 0, 1]]);
  const along = [[[-1, 0, 0], [0, 0, 1]], [[0, 1, 0], [0, 0, 1]], [[0, 0, -1], [0, 1, 0]]];
  return [...above, ...above.map(([[x, y, z], up]) => [[x, y, -z], up]), ...along];
}

// [least, largest] corners around boxes, of which some may be empty.
function joinBounds(boxes) {
  const over = (corner, choose) => [0, 1, 2].map((i) => choose(...boxes.map((box) => box[corner][i])));
  return [over(0, Math.min), over(1, Math.max)];
}

function widenBox([least, largest], margin) {
  return [least.map((x) => x - margin), largest.map((x) => x + margin)];
}

// Relative to the magnitude: less is round-off of single precision, and gets one colour.
const roundOff = 1e-6;

function widenRoundOff(quantity, component) {
  const [least, largest] = rangeOf(quantity, component);
  const height = roundOff * rangeOf(quantity, 3)[1];
  return Math.max(-least, largest) < height ? [-height, height] : [least, largest];
}

function replaceIn(group, lines) {
  for (const child of group.children) {
    child.geometry.dispose();
    child.material.dispose();
  }
  group.clear();
  group.add(lines);
}

// The largest side of what the nodes and the points of joints and springs pass through and, of bodies that turn on the spot, of
// themselves.
function measure(data, motion) {
  const [least, largest] = joinBounds([motion.bounds(), boundsOfEnds(data)]);
  const path = Math.hypot(...least.map((x, i) => largest[i] - x));
  const bodies = data.info.bodies.map((body) => 2.5 * (body.reach ?? Math.max(...body.half_sizes) + Math.hypot(...body.centre)));
  return Math.max(path, ...bodies) || 1;
}

// At t = 0.
function boundsOfEnds({ info, reference }) {
  const bounds = new Bounds();
  for (const { node, arm } of [...info.joints, ...info.springs, ...info.bushings].flatMap(({ ends }) => ends)) {
    const place = new Vector3(...arm);
    bounds.include(node < 0 ? place : place.add(new Vector3().fromArray(reference, 3 * node)));
  }
  return bounds.corners;
}
