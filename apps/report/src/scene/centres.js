import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Points, PointsMaterial } from "three";
import { make } from "../elements.js";
import { symbolColours } from "../theme.js";

const kinds = { shear: "shear centre", tension: "tension centre", mass: "centre of mass" };
const reach = 1.7; // of principal axes, in semi-axes of the section as drawn

// Of rods whose sections have centres off the line or turned axes: a line through each kind of centre, and the principal axes of
// bending at the rod's ends. Offsets are as much larger than true as the section is; lines shine through the tube.
export class Centres {
  constructor({ info, cellRods, offsets, arcLengths, radii }, rods) {
    this.rods = rods;
    this.group = new Group();
    const stationsOf = new Map(info.centres.map(({ rod, stations }) => [rod, stations]));
    this.places = rods.rings.flatMap((ring, index) => {
      const stations = stationsOf.get(cellRods[ring.cell]);
      if (!stations || ring.side !== 0) return [];
      const s = ring.weights.reduce((sum, w, j) => sum + w * arcLengths[offsets[ring.cell] + j], 0);
      const larger = Math.max(...[0, 1].map((axis) => rods.radiusOf(ring, radii, axis)));
      const enlarged = larger > 0 ? Math.max(...ring.radii) / larger : 1;
      return [{ index, rod: cellRods[ring.cell], cell: ring.cell, radii: ring.radii, enlarged, centres: findCentres(stations, s) }];
    });
    this.lines = Object.keys(kinds)
      .filter((kind) => this.places.some(({ centres }) => centres[kind]))
      .map((kind) => ({ kind, ...this.add(symbolColours[kind], this.places.length) }));
    this.ends = this.places.filter(({ rod }, i) => rod !== this.places[i - 1]?.rod || rod !== this.places[i + 1]?.rod);
    this.axes = this.add(symbolColours.principal, 4 * this.ends.length, true);
  }

  // Points, and segments between neighbours of one cell, or between pairs.
  add(color, count, arePairs = false) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * count), 3));
    const index = [];
    for (let i = 0; i + 1 < count; i++) {
      if (arePairs ? i % 2 === 0 : this.places[i].cell === this.places[i + 1].cell) index.push(i, i + 1);
    }
    geometry.setIndex(index);
    const look = { color, depthTest: false, transparent: true };
    const parts = [new LineSegments(geometry, new LineBasicMaterial(look))];
    if (!arePairs) {
      const points = new BufferGeometry().setAttribute("position", geometry.attributes.position);
      parts.push(new Points(points, new PointsMaterial({ ...look, size: 4, sizeAttenuation: false })));
    }
    for (const part of parts) {
      part.frustumCulled = false;
      part.renderOrder = 5;
      this.group.add(part);
    }
    return { places: geometry.attributes.position };
  }

  // After the rods, whose rings it follows.
  move() {
    for (const { kind, places } of this.lines) {
      this.places.forEach((place, i) => this.put(place, place.centres[kind] ?? [0, 0], place.enlarged, places, i));
      places.needsUpdate = true;
    }
    this.ends.forEach((place, i) => this.putAxes(place, 4 * i));
    this.axes.places.needsUpdate = true;
  }

  // A point (y, z) of the section at a place, multiplied by a factor.
  put({ index }, [y, z], factor, places, at) {
    const [cx, cy, cz, yx, yy, yz, zx, zy, zz] = this.rods.frames.subarray(9 * index, 9 * index + 9);
    const a = y * factor * this.rods.thickness;
    const b = z * factor * this.rods.thickness;
    places.setXYZ(at, cx + a * yx + b * zx, cy + a * yy + b * zy, cz + a * yz + b * zz);
  }

  // Through the tension centre.
  putAxes(place, at) {
    const { centres, enlarged, radii } = place;
    const [y, z] = centres.tension.map((x) => x * enlarged);
    const [c, s] = [Math.cos(centres.turn), Math.sin(centres.turn)];
    [[c, s], [-s, c]].forEach(([dy, dz], axis) => {
      const length = reach * Math.max(radii[axis], 0.5 * radii[1 - axis]);
      this.put(place, [y - length * dy, z - length * dz], 1, this.axes.places, at + 2 * axis);
      this.put(place, [y + length * dy, z + length * dz], 1, this.axes.places, at + 2 * axis + 1);
    });
  }

  // What the colours are.
  makeLegend() {
    const words = [...this.lines.map(({ kind }) => [symbolColours[kind], kinds[kind]]), [symbolColours.principal, "principal axes of bending"]];
    return words.map(([colour, text]) => {
      const key = make("span", { className: "key" }, make("i"), text);
      key.style.setProperty("--series", colour);
      return key;
    });
  }
}

// Between stations in proportion to the arc length.
function findCentres(stations, s) {
  const next = stations.findIndex((station) => station.s >= s);
  if (next <= 0) return next < 0 ? stations[stations.length - 1] : stations[0];
  const [a, b] = [stations[next - 1], stations[next]];
  const t = b.s > a.s ? (s - a.s) / (b.s - a.s) : 1;
  const mix = (x, y) => x && y && x.map((value, i) => (1 - t) * value + t * y[i]);
  return { shear: mix(a.shear, b.shear), tension: mix(a.tension, b.tension), mass: mix(a.mass, b.mass), turn: (1 - t) * a.turn + t * b.turn };
}
