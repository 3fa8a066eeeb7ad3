import { listPlaces } from "./along.js";

// Tension and bending of rods in water and air, a number for the middle of each element; null without such rods. Names and form as
// data.quantities: { effective_tension, wall_tension, bending_moment, bending_curvature: { of, values, isScalar } }.
export function listTensions(data) {
  const { force, moment, curvature } = data.quantities;
  if (!force || !data.info.rods.some((_, rod) => isWet(data, rod))) return null;
  const tension = each(force, (values, at) => values[at]);
  const bending = (values, at) => Math.hypot(values[at + 1], values[at + 2]);
  const quantities = { effective_tension: tension };
  if (data.info.surroundings.wet.gravity) quantities.wall_tension = { ...tension, values: addPressures(data, tension.values) };
  if (moment) quantities.bending_moment = each(moment, bending);
  if (curvature) quantities.bending_curvature = each(curvature, bending);
  return quantities;
}

export function isWet(data, rod) {
  return (data.info.surroundings?.wet?.rods[rod]?.length ?? 0) > 0;
}

function each({ of, values }, take) {
  const numbers = new Float32Array(values.length / 3);
  for (let i = 0; i < numbers.length; i++) numbers[i] = take(values, 3 * i);
  return { of, values: numbers, isScalar: true };
}

// Of rows [place, number, …], by place: the numbers there, linear between rows.
function interpolate(rows, place) {
  let i = 1;
  while (i + 1 < rows.length && place > rows[i][0]) i++;
  if (rows.length === 1) return rows[0].slice(1);
  const [from, to] = [rows[i - 1], rows[i]];
  const part = to[0] > from[0] ? Math.min(Math.max((place - from[0]) / (to[0] - from[0]), 0), 1) : 1;
  return from.slice(1).map((number, k) => (1 - part) * number + part * to[k + 1]);
}

// The wall carries the effective tension and p_i A_i − p_o A_o; pressures grow with the depth below the surface at rest.
function addPressures(data, tensions) {
  const { rods, gravity: rows, surface } = data.info.surroundings.wet;
  const { values } = data.quantities.displacement;
  const size = data.reference.length;
  const cells = data.middles.length;
  const walls = Float32Array.from(tensions);
  const acting = Array.from(data.times, (time) => interpolate(rows, time)); // size of gravity, density of the water
  rods.forEach((sections, rod) => {
    if (sections.length === 0) return;
    const nodes = listPlaces(data, rod, "node");
    let next = 1;
    for (const { s, row: cell } of listPlaces(data, rod, "cell")) {
      const [area, contentsArea, contentsDensity, contentsPressure] = interpolate(sections, s);
      while (next + 1 < nodes.length && nodes[next].s < s) next++;
      const part = (s - nodes[next - 1].s) / (nodes[next].s - nodes[next - 1].s);
      data.times.forEach((_, frame) => {
        const height = ({ row }) => data.reference[3 * row + 2] + values[size * frame + 3 * row + 2];
        const depth = surface - (1 - part) * height(nodes[next - 1]) - part * height(nodes[next]);
        const [gravity, density] = acting[frame];
        const outside = density * gravity * Math.max(depth, 0);
        const inside = contentsPressure + contentsDensity * gravity * depth;
        walls[cells * frame + cell] += inside * contentsArea - outside * area;
      });
    }
  });
  return walls;
}
