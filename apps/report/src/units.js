// Units of what the deck's label names, "m kg s", "mm N s", "m kN", in any order.

const names = {
  length: ["m", "mm", "cm", "dm", "km", "µm", "um", "in", "ft"],
  time: ["s", "ms", "min", "h"],
  mass: ["kg", "g", "mg", "t", "slug", "lbm"],
  force: ["N", "kN", "MN", "mN", "lbf", "kip", "dyn"],
};
// What mass × length / time² is called, where it has a name.
const forceNames = { "kg m s": "N", "t m s": "kN", "t mm s": "N", "g mm ms": "N", "kg mm ms": "kN", "g cm s": "dyn", "slug ft s": "lbf" };
const superscripts = { 2: "²", 3: "³", 4: "⁴" };

// For length, time, mass, force and angle, as far as the label names them: a product [[unit, power], …]. null if the label says
// anything else, or a unit twice.
export function readUnits(label) {
  const words = {};
  for (const word of (label ?? "").trim().split(/[\s,;·]+/)) {
    const kind = Object.keys(names).find((candidate) => names[candidate].includes(word));
    if (!kind || words[kind]) return null;
    words[kind] = word;
  }
  const { length, time, mass, force } = words;
  const units = Object.fromEntries(Object.entries(words).map(([kind, word]) => [kind, [[word, 1]]]));
  units.angle = [["rad", 1]];
  if (!length || !time) return units;
  const forceName = forceNames[`${mass} ${length} ${time}`];
  if (mass && !force) units.force = forceName ? [[forceName, 1]] : [[mass, 1], [length, 1], [time, -2]];
  if (force && !mass) units.mass = [[force, 1], [time, 2], [length, -1]];
  return units;
}

// "N·m" for "force·length", "m/s²" for "length/time²"; the dimension itself where a unit of it is not known, but for angles, which
// are in rad.
export function unitOf(dimension, units) {
  if (!dimension || dimension === "1") return "";
  const powers = new Map();
  for (const [i, part] of dimension.split("/").entries()) {
    for (const factor of part.split("·")) {
      const isSquare = factor.endsWith("²");
      const unit = units?.[isSquare ? factor.slice(0, -1) : factor];
      if (!unit) return dimension.replace("angle", "rad");
      for (const [name, power] of unit) powers.set(name, (powers.get(name) ?? 0) + power * (isSquare ? 2 : 1) * (i > 0 ? -1 : 1));
    }
  }
  const write = (sign) =>
    [...powers].filter(([, power]) => sign * power > 0).map(([name, power]) => name + (superscripts[sign * power] ?? "")).join("·");
  const below = write(-1);
  return (write(1) || "1") + (below && `/${below}`);
}
