import uPlot from "uplot";
import { find, make } from "../elements.js";
import { axesOptions } from "../charts/plot_axes.js";
import { addSvgKey } from "../saving/svg.js";
import { readTheme } from "../theme.js";
import { nameOf } from "./story.js";

const height = 150;

// A chart over the run: lines = [{ label, values }], null where there is no value.
class StudyChart {
  constructor({ title, lines, isLog = false, times, across }) {
    this.lines = lines;
    this.isLog = isLog;
    this.times = times;
    this.body = make("div", { className: "chart-body" });
    const keys = lines.map((line, i) => {
      const key = make("span", { className: "key" }, make("i"), line.label);
      key.setAttribute("aria-pressed", "true");
      key.style.setProperty("--series", `var(--series-${(i % 4) + 1})`);
      return key;
    });
    this.element = make("section", { className: "chart" }, make("h3", {}, title), make("div", { className: "keys" }, ...keys), this.body);
    addSvgKey(this.element, () => this.plot, { across });
  }

  draw() {
    if (this.plot) return;
    const width = Math.max(this.body.clientWidth, 200);
    this.plot = new uPlot(this.options(width), [this.times, ...this.lines.map((line) => line.values)], this.body);
    new ResizeObserver(() => {
      if (this.body.clientWidth > 0) this.plot.setSize({ width: this.body.clientWidth, height });
    }).observe(this.body);
  }

  options(width) {
    return {
      width,
      height,
      legend: { show: false },
      cursor: { show: false },
      pxAlign: 0,
      padding: [10, 18, 0, 0],
      scales: { x: { time: false }, y: this.isLog ? { distr: 3 } : {} },
      axes: axesOptions(this.isLog),
      series: [{}, ...this.lines.map((line, i) => ({ stroke: () => readTheme().series[i % 4], width: 1.5, points: { show: this.times.length < 40, size: 5 } }))],
    };
  }

  recolour() {
    this.plot?.redraw(false, true);
  }
}

function componentsOf(series) {
  const names = /^(quaternion|orientation|rotation)$/.test(series.quantity) ? ["w", "x", "y", "z"] : ["x", "y", "z"];
  return names.map((label, i) => ({ label, values: series.values.map((row) => row[i]) }));
}

// For a logarithmic scale, without zeros.
function errorsOf(series, tolerance, count) {
  const line = (label, part) => {
    const values = Array.from({ length: count }, (_, i) => (part.errors[i] > 0 ? part.errors[i] / series.scale : null));
    return { label, values };
  };
  const lines = [];
  if (series.steps) lines.push(line("of the step", series.steps));
  if (series.mesh) lines.push(line("of the mesh", series.mesh));
  // Errors of a series without a scale are not drawn.
  const isSeen = series.scale > 0 && lines.some(({ values }) => values.some((value) => value !== null));
  return isSeen ? [...lines, { label: "tolerance", values: Array(count).fill(tolerance) }] : [];
}

// Of each series its values, and its estimated errors by its change; drawn when they come into sight.
export function showSeries(study) {
  const charts = [];
  const clock = study.analysis === "static" ? "load factor" : "time";
  for (const series of study.series) {
    const times = study.times.slice(0, series.values.length);
    charts.push(new StudyChart({ title: `${nameOf(series)} over ${clock}`, lines: componentsOf(series), times, across: clock }));
    const errors = errorsOf(series, study.tolerance, times.length);
    if (errors.length > 0) charts.push(new StudyChart({ title: `${nameOf(series)}: estimated error, relative to its change`, lines: errors, times, isLog: true, across: clock }));
  }
  const byElement = new Map(charts.map((chart) => [chart.element, chart]));
  const observer = new IntersectionObserver(
    (entries) => {
      for (const entry of entries) if (entry.isIntersecting) byElement.get(entry.target).draw();
    },
    { rootMargin: "300px" },
  );
  find("charts").append(make("h2", {}, "Series"), ...charts.map((chart) => chart.element));
  for (const chart of charts) observer.observe(chart.element);
  return charts;
}
