import { BoxGeometry, CylinderGeometry, Group, Mesh, SphereGeometry, TubeGeometry } from "three";
import { Coil } from "./coil.js";
import { Profile } from "./profile.js";

// Shapes of joints, along x, in units of the size of a symbol.
const cylinder = (radius, length) => new CylinderGeometry(radius, radius, length, 28).rotateZ(Math.PI / 2);
const shapes = {
  ball: new SphereGeometry(0.95, 32, 24),
  knob: new SphereGeometry(0.6, 24, 16),
  sleeve: cylinder(0.8, 1.6),
  block: new BoxGeometry(1.8, 1.5, 1.5),
  weld: new BoxGeometry(1.7, 1.7, 1.7),
  pin: cylinder(0.32, 1), // of length 1, as rails
  edge: new BoxGeometry(1, 0.5, 0.5),
  cross: cylinder(0.42, 3.4),
  plate: new BoxGeometry(0.2, 5, 5),
};
const sleeveOf = { hinge: shapes.sleeve, cylinder: shapes.sleeve, screw: shapes.sleeve, slider: shapes.block };

export const slides = new Set(["cylinder", "slider", "screw"]);

function makePart(geometry, material, size) {
  const mesh = new Mesh(geometry, material);
  mesh.scale.setScalar(size);
  return mesh;
}

// Sleeves on the axis; of a hinge with the pin through them.
function makeSleeves(type, material, size, spots) {
  const sleeves = spots.map((x) => {
    const sleeve = makePart(sleeveOf[type], material, size);
    sleeve.position.x = x;
    return sleeve;
  });
  if (type === "hinge") sleeves.push(makeRail(type, material, size, spots[0] - 1.5 * size, spots.at(-1) + 1.5 * size));
  return sleeves;
}

// Where the sleeves are, along x.
function listSpots(type, size, [behind, before]) {
  if (!(type in sleeveOf) || Math.max(behind, before) < 1.5 * size) return [0];
  return [-behind - 0.8 * size, before + 0.8 * size];
}

// A bar along x between two places.
export function makeRail(type, material, size, first, last) {
  const group = new Group();
  const bar = new Mesh(type === "slider" ? shapes.edge : shapes.pin, material);
  bar.scale.set(last - first, size, size);
  bar.position.x = 0.5 * (first + last);
  group.add(bar);
  if (type === "screw") {
    const thread = new Mesh(makeThread(size, last - first), material);
    thread.position.x = first;
    group.add(thread);
  }
  return group;
}

function makeThread(size, length) {
  const turns = Math.min(Math.max(Math.round(length / (0.7 * size)), 3), 60);
  const curve = new Coil(0.36 * size, length, turns, 0);
  return new TubeGeometry(curve, 14 * turns, 0.1 * size, 5).rotateY(Math.PI / 2);
}

// The symbol of a joint: `body` in the axes of the joint, `cross` along the axis that B of a universal joint carries. `reach`: the
// distances behind and before the point at which the axis leaves the bodies around it. There are sleeves then, at the `spots`.
export function makeSymbol({ type, curve }, material, size, reach) {
  const body = new Group();
  const spots = listSpots(type, size, reach);
  let cross = null;
  if (type in sleeveOf) body.add(...makeSleeves(type, material, size, spots));
  if (type === "ball" || type === "sleeve") body.add(makePart(shapes.ball, material, size));
  if (type === "weld") body.add(makePart(shapes.weld, material, size));
  if (type === "generic") body.add(makePart(shapes.weld, material, 0.7 * size));
  if (type === "plane") body.add(makePart(shapes.plate, material, size), makePart(shapes.ball, material, 0.9 * size));
  if (type === "distance") body.add(makePart(shapes.knob, material, size));
  if (type === "cam") body.add(new Mesh(new TubeGeometry(new Profile(curve), 2 * curve.length, 0.25 * size, 8), material));
  if (type === "universal") {
    body.add(makePart(shapes.cross, material, size), makePart(shapes.knob, material, 1.2 * size));
    cross = makePart(shapes.cross, material, size);
  }
  return { body, cross, spots };
}

// The roller of a cam, along x; a knife edge is a thin one.
export function makeRoller(material, radius, size) {
  const roller = new Mesh(cylinder(1, 1), material);
  roller.scale.set(1.6 * size, Math.max(radius, 0.3 * size), Math.max(radius, 0.3 * size));
  return roller;
}

export const makeKnob = (material, size) => makePart(shapes.knob, material, size);
