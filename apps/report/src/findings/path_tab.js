import { make } from "../elements.js";
import { nameAcross } from "../charts/plot_axes.js";
import { Plot } from "../figures/plot.js";
import { formatNumber, inWords } from "../format.js";
import { addSvgKey } from "../saving/svg.js";
import { unitOf } from "../units.js";
import { PathFigure, describePoint, marks } from "./path_figure.js";
import { nearestRow } from "./stages.js";

const roundOff = 1e-6; // of the largest change: components that change by less are not offered
const colours = 6; // of branches, in the style sheet

// The path of one stage: a chart of any two quantities, and its critical points. Pressing a point shows its shape.
export class PathTab {
  constructor(path, { rows, clock, swinging, units, timeName }) {
    Object.assign(this, { path, rows, clock, swinging });
    this.quantities = listQuantities(path, rows, units, timeName);
    this.branches = listBranches(path, rows);
    this.x = this.makeMenu("Across", this.quantities.findIndex(({ isFirst }) => isFirst));
    this.y = this.makeMenu("Up", 0);
    this.body = make("div", { className: "figure tall" });
    this.attention = { pointed: -1, chosen: -1, listen() {}, point() {}, choose: (row) => this.goTo(row) };
    this.plot = new Plot(this.body, this.attention, () => []);
    this.body.figure = () => this.plot.figure; // for tests
    this.element = make("section", { className: "chart" }, this.makeChoices(), this.makeKeys(), this.body, this.makePoints());
    const titleOf = () => [this.y, this.x].map((menu) => menu.selectedOptions[0].textContent).join(" over ");
    addSvgKey(this.element, () => this.plot.plot, { titleOf });
    clock.listen(() => this.follow());
    swinging?.listen(() => this.follow());
    this.show();
  }

  makeMenu(name, chosen) {
    const options = this.quantities.map(({ name: text }, i) => make("option", { value: String(i) }, text));
    const menu = make("select", { "aria-label": name }, ...options);
    menu.value = String(Math.max(chosen, 0));
    menu.addEventListener("change", () => this.show());
    return menu;
  }

  makeChoices() {
    return make("div", { className: "along-choices path" }, this.y, make("span", { className: "over" }, "over"), this.x);
  }

  makeKeys() {
    const line = (name, className) => make("span", { className: `key ${className}` }, make("i"), name);
    const keys = [line("stable", "stable"), line("unstable", "unstable")];
    const kinds = new Set(this.path.points.map(({ kind }) => kind));
    for (const [kind, { symbol, words }] of Object.entries(marks)) {
      if (kinds.has(kind)) keys.push(make("span", { className: "key" }, `${symbol} ${words}`));
    }
    if (this.branches.length > 1) keys.push(...this.branches.map((branch) => this.makeBranchKey(branch)));
    return make("div", { className: "keys" }, ...keys);
  }

  makeBranchKey(branch) {
    const key = make("button", { className: "key", type: "button", title: branch.cause }, make("i"), branch.name);
    key.style.setProperty("--series", branch.property);
    key.setAttribute("aria-pressed", "true");
    key.addEventListener("click", () => {
      branch.isHidden = !branch.isHidden;
      key.setAttribute("aria-pressed", String(!branch.isHidden));
      this.show();
    });
    return key;
  }

  makePoints() {
    const { points } = this.path;
    if (points.length === 0) return make("p", { className: "note" }, "No critical point was found on this path.");
    const items = points.map((point, i) => {
      const go = make("button", { className: "go", type: "button" }, make("i", {}, marks[point.kind]?.symbol ?? "●"), make("span", {}, describePoint(point)));
      go.addEventListener("click", () => this.goTo(point.row));
      return make("li", {}, go, ...this.makeShapeKeys(point, i));
    });
    return make("ul", { className: "critical" }, ...items);
  }

  // A button for each shape in which the structure gives way at a point.
  makeShapeKeys(point, number) {
    const count = Math.min(point.shapes, (this.path.shapes?.count ?? 0) - point.first_shape);
    return Array.from({ length: Math.max(count, 0) }, (_, i) => {
      const key = make("button", { className: "swing", type: "button" }, count > 1 ? `shape ${i + 1}` : "shape");
      const text = `${marks[point.kind]?.words ?? point.kind} at λ = ${formatNumber(point.load_factor, 6)}`;
      this.swinging?.bind(key, { shapes: this.path.shapes, index: point.first_shape + i, row: point.row, title: `point ${number + 1}`, text, words: point.words });
      key.hidden = !this.swinging;
      return key;
    });
  }

  goTo(row) {
    this.clock.playing = false;
    this.clock.goToTime(this.rows.times[row]);
  }

  show() {
    const [x, y] = [this.x, this.y].map((menu) => this.quantities[Number(menu.value)]);
    this.plot.show(new PathFigure({ branches: this.branches, points: this.path.points, x, y, rows: this.rows }));
    this.follow();
  }

  // The ring is at the equilibrium that the picture shows.
  follow() {
    const swung = this.swinging?.chosen;
    this.attention.chosen = swung && swung.shapes === this.path.shapes ? swung.row : nearestRow(this.path, this.rows, this.clock.time);
    this.plot.placeRings();
  }

  recolour() {
    this.plot.redraw();
  }
}

// The load factor, components of the histories that change, and what counts along the path.
function listQuantities({ first, count }, rows, units, timeName) {
  const say = (value, digits) => formatNumber(value, digits);
  const quantities = [{ name: "load factor λ", values: rows.loads, say }];
  let best = null;
  for (const { title, quantity, dimension, labels, columns } of rows.charts) {
    const spreads = columns.map((column) => spreadOf(column.subarray(first, first + count)));
    const largest = Math.max(...spreads);
    labels.forEach((label, i) => {
      if (!(spreads[i] > roundOff * largest)) return;
      const unit = unitOf(dimension, units);
      const name = `${title}: ${inWords(quantity)}${labels.length > 1 ? ` ${inWords(label)}` : ""}${unit ? `, ${unit}` : ""}`;
      const entry = { name, values: columns[i], say };
      quantities.push(entry);
      const rank = [quantity === "displacement" || quantity === "position" ? 1 : 0, label === "magnitude" ? 0 : 1, spreads[i]];
      if (!best || compare(rank, best.rank) > 0) best = { entry, rank };
    });
  }
  const along = { name: nameAcross(timeName, units), values: rows.times, say };
  quantities.push(along);
  (best?.entry ?? along).isFirst = true;
  return quantities;
}

function compare(a, b) {
  const i = a.findIndex((value, k) => value !== b[k]);
  return i < 0 ? 0 : a[i] - b[i];
}

function spreadOf(values) {
  let [least, largest] = [Infinity, -Infinity];
  for (const value of values) {
    if (value < least) least = value;
    if (value > largest) largest = value;
  }
  return largest - least;
}

// The main path and the branches, each with its rows; a branch starts at the critical point where it leaves. What follows a
// point is stable if its tangent has no negative pivot.
function listBranches({ stage, first, count, paths, points }, rows) {
  const own = new Map();
  for (let row = first; row < first + count; row++) {
    const branch = rows.branches[row];
    if (!own.has(branch)) own.set(branch, []);
    own.get(branch).push(row);
  }
  return [...own.keys()].sort((a, b) => a - b).map((number) => {
    const { name, parent = -1, critical_point: point = -1, cause } = paths[number] ?? {};
    const list = own.get(number);
    const isStable = list.map((row) => rows.pivots[row] <= 0);
    const start = parent >= 0 ? points[point]?.row : undefined;
    const property = number === 0 ? "var(--series-1)" : `var(--branch-${((number - 1) % colours) + 1})`;
    return {
      name: name ?? (number === 0 ? stage : `branch ${number}`),
      cause: cause ? `given up: ${cause}` : "",
      rows: start === undefined ? list : [start, ...list],
      isStable: start === undefined ? isStable : [isStable[0], ...isStable],
      property,
      colour: (theme) => (number === 0 ? theme.series[0] : theme.branches[(number - 1) % colours]),
      isHidden: false,
    };
  });
}
