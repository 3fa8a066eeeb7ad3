import uPlot from "uplot";
import { find, make } from "../elements.js";
import { formatNumber, inWords } from "../format.js";
import { axesOptions, largestSize, nameAcross, rangeAround, widen } from "./plot_axes.js";
import { nameQuantity } from "../quantities.js";
import { readTheme } from "../theme.js";
import { addSvgKey } from "../saving/svg.js";
import { unitOf } from "../units.js";

const height = 168;

// One chart with its values at the clock's time; pressing or dragging in it moves the clock.
export class Chart {
  constructor(chart, times, clock, { timeName, units, leastHeight, unstable, parts }) {
    this.chart = chart;
    this.units = units;
    this.leastHeight = leastHeight;
    this.unstable = unstable;
    this.parts = parts;
    this.times = times;
    this.clock = clock;
    this.timeName = timeName;
    this.values = chart.labels.map(() => make("span", { className: "value" }));
    this.keys = chart.labels.map((label, i) => this.makeKey(label, i));
    this.body = make("div", { className: "chart-body" });
    this.element = make(
      "section",
      { className: "chart" },
      make("h3", { title: chart.description }, this.makeTitle(), this.makeUnit()),
      make("div", { className: "keys" }, ...this.keys),
      this.body,
    );
    addSvgKey(this.element, () => this.plot, { across: nameAcross(timeName, units) });
    this.line = make("div", { className: "now" });
  }

  // Names of histories stay as the deck has them.
  makeTitle() {
    const { title, quantity } = this.chart;
    return quantity ? `${title}: ${nameQuantity(quantity)}` : title;
  }

  makeUnit() {
    const { dimension, frame } = this.chart;
    return make("small", {}, [unitOf(dimension, this.units), axesInWords(frame)].filter(Boolean).join(", "));
  }

  // A label with its value, that shows and hides its line.
  makeKey(label, i) {
    const key = make("button", { className: "key", type: "button" }, make("i"), inWords(label), this.values[i]);
    key.style.setProperty("--series", `var(--series-${(i % 4) + 1})`);
    const isHidden = (label === "magnitude" && hasNoMagnitude.has(this.chart.quantity)) || this.isNothing(i);
    key.setAttribute("aria-pressed", String(!isHidden));
    key.addEventListener("click", () => {
      const isShown = key.getAttribute("aria-pressed") !== "true";
      key.setAttribute("aria-pressed", String(isShown));
      this.plot?.setSeries(i + 1, { show: isShown });
    });
    return key;
  }

  // Whether a column is zero throughout while others are not.
  isNothing(i) {
    const { columns, group } = this.chart;
    return columns.length > 1 && group !== "history" && columns[i].every((value) => value === 0);
  }

  // Made when it is first seen.
  draw() {
    if (this.plot) return;
    const width = Math.max(this.body.clientWidth, 200);
    this.plot = new uPlot(this.options(width), [this.times, ...this.chart.columns], this.body);
    this.plot.over.append(this.line);
    this.bindPointer();
    new ResizeObserver(() => {
      if (this.body.clientWidth > 0) this.plot.setSize({ width: this.body.clientWidth, height });
      this.moveLine();
    }).observe(this.body);
    this.moveLine();
  }

  options(width) {
    const theme = () => readTheme();
    const range = (plot, least, largest) => rangeAround(least, largest, this.leastHeight);
    return {
      width,
      height,
      legend: { show: false },
      cursor: { show: false },
      pxAlign: 0,
      padding: [10, 18, 0, 0],
      scales: { x: { time: false, range: (plot, least, largest) => widen(least, largest) }, y: { range } },
      axes: axesOptions(),
      series: [
        { label: this.timeName },
        ...this.chart.labels.map((label, i) => ({
          label,
          show: this.keys[i].getAttribute("aria-pressed") === "true",
          stroke: () => theme().series[i % 4],
          width: label === "magnitude" ? 1 : 1.5,
          dash: label === "magnitude" ? [5, 4] : undefined,
          points: { show: this.times.length < 40, size: 5 },
        })),
      ],
      hooks: { drawClear: [(plot) => this.shadeUnstable(plot)], drawAxes: [(plot) => drawParts(plot, this.parts)], draw: [() => this.moveLine()] },
    };
  }

  shadeUnstable(plot) {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.fillStyle = "rgba(230, 140, 0, 0.16)";
    for (const [from, until] of this.unstable) {
      const left = plot.valToPos(from, "x", true);
      ctx.fillRect(left, bbox.top, Math.max(plot.valToPos(until, "x", true) - left, 1), bbox.height);
    }
    ctx.restore();
  }

  bindPointer() {
    const { over } = this.plot;
    const follow = (event) => {
      const left = event.clientX - over.getBoundingClientRect().left;
      this.clock.playing = false;
      this.clock.goToTime(this.plot.posToVal(left, "x"));
    };
    over.addEventListener("pointerdown", (event) => {
      over.setPointerCapture(event.pointerId);
      follow(event);
    });
    over.addEventListener("pointermove", (event) => {
      if (over.hasPointerCapture(event.pointerId)) follow(event);
    });
  }

  moveLine() {
    if (!this.plot) return;
    const left = this.plot.valToPos(this.clock.time, "x");
    if (Number.isFinite(left)) this.line.style.transform = `translateX(${left}px)`;
    const step = nearest(this.times, this.clock.time);
    this.values.forEach((value, i) => (value.textContent = this.write(this.chart.columns[i][step])));
  }

  // Of an angle alone also in degrees.
  write(value) {
    const isAngle = this.chart.dimension === "angle" && this.chart.labels.length === 1 && Number.isFinite(value);
    return formatNumber(value, 4) + (isAngle ? ` = ${formatNumber((value * 180) / Math.PI, 4)}°` : "");
  }

  recolour() {
    this.plot?.redraw(false, true);
  }
}

// A dashed line where each part of the run starts but the first, and its name where there is room.
function drawParts(plot, parts) {
  const { ctx: context, bbox } = plot;
  const ratio = uPlot.pxRatio;
  context.save();
  context.strokeStyle = context.fillStyle = readTheme().muted;
  context.lineWidth = ratio;
  context.setLineDash([3 * ratio, 3 * ratio]);
  context.font = `${10 * ratio}px ${getComputedStyle(document.body).fontFamily}`;
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  parts.forEach(({ name, from, until }, i) => {
    const left = plot.valToPos(from, "x", true);
    if (i > 0) {
      context.beginPath();
      context.moveTo(left, bbox.top);
      context.lineTo(left, bbox.top + bbox.height);
      context.stroke();
    }
    const room = plot.valToPos(until, "x", true) - left - 8 * ratio;
    if (parts.length > 1 && context.measureText(name).width < room) context.fillText(name, left + 4 * ratio, bbox.top - 1 * ratio);
  });
  context.restore();
}

// Whose magnitudes say nothing.
const hasNoMagnitude = new Set(["position", "orientation", "quaternion", "centre_of_mass"]);

// "spatial" and "material" axes, those of a point ("axes of hub.start"), of a joint or a bushing, or none.
function axesInWords(frame) {
  if (frame === "none") return "";
  if (frame === "bushing") return "bushing axes";
  return frame === "spatial" || frame === "material" ? `${frame} axes` : frame;
}

// Relative to a vector's magnitude, or to the energies: less is round-off. Numbers in a page have seven digits, and equilibria
// are found to some eight.
const roundOff = 1e-6;
const imbalanceRoundOff = 1e-8;

// Heights below which charts show flat lines.
function listLeastHeights(charts) {
  const energies = charts.filter(({ group }) => group === "energy").map(({ columns }) => largestSize(columns));
  return charts.map(({ group, columns }) =>
    Math.max(roundOff * largestSize(columns), group === "energy" ? imbalanceRoundOff * Math.max(...energies) : 0),
  );
}

function nearest(times, time) {
  let low = 0;
  let high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return time - times[low] <= times[high] - time ? low : high;
}

// Parts of a run whose equilibria are unstable: from the step before the first to the last. Paths have their own.
function listUnstableParts({ info, stepTimes }, onPaths) {
  const isOnPath = (time) => onPaths.whole.some(([from, until]) => time >= from && time <= until);
  const pivots = info.charts.find(({ labels }) => labels[0] === "negative pivots")?.columns[0] ?? [];
  const parts = [];
  for (let i = 0; i < pivots.length; ++i) {
    if (pivots[i] <= 0 || isOnPath(stepTimes[i])) continue;
    if (i > 0 && pivots[i - 1] > 0) parts.at(-1)[1] = stepTimes[i];
    else parts.push([stepTimes[Math.max(i - 1, 0)], stepTimes[i]]);
  }
  return [...parts, ...onPaths.unstable];
}

const headings = { history: "Histories", energy: "Energy", momentum: "Momentum", solver: "Solver" };

// Whether it moves by more than round-off.
function isMoving({ chart: { columns } }) {
  const size = largestSize(columns);
  return columns.some((column) => {
    const first = column.find(Number.isFinite);
    return column.some((value) => Number.isFinite(value) && Math.abs(value - first) > roundOff * size);
  });
}

// All charts under headings, what the deck asks for first, and of these what moves; each is drawn when it comes into sight.
export function showCharts(data, clock, { timeName, units, along, parts, onPaths, isStill }) {
  const heights = listLeastHeights(data.info.charts);
  const unstable = listUnstableParts(data, onPaths);
  const charts = data.info.charts.map(
    (chart, i) => new Chart(chart, data.stepTimes, clock, { timeName, units, leastHeight: heights[i], unstable, parts }),
  );
  const panel = find("charts");
  panel.append(...along.filter(Boolean).map(({ element }) => element));
  if (data.stepTimes.length === 0 || isStill) {
    panel.append(make("p", { className: "note" }, "The run has no steps, so there is nothing to draw over time."));
    return charts;
  }
  if (unstable.length > 0) {
    panel.append(make("p", { className: "note" }, "Shaded: equilibria that are unstable."));
  }
  const byElement = new Map(charts.map((chart) => [chart.element, chart]));
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) if (entry.isIntersecting) byElement.get(entry.target).draw();
  }, { rootMargin: "300px" });
  for (const [group, heading] of Object.entries(headings)) {
    const members = charts.filter((chart) => chart.chart.group === group);
    if (group === "history") members.sort((a, b) => isMoving(b) - isMoving(a));
    if (members.length === 0) continue;
    panel.append(make("h2", {}, heading), ...members.map((chart) => chart.element));
  }
  for (const chart of charts) observer.observe(chart.element);
  clock.listen(() => charts.forEach((chart) => chart.moveLine()));
  return charts;
}
