import uPlot from "uplot";
import { make } from "../elements.js";
import { formatNumber, timeSymbol } from "../format.js";
import { componentOf } from "../motion.js";
import { axesOptions, largestSize, rangeAround, widen } from "./plot_axes.js";
import { componentsOf, dimensionOf, titleOf } from "../quantities.js";
import { readTheme } from "../theme.js";
import { addSvgKey } from "../saving/svg.js";
import { unitOf } from "../units.js";

const height = 190;
const roundOff = 1e-6; // relative to the magnitude: numbers in a page have seven digits

// Where a quantity is known along a rod: { s, row } by arc length, of nodes or of the middles of elements.
export function listPlaces(data, rod, of) {
  const places = [];
  const seen = new Set();
  for (let cell = 0; cell + 1 < data.offsets.length; cell++) {
    if (data.cellRods[cell] !== rod) continue;
    if (of === "cell") places.push({ s: data.middles[cell], row: cell });
    for (let i = data.offsets[cell]; of === "node" && i < data.offsets[cell + 1]; i++) {
      const key = `${data.connectivity[i]} ${data.arcLengths[i]}`; // a ring comes back to its first node
      if (!seen.has(key)) places.push({ s: data.arcLengths[i], row: data.connectivity[i] });
      seen.add(key);
    }
  }
  return places.sort((a, b) => a.s - b.s);
}

// Of stages with time, all but those of static ones before them, which end at t = 0.
function listTimedFrames({ times, info }) {
  const all = [...times.keys()];
  const timed = all.filter((frame) => times[frame] >= 0);
  return info.is_static || timed.length < 2 ? all : timed;
}

// A chart along a rod: a quantity at the clock's time, within its range over all frames. Options: a title, the quantities, some
// of which are a number a place, in place of the data's; that which is shown first; which rods; whether there is a line for the mean, and the range is that of frames with time alone.
export class Along {
  constructor(data, clock, units, { title = "Along a rod", quantities = data.quantities, first = "moment", hasRod = () => true, hasMean = false } = {}) {
    Object.assign(this, { data, clock, units, quantities, hasMean });
    this.rods = data.info.rods.map((name, rod) => ({ name, rod })).filter(({ rod }) => data.cellRods.includes(rod) && hasRod(rod));
    this.frames = hasMean ? listTimedFrames(data) : [...data.times.keys()];
    this.rod = make("select", { "aria-label": "Rod" }, ...this.rods.map(({ name, rod }) => make("option", { value: String(rod) }, name)));
    this.quantity = make("select", { "aria-label": "Quantity" }, ...Object.keys(quantities).map((name) => make("option", { value: name }, titleOf(name))));
    this.component = make("select", { "aria-label": "Component" });
    this.unit = make("small", {});
    this.now = make("span", { className: "value" });
    this.body = make("div", { className: "chart-body" });
    this.body.plotted = () => this.plot.data; // for tests: arc length, range, present, mean
    this.element = make("section", { className: "chart along" }, make("h2", {}, title), this.makeChoices(), this.makeKeys(), this.body);
    const length = unitOf("length", units);
    addSvgKey(this.element, () => this.plot, { across: `arc length s${length === "length" ? "" : `, ${length}`}` });
    if (quantities[first]) this.quantity.value = this.isNothing(first) && quantities.force ? "force" : first;
    this.rod.value = String(this.largestRod());
    this.rod.hidden = this.rods.length < 2;
    this.rod.addEventListener("change", () => this.choose());
    this.quantity.addEventListener("change", () => this.chooseQuantity());
    this.component.addEventListener("change", () => this.choose());
    clock.listen(() => this.follow());
    new ResizeObserver(() => this.resize()).observe(this.body);
    // Not updated while out of sight.
    new IntersectionObserver(([entry]) => {
      this.isSeen = entry.isIntersecting;
      this.follow();
    }).observe(this.element);
    this.chooseQuantity();
  }

  // Whether there is a rod whose places are known.
  static isPossible(data) {
    return data.cellRods.some((rod) => rod >= 0);
  }

  makeChoices() {
    return make("div", { className: "along-choices" }, this.rod, this.quantity, this.component, this.unit);
  }

  makeKeys() {
    const present = make("span", { className: "key" }, make("i"), this.now);
    const all = this.frames[0] === 0 ? "all frames" : `frames from ${timeSymbol(this.data.info.time_name)} = 0`;
    const range = make("span", { className: "key range" }, make("i"), `range over ${all}`);
    const mean = this.hasMean ? make("span", { className: "key" }, make("i"), "mean") : null;
    for (const key of [present, range]) key.style.setProperty("--series", "var(--series-1)");
    mean?.style.setProperty("--series", "var(--series-2)");
    return make("div", { className: "keys" }, present, range, mean);
  }

  // Whether moments are nothing but round-off of the forces, as in cables.
  isNothing(name) {
    const { force } = this.quantities;
    if (name !== "moment" || !force) return false;
    return largestSize([this.quantities[name].values]) <= roundOff * largestSize([force.values]) * largestSize([this.data.arcLengths]);
  }

  // The rod with the largest values of a quantity of elements; of rods that are alike the first.
  largestRod() {
    const { of, values, isScalar } = this.quantities[this.quantity.value];
    const { cellRods, times } = this.data;
    const stride = isScalar ? 1 : 3;
    const rows = values.length / stride / times.length;
    const largest = new Map(this.rods.map(({ rod }) => [rod, 0]));
    for (let i = 0; of === "cell" && i < values.length; i++) {
      const rod = cellRods[Math.floor(i / stride) % rows];
      const size = Math.abs(values[i]);
      if (size > largest.get(rod) * (1 + roundOff)) largest.set(rod, size);
    }
    return [...largest].reduce((best, one) => (one[1] > best[1] * (1 + roundOff) ? one : best), [this.rods[0]?.rod, 0])[0];
  }

  chooseQuantity() {
    const names = componentsOf(this.quantity.value);
    this.component.hidden = this.quantities[this.quantity.value].isScalar ?? false;
    this.component.replaceChildren(
      ...names.map((name, i) => make("option", { value: String(i) }, name)),
      make("option", { value: "3" }, "magnitude"),
    );
    this.component.value = this.component.hidden ? "0" : String(this.largestComponent());
    this.choose();
  }

  // That with the largest values; of those that are alike, the first.
  largestComponent() {
    const { values } = this.quantities[this.quantity.value];
    const largest = [0, 0, 0];
    for (let i = 0; i < values.length; i++) largest[i % 3] = Math.max(largest[i % 3], Math.abs(values[i]));
    return largest.indexOf(Math.max(...largest));
  }

  choose() {
    const quantity = this.quantities[this.quantity.value];
    this.of = quantity.of;
    this.values = quantity.values;
    this.stride = quantity.isScalar ? 1 : 3;
    this.rows = this.values.length / this.stride / this.data.times.length;
    this.places = listPlaces(this.data, Number(this.rod.value), quantity.of);
    const unit = unitOf(dimensionOf(this.quantity.value), this.units);
    const length = unitOf("length", this.units);
    const where = quantity.of === "cell" ? "element middles" : "nodes";
    this.unit.textContent = [unit, `over arc length${length === "length" ? "" : `, ${length}`}`, where].filter(Boolean).join("; ");
    this.findRange();
    this.plot?.destroy();
    this.plot = null;
    this.draw();
  }

  valueAt(frame, row, component = Number(this.component.value)) {
    if (this.stride === 1) return component === 3 ? Math.abs(this.values[this.rows * frame + row]) : this.values[this.rows * frame + row];
    return componentOf(this.values, 3 * (this.rows * frame + row), component);
  }

  findRange() {
    this.least = this.places.map(() => Infinity);
    this.largest = this.places.map(() => -Infinity);
    this.mean = this.places.map(() => 0);
    let magnitude = 0;
    for (const frame of this.frames) {
      this.places.forEach(({ row }, i) => {
        const value = this.valueAt(frame, row);
        this.mean[i] += value / this.frames.length;
        if (value < this.least[i]) this.least[i] = value;
        if (value > this.largest[i]) this.largest[i] = value;
        if (this.valueAt(frame, row, 3) > magnitude) magnitude = this.valueAt(frame, row, 3);
      });
    }
    this.leastHeight = roundOff * magnitude;
  }

  // At the clock's time; between frames, between their values.
  present() {
    const frame = Math.min(Math.floor(this.clock.position), this.clock.last);
    const next = Math.min(frame + 1, this.clock.last);
    const part = this.clock.position - frame;
    return this.places.map(({ row }) => (1 - part) * this.valueAt(frame, row) + part * this.valueAt(next, row));
  }

  draw() {
    if (this.plot || this.body.clientWidth === 0) return;
    const s = this.places.map((place) => place.s);
    this.plot = new uPlot(this.options(), this.columns(s), this.body);
    this.follow();
  }

  columns(s) {
    const columns = [this.largest, this.least, this.present(), ...(this.hasMean ? [this.mean] : [])];
    return [s, ...columns.map((column) => column.map((value) => (Number.isFinite(value) ? value : null)))];
  }

  options() {
    const series = () => readTheme().series[0];
    const points = { show: this.places.length < 60, size: 5 };
    return {
      width: Math.max(this.body.clientWidth, 200),
      height,
      legend: { show: false },
      cursor: { show: false },
      pxAlign: 0,
      padding: [10, 18, 0, 0],
      scales: {
        x: { time: false, range: (plot, least, largest) => widen(least, largest) },
        y: { range: (plot, least, largest) => rangeAround(least, largest, this.leastHeight) },
      },
      axes: axesOptions(),
      bands: [{ series: [1, 2], fill: () => `color-mix(in srgb, ${series()} 22%, transparent)` }],
      series: [
        {},
        { stroke: series, width: 0.6, points: { show: false } },
        { stroke: series, width: 0.6, points: { show: false } },
        { stroke: series, width: 2, points },
        ...(this.hasMean ? [{ stroke: () => readTheme().series[1], width: 1.5, dash: [6, 4], points: { show: false } }] : []),
      ],
    };
  }

  follow() {
    const symbol = timeSymbol(this.data.info.time_name);
    this.now.textContent = `${symbol} = ${formatNumber(this.clock.time, 4)}`;
    if (this.isSeen) this.plot?.setData(this.columns(this.plot.data[0]));
  }

  resize() {
    if (this.body.clientWidth === 0) return;
    if (this.plot) this.plot.setSize({ width: this.body.clientWidth, height });
    else this.draw();
  }

  recolour() {
    this.plot?.redraw(false, true);
  }
}
