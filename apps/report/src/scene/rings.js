import { shapeFunctions } from "./lagrange.js";

// Thin rods stay visible and thick ones slender, each enlarged as a whole, so that tapers stay; flat sections get a least
// thickness. With contact thick ones are drawn as they are. `factor` is what the first rod is multiplied by, 0 if it has no radii. They are two for each entry of connectivity.
export function limitRadii({ info, radii, offsets, cellRods }, size) {
  const largest = new Map();
  const visit = (apply) => {
    for (let cell = 0; cell + 1 < offsets.length; cell++) {
      const rod = cellRods[cell] < 0 ? `cell ${cell}` : cellRods[cell];
      for (let i = offsets[cell]; i < offsets[cell + 1]; i++) apply(2 * i, Math.max(radii[2 * i], radii[2 * i + 1]), rod);
    }
  };
  visit((i, larger, rod) => largest.set(rod, Math.max(larger, largest.get(rod) ?? 0)));
  const drawn = new Float32Array(radii.length);
  visit((i, larger, rod) => {
    const thickest = largest.get(rod);
    const wanted = Math.max(0.0035 * size, info.has_contact ? thickest : Math.min(0.022 * size, thickest));
    for (const k of [i, i + 1]) drawn[k] = thickest > 0 ? wanted * Math.max(radii[k] / thickest, 0.15 * (larger / thickest), 0.02) : wanted;
    drawn.factor = drawn.factor ?? (thickest > 0 ? wanted / thickest : 0);
  });
  drawn.factor = drawn.factor ?? 0;
  return drawn;
}

// How far around the rounded end of a tube its rings lie, from the end to nearly the tip; in radians.
const domeAngles = [0.4, 0.8, 1.15, 1.45];

// Rings along each cell: its own ends and, of curves, some between. cap: −1 or 1 where a tube ends; dome: the angle of a ring of
// the rounded end that a tube has where others meet it, so that no slit is left between them.
export function listRings(data) {
  const { connectivity, offsets } = data;
  const cells = offsets.length - 1;
  const ends = new Map();
  for (let cell = 0; cell < cells; cell++) {
    for (const end of [0, 1]) {
      const node = connectivity[offsets[cell] + end];
      ends.set(node, (ends.get(node) ?? 0) + 1);
    }
  }
  const follows = (cell) =>
    cell > 0 && cell < cells && connectivity[offsets[cell - 1] + 1] === connectivity[offsets[cell]] &&
    ends.get(connectivity[offsets[cell]]) === 2 && sameAxes(data, offsets[cell - 1] + 1, offsets[cell]);
  const meetsOthers = (node) => ends.get(node) > 1;
  const pieces = cells < 400 ? 10 : cells < 3000 ? 4 : 2;
  const rings = [];
  for (let cell = 0; cell < cells; cell++) {
    const nodes = offsets[cell + 1] - offsets[cell];
    const count = nodes === 2 ? 1 : pieces;
    const isEnd = [!follows(cell), !follows(cell + 1)];
    const isRound = isEnd.map((is, end) => is && meetsOthers(connectivity[offsets[cell] + end]));
    if (isRound[0]) rings.push(...makeDome(cell, shapeFunctions(nodes, -1), -1));
    for (let i = 0; i <= count; i++) {
      const cap = i === 0 && isEnd[0] && !isRound[0] ? -1 : i === count && isEnd[1] && !isRound[1] ? 1 : 0;
      rings.push({ cell, weights: shapeFunctions(nodes, (2 * i) / count - 1), cap, side: 0, dome: 0 });
    }
    if (isRound[1]) rings.push(...makeDome(cell, shapeFunctions(nodes, 1), 1));
  }
  return rings;
}

// From the start of a rod backwards, or from its end on; in the order of the rings along it.
function makeDome(cell, weights, side) {
  const rings = domeAngles.map((dome, i) => ({ cell, weights, cap: i === domeAngles.length - 1 ? side : 0, side, dome }));
  return side < 0 ? rings.reverse() : rings;
}

function sameAxes({ axes }, i, j) {
  let dot = 0;
  for (let k = 0; k < 4; k++) dot += axes[4 * i + k] * axes[4 * j + k];
  return Math.abs(dot) > 0.999;
}
