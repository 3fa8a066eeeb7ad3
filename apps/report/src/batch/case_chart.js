import { find, make } from "../elements.js";
import { formatNumber } from "../format.js";
import { ChartChoices } from "./chart_choices.js";
import { HeatFigure } from "./heat_figure.js";
import { HistogramFigure } from "./histogram_figure.js";
import { makeSvgKey } from "../saving/svg.js";
import { Paint } from "./paint.js";
import { Plot } from "../figures/plot.js";
import { count, PointFigure } from "./point_figure.js";
import { summarise } from "./statistics.js";
import { readTheme } from "../theme.js";

// The chart of the cases that are shown, with its keys and notes.
export class CaseChart {
  constructor(cases, attention) {
    this.cases = cases;
    this.rows = [];
    this.choices = new ChartChoices(cases, () => this.draw());
    this.plot = new Plot(find("plot"), attention, (row) => this.describe(row));
    find("plot").before(makeSvgKey(() => document.querySelector(".stage"), () => this.readChart()));
  }

  show(rows) {
    this.rows = rows;
    this.draw();
  }

  draw() {
    const { cases, choices } = this;
    const { kind, value, across, by, logAcross, logValue } = choices;
    const rows = choices.held(this.rows);
    find("value-description").textContent = value.description ? `${value.name}: ${value.description}` : "";
    this.paint = new Paint(kind === "lines" || kind === "points" ? by : null, rows);
    if (kind === "heat") {
      this.figure = new HeatFigure({ cases, rows, across, upwards: by, value, logValue });
    } else if (kind === "histogram") {
      this.figure = new HistogramFigure({ cases, rows, value, logValue });
    } else {
      const others = by && !choices.others.includes(by) ? [...choices.others, by] : choices.others;
      const isJoined = kind === "lines" && across.isNumeric;
      this.figure = new PointFigure({ cases, rows, across, value, paint: this.paint, others, isJoined, logAcross, logValue });
    }
    this.plot.show(this.figure);
    find("plot").setAttribute("aria-label", `${this.figure.y.label}, over ${this.figure.x.label}`);
    this.showKeys();
    this.showWords(rows);
  }

  // As a file of its own.
  readChart() {
    const { plot } = this.plot;
    const { x, y } = this.figure;
    const title = this.choices.kind === "heat" ? this.figure.scaleAxis.label : y.label;
    return { canvas: plot.ctx.canvas, draw: () => plot.batch(() => plot.redraw(true, true)), title: `${title} over ${x.label}` };
  }

  showKeys() {
    const { column, values, hasKeys, scale, hidden } = this.paint;
    const bar = this.figure.scale ?? scale;
    this.showBar(bar, this.figure.scale ? this.figure : null);
    find("keys").replaceChildren();
    if (!column || !hasKeys) return;
    const theme = readTheme();
    find("keys").append(make("span", { className: "keys-title" }, column.name));
    for (const value of values) {
      const slope = this.figure.slopes?.get(value);
      const words = slope === undefined ? null : make("span", { className: "value" }, `slope ${formatNumber(slope, 3)}`);
      const key = make("button", { className: "key", type: "button", "aria-pressed": "true" }, make("i"), column.say(value), words);
      const row = column.numbers.indexOf(value);
      key.style.setProperty("--series", this.paint.colour(row, theme));
      key.addEventListener("click", () => {
        const isShown = hidden.delete(value);
        if (!isShown) hidden.add(value);
        key.setAttribute("aria-pressed", String(isShown));
        this.plot.redraw();
      });
      find("keys").append(key);
    }
  }

  showBar(scale, heat) {
    find("bar").hidden = !scale;
    if (!scale) return;
    const column = heat ? heat.value : this.paint.column;
    const isLog = heat ? heat.scaleAxis.isLog : false;
    const say = (level) => formatNumber(isLog ? 10 ** level : level, 3);
    find("bar-colours").style.background = scale.gradient();
    const middle = 0.5 * (scale.least + scale.largest);
    find("bar-ticks").replaceChildren(...[scale.least, middle, scale.largest].map((level) => make("span", {}, say(level))));
    find("bar-text").textContent = heat ? heat.scaleAxis.label : column.name;
  }

  showWords(rows) {
    const { cases, choices, figure } = this;
    const notes = figure.notes();
    const slope = this.paint.column ? undefined : figure.slopes?.get(0);
    if (slope !== undefined) notes.unshift(`Slope ${formatNumber(slope, 3)}, by least squares.`);
    if (rows.length === 0) notes.unshift(cases.count === 0 ? "No case has ended yet." : "No case passes the filter.");
    else if (this.rows.length < cases.count) notes.push(`Only cases that pass the filter: ${this.rows.length} of ${cases.count}.`);
    find("notes").textContent = notes.join(" ");
    find("statistics").replaceChildren(...this.sayStatistics(rows));
    find("statistics").hidden = !(cases.isSampled || choices.kind === "histogram");
  }

  sayStatistics(rows) {
    const { value } = this.choices;
    const isKept = (row) => value.group !== "collected" || this.cases.isDone(row);
    const kept = rows.filter((row) => isKept(row) && Number.isFinite(value.numbers[row]));
    const { count: number, ...summary } = summarise(kept.map((row) => value.numbers[row]));
    const words = { mean: "mean", deviation: "standard deviation", least: "min", low: "5 %", median: "median", high: "95 %", largest: "max" };
    const lost = rows.length - number;
    return [
      make("strong", {}, count(number, "case")),
      ...Object.entries(words).map(([name, word]) => make("span", { "data-of": name }, `${word} `, make("b", {}, formatNumber(summary[name], 5)))),
      ...(lost > 0 ? [make("span", {}, `${lost} without a value`)] : []),
    ];
  }

  // A case for the pointer.
  describe(row) {
    const { cases, choices } = this;
    const lines = [make("strong", {}, `case ${cases.numbers[row]}`)];
    const columns = new Set([...cases.varied.slice(0, 8), choices.across, choices.value, choices.by].filter(Boolean));
    for (const column of columns) {
      if (column !== cases.case) lines.push(make("span", {}, `${column.name} `, make("b", {}, column.show(row))));
    }
    if (!cases.isDone(row)) lines.push(make("em", { className: "bad" }, `${cases.status[row]}: ${cases.reasons[row]}`));
    if (cases.warnings[row]) lines.push(make("em", {}, cases.warnings[row]));
    return lines;
  }

  recolour() {
    this.plot.redraw();
    this.showKeys();
  }
}
