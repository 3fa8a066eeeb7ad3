import { decode } from "../data.js";

const numbersOfRow = 11; // of an envelope: value, time, y, z, layer, six resultants

// Sections with their stresses and envelopes along rods, { sections, cellSections, envelopes }; null if the run has none.
export function readStresses(info) {
  const sections = (info.sections ?? []).map(readSection);
  const envelopes = info.envelopes ? readEnvelopes(info.envelopes) : null;
  if (sections.length === 0 && !envelopes) return null;
  return { sections, cellSections: decode("cell-sections", Int32Array), envelopes };
}

// Points of stresses (y, z), their layers and operators, and of each cell the points of its corners.
function readSection(section, i) {
  const read = (part, Type) => decode(`section-${part}-${i}`, Type);
  return {
    ...section,
    cells: read("cells", Int32Array),
    points: read("points", Float32Array),
    pointLayers: read("layers", Int32Array),
    singular: read("singular", Int32Array),
    operators: read("operators", Float32Array),
  };
}

// Rows of each quantity, and of each rod its rows from start to end.
function readEnvelopes({ criterion, quantities }) {
  const rods = decode("envelope-rods", Int32Array);
  const places = decode("envelope-places", Float32Array);
  const sections = decode("envelope-sections", Int32Array);
  const rows = Object.fromEntries(quantities.map((name) => [name, decode(`envelope-${name}`, Float32Array)]));
  const ofRod = new Map();
  rods.forEach((rod, row) => {
    if (!ofRod.has(rod)) ofRod.set(rod, []);
    ofRod.get(rod).push(row);
  });
  return { criterion, names: quantities, rows, rods, places, sections, ofRod };
}

// A row of a quantity of the envelopes.
export function readWorst({ rows, places, rods, sections }, name, row) {
  const at = numbersOfRow * row;
  const [value, time, y, z, layer, ...resultants] = rows[name].subarray(at, at + numbersOfRow);
  return { row, name, rod: rods[row], s: places[row], section: sections[row], value, time, y, z, layer, resultants };
}

// Of each rod that has stresses the place with the largest value, the rod with the largest one first.
export function listWorst(envelopes, name) {
  const worst = [];
  for (const rows of envelopes.ofRod.values()) {
    const value = (row) => envelopes.rows[name][numbersOfRow * row];
    const found = rows.reduce((best, row) => (value(row) > value(best) || !Number.isFinite(value(best)) ? row : best), rows[0]);
    if (Number.isFinite(value(found))) worst.push(readWorst(envelopes, name, found));
  }
  return worst.sort((a, b) => b.value - a.value);
}

export function hasStrength(envelopes) {
  return (envelopes?.rows.exposure ?? []).some((value, i) => i % numbersOfRow === 0 && value > 0);
}
