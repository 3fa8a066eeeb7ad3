import uPlot from "uplot";
import { listPlaces } from "./along.js";
import { make } from "../elements.js";
import { formatNumber, timeSymbol } from "../format.js";
import { axesOptions, nameAcross, rangeAround, widen } from "./plot_axes.js";
import { listTimedStages, partAt } from "../findings/stages.js";
import { heightOfGround } from "../scene/surroundings.js";
import { readTheme } from "../theme.js";
import { addSvgKey } from "../saving/svg.js";
import { unitOf } from "../units.js";

const height = 150;

// Between which arc lengths a rod touches the ground in each frame: linear between nodes.
function findTouches(data, rod) {
  const { ground } = data.info.surroundings;
  const places = listPlaces(data, rod, "node");
  const { values } = data.quantities.displacement;
  const size = data.reference.length;
  const upright = ground.normal?.[2] ?? 1;
  const clearance = (frame, row) => {
    const [x, y, z] = [0, 1, 2].map((i) => data.reference[3 * row + i] + values[size * frame + 3 * row + i]);
    return (z - heightOfGround(ground, x, y)) * upright - ground.radii[rod];
  };
  const touches = { first: [], last: [] };
  const stages = listTimedStages(data.info);
  const isThere = (time) => !ground.stages || ground.stages.includes(partAt(stages, time)?.name);
  data.times.forEach((time, frame) => {
    if (!isThere(time)) return [touches.first, touches.last].forEach((list) => list.push(null));
    const gaps = places.map(({ row }) => clearance(frame, row));
    const crossing = (i, j) => places[i].s + ((places[j].s - places[i].s) * gaps[i]) / (gaps[i] - gaps[j]);
    const first = gaps.findIndex((gap) => gap < 0);
    const last = gaps.findLastIndex((gap) => gap < 0);
    const end = places.length - 1;
    touches.first.push(first < 0 ? null : first === 0 ? places[0].s : crossing(first, first - 1));
    touches.last.push(last < 0 ? null : last === end ? places[end].s : crossing(last, last + 1));
  });
  return touches;
}

// A chart of the part of each rod that lies on the ground, over time.
export class TouchDown {
  constructor(data, clock, units) {
    Object.assign(this, { data, clock, units });
    this.rods = data.info.rods
      .map((name, rod) => ({ name, rod }))
      .filter(({ rod }) => data.info.surroundings.ground.radii[rod] > 0)
      .map((one) => ({ ...one, touches: findTouches(data, one.rod) }))
      .filter(({ touches }) => touches.first.some((s) => s !== null));
    this.choice = make("select", { "aria-label": "Rod" }, ...this.rods.map(({ name }, i) => make("option", { value: String(i) }, name)));
    this.choice.hidden = this.rods.length < 2;
    this.choice.addEventListener("change", () => this.choose());
    this.now = make("span", { className: "value" });
    this.body = make("div", { className: "chart-body" });
    this.body.plotted = () => this.plot.data; // for tests: times, first and last arc length
    const length = unitOf("length", units);
    const unit = make("small", {}, `between the arc lengths${length === "length" ? "" : `, ${length}`}`);
    const key = make("span", { className: "key range" }, make("i"), this.now);
    key.style.setProperty("--series", "var(--series-1)");
    this.element = make(
      "section",
      { className: "chart along" },
      make("h2", {}, "On the ground"),
      make("div", { className: "along-choices" }, this.choice, unit),
      make("div", { className: "keys" }, key),
      this.body,
    );
    addSvgKey(this.element, () => this.plot, { across: nameAcross(data.info.time_name, units) });
    clock.listen(() => this.follow());
    new ResizeObserver(() => this.resize()).observe(this.body);
    if (this.rods.length > 0) this.choose();
  }

  // Whether a rod touches the ground in some frame.
  static isPossible(data) {
    return !!data.info.surroundings?.ground && data.info.surroundings.ground.radii.some((radius) => radius > 0);
  }

  choose() {
    this.rod = this.rods[Number(this.choice.value)];
    this.plot?.destroy();
    this.plot = null;
    this.draw();
    this.follow();
  }

  draw() {
    if (this.plot || !this.rod || this.body.clientWidth === 0) return;
    const { first, last } = this.rod.touches;
    this.plot = new uPlot(this.options(), [[...this.data.times], last, first], this.body);
  }

  options() {
    const series = () => readTheme().series[0];
    const line = { stroke: series, width: 1.5, points: { show: this.data.times.length < 3 } };
    return {
      width: Math.max(this.body.clientWidth, 200),
      height,
      legend: { show: false },
      cursor: { show: false },
      padding: [10, 18, 0, 0],
      scales: {
        x: { time: false, range: (plot, least, largest) => widen(least, largest) },
        y: { range: (plot, least, largest) => rangeAround(least, largest, 0) },
      },
      axes: axesOptions(),
      bands: [{ series: [1, 2], fill: () => `color-mix(in srgb, ${series()} 22%, transparent)` }],
      series: [{}, line, line],
    };
  }

  follow() {
    if (!this.rod) return;
    const frame = Math.min(Math.round(this.clock.position), this.clock.last);
    const [first, last] = [this.rod.touches.first[frame], this.rod.touches.last[frame]];
    const where = first === null ? "nothing" : `${formatNumber(first, 4)} to ${formatNumber(last, 4)}`;
    this.now.textContent = `${timeSymbol(this.data.info.time_name)} = ${formatNumber(this.data.times[frame], 4)}: ${where}`;
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
