import { readToml } from "./toml.js";
import { unitOf } from "./units.js";

const title = "Joints";
const behind = ["Gears", "Supports"]; // tables that come after it
const mostSleeves = 50;
// Of histories, and how the table names them.
const loads = [
  { quantities: ["force", "force_a"], name: "largest force" },
  { quantities: ["moment", "moment_a"], name: "largest moment" },
];

// The tables of the model, with sleeves among the joints, what each joint leaves free, and the largest force and moment of those
// that the deck's histories record.
export function listTables(data, units) {
  const { info } = data;
  const found = info.tables.find((table) => table.title === title);
  const table = found ?? { title, columns: ["", "type", "from", "to", "at", "axis"], rows: [], note: "" };
  const named = new Set(table.rows.map(([name]) => name));
  const sleeves = info.joints.filter(({ name, type }) => type === "sleeve" && !named.has(name));
  const rows = [...table.rows, ...sleeves.slice(0, mostSleeves).map((sleeve) => describeSleeve(sleeve, data))];
  if (rows.length === 0) return info.tables;
  const left = sleeves.length > mostSleeves ? `The first ${mostSleeves} of ${sleeves.length} sleeves.` : "";
  const full = { ...table, note: [table.note, left].filter(Boolean).join(" ") };
  const columns = [nameFreedoms(info), ...listLoads(info, rows, units)];
  full.columns = [...table.columns, ...columns.map(({ heading }) => heading)];
  full.rows = rows.map((row) => [...row, ...columns.map(({ valueOf }) => valueOf(row))]);
  if (found) return info.tables.map((other) => (other === found ? full : other));
  const isBehind = (other) => behind.includes(other.title);
  return [...info.tables.filter((other) => !isBehind(other)), full, ...info.tables.filter(isBehind)];
}

function nameFreedoms({ joints }) {
  const moved = new Set(joints.filter((joint) => joint.moved).map(({ name }) => name));
  const freedoms = new Map(joints.map((joint) => [joint.type, joint.leaves_free]));
  const valueOf = ([name, type]) => (freedoms.get(type) ?? "") + (moved.has(name) ? "; moved by a motor" : "");
  return { heading: "leaves free", valueOf };
}

// A column for each load that is known of any of the joints.
function listLoads(info, rows, units) {
  const joints = jointsOfHistories(info.deck);
  return loads.flatMap(({ quantities, name }) => {
    const largest = new Map();
    let unit = "";
    for (const { group, title: history, quantity, labels, columns, dimension } of info.charts) {
      const joint = joints.get(history);
      if (group !== "history" || !joint || !quantities.includes(quantity)) continue;
      const values = columns[labels.indexOf("magnitude")].filter(Number.isFinite);
      largest.set(joint, values.reduce((most, value) => Math.max(most, value), largest.get(joint) ?? 0));
      unit = unitOf(dimension, units);
      if (unit === dimension) unit = "";
    }
    if (!rows.some(([joint]) => largest.has(joint))) return [];
    return [{ heading: [name, unit].filter(Boolean).join(", "), valueOf: ([joint]) => largest.get(joint) ?? "" }];
  });
}

// What each history is of, by its name: the `at` of each [[history]] of a deck.
function jointsOfHistories(deck) {
  const tables = [];
  let texts = null;
  for (const { kind, text } of readToml(deck).flat()) {
    if (kind === "heading") {
      tables.push({ heading: text.replace(/\s/g, ""), texts: new Map() });
      texts = null;
    } else if (kind === "key" && tables.length > 0) {
      texts = [];
      tables.at(-1).texts.set(unquote(text), texts);
    } else if (kind === "text") {
      texts?.push(unquote(text));
    }
  }
  const histories = tables.filter(({ heading }) => heading === "[[history]]").map((table) => table.texts);
  return new Map(histories.map((table) => [table.get("name")?.[0], table.get("at")?.[0]]));
}

const unquote = (text) => text.replace(/^["']+|["']+$/g, "");

function describeSleeve(sleeve, data) {
  const [, end] = sleeve.ends;
  const place = placeOf(end, data);
  return [sleeve.name, sleeve.type, nameRod(sleeve, place, data), namePoint(end.node, data), `(${place.map(inDigits).join(", ")})`, ""];
}

// At t = 0; the arm of the ground is its place. Places of nodes have seven digits, a smaller arm is round-off.
function placeOf({ node, arm }, { reference }) {
  const start = node < 0 ? [0, 0, 0] : [...reference.subarray(3 * node, 3 * node + 3)];
  const least = 1e-6 * Math.max(...[...start, ...arm].map(Math.abs));
  return arm.map((part, i) => (Math.abs(part + start[i]) < least ? 0 : part + start[i]));
}

const inDigits = (number) => String(Number(number.toPrecision(6)));

// Of the rods that have the sleeve's node `around` the one whose nodes come nearest to its place.
function nameRod({ around }, place, data) {
  const nearest = new Map();
  const candidates = new Set();
  forEachNode(data, ({ rod, node }) => {
    if (node === around) candidates.add(rod);
    const distance = Math.hypot(...place.map((x, i) => x - data.reference[3 * node + i]));
    nearest.set(rod, Math.min(nearest.get(rod) ?? Infinity, distance));
  });
  const [rod] = [...candidates].sort((a, b) => nearest.get(a) - nearest.get(b));
  return data.info.rods[rod] ?? "";
}

// As decks name it: a body, or a point of a rod.
function namePoint(point, data) {
  if (point < 0) return "ground";
  const body = data.info.bodies.find(({ node }) => node === point);
  if (body) return body.name;
  const lengths = new Map();
  let found = null;
  forEachNode(data, ({ rod, node, s }) => {
    lengths.set(rod, Math.max(lengths.get(rod) ?? 0, s));
    if (node === point) found ??= { rod, s };
  });
  if (!found) return "";
  const name = data.info.rods[found.rod];
  const share = found.s / lengths.get(found.rod);
  return share === 0 ? `${name}.start` : share === 1 ? `${name}.end` : `${name}@${inDigits(share)}`;
}

// Nodes of all cells of rods, with their arc lengths.
function forEachNode({ offsets, connectivity, cellRods, arcLengths }, call) {
  for (let cell = 0; cell + 1 < offsets.length; cell++) {
    for (let i = offsets[cell]; cellRods[cell] >= 0 && i < offsets[cell + 1]; i++) {
      call({ rod: cellRods[cell], node: connectivity[i], s: arcLengths[i] });
    }
  }
}
