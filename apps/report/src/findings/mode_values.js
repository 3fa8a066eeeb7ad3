import { formatNumber } from "../format.js";
import { unitOf } from "../units.js";

const roundOff = 1e-9; // of a damping ratio
const leastShare = 0.005; // of a mass, that is named
const directions = ["along x", "along y", "along z", "about x", "about y", "about z"];

export const titles = {
  modes: "modes of vibration",
  buckling: "buckling factors, by linear theory",
  eigenvalues: "eigenvalues",
};

// Of an eigenvalue, without round-off.
export function realPart(modes, i) {
  return Math.abs(modes.damping_ratio?.[i] ?? 1) > roundOff ? modes.growth[i] : 0;
}

// A mode in a few words: its frequency, growth or factor.
export function describeValue(modes, i) {
  const number = (value) => formatNumber(value, 6);
  if (modes.factor) return `factor ${number(modes.factor[i])}`;
  if (modes.damping_ratio) {
    if (modes.frequency[i] === 0) return `exp(${number(modes.growth[i])} t)`;
    const real = realPart(modes, i);
    return `f = ${number(modes.frequency[i])}${real === 0 ? "" : `, Re λ = ${number(real)}`}`;
  }
  return modes.growth?.[i] > 0 ? `grows by exp(${number(modes.growth[i])} t)` : `f = ${number(modes.frequency[i])}`;
}

// Columns of the list of a stage's modes: { name, unit, title, at(i) }.
export function listColumns(modes, units) {
  const rate = unitOf("1/time", units);
  const angular = unitOf("angle/time", units);
  const number = (values) => (i) => formatNumber(values[i], 6);
  if (modes.factor) return [{ name: "factor", unit: "", title: "on the loads", at: number(modes.factor) }];
  const columns = [
    { name: "f", unit: rate, title: "frequency, cycles per time", at: number(modes.frequency) },
    { name: modes.damping_ratio ? "Im λ" : "ω", unit: angular, title: "angular frequency", at: number(modes.omega) },
  ];
  if (modes.damping_ratio) {
    columns.push({ name: "Re λ", unit: rate, title: "rate of growth", at: (i) => formatNumber(realPart(modes, i), 5) });
    const ratio = (i) => (realPart(modes, i) === 0 ? 0 : modes.damping_ratio[i]);
    columns.push({ name: "damping", unit: "", title: "damping ratio, −Re λ/|λ|", at: (i) => formatNumber(ratio(i), 4) });
  } else if (modes.growth?.some((value) => value > 0)) {
    columns.push({ name: "growth", unit: rate, title: "of a mode that grows", at: (i) => (modes.growth[i] > 0 ? formatNumber(modes.growth[i], 5) : "") });
  }
  return columns;
}

// "61 % along y, 92 % about z": of the mass of the whole model.
export function describeMass(shares) {
  const named = shares.map((share, i) => [share, directions[i]]).filter(([share]) => share >= leastShare);
  return named.map(([share, direction]) => `${Math.round(100 * share)}\u00a0% ${direction.replace(" ", "\u00a0")}`).join(", ");
}
