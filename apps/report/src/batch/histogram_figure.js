import { make } from "../elements.js";
import { formatNumber } from "../format.js";
import { Axis } from "../figures/axis.js";
import { Column } from "./column.js";
import { quantile, summarise } from "./statistics.js";

// How many cases lie between which values of a column; in powers of ten if asked for.
export class HistogramFigure {
  constructor({ cases, rows, value, logValue }) {
    Object.assign(this, { cases, value });
    const isKept = (row) => Number.isFinite(value.numbers[row]) && (value.group !== "collected" || cases.isDone(row));
    this.rows = rows.filter(isKept);
    const numbers = this.rows.map((row) => value.numbers[row]);
    this.x = new Axis(value, { isLog: logValue && value.isNumeric, values: numbers });
    this.levels = numbers.map((number) => this.level(number)).filter(Number.isFinite);
    this.makeBins();
    const most = Math.max(1, ...this.bins);
    this.y = new Axis(new Column({ key: "number of cases", group: "run", numbers: [] }), { values: [0, most] });
    this.y.range = [0, 1.06 * most];
    this.summary = summarise(numbers);
  }

  level(number) {
    const place = this.x.place(number);
    return this.x.isLog ? Math.log10(place) : place;
  }

  // As wide as Freedman and Diaconis have them, but not fewer than Sturges has, nor more than 60.
  makeBins() {
    const sorted = Float64Array.from(this.levels).sort();
    this.least = sorted[0] ?? 0;
    const span = (sorted.at(-1) ?? 0) - this.least;
    const width = (2 * (quantile(sorted, 0.75) - quantile(sorted, 0.25))) / Math.cbrt(Math.max(1, sorted.length));
    const fewest = Math.ceil(Math.log2(sorted.length)) + 1;
    const number = span > 0 ? Math.min(60, Math.max(fewest, width > 0 ? Math.ceil(span / width) : 0)) : 1;
    this.width = span > 0 ? span / number : 2 * Math.abs(this.least) * 1e-7 || 1;
    if (span === 0) this.least -= 0.5 * this.width;
    this.bins = new Array(number).fill(0);
    for (const level of this.levels) this.bins[this.binOf(level)]++;
  }

  binOf(level) {
    return Math.min(this.bins?.length - 1 || 0, Math.max(0, Math.floor((level - this.least) / this.width)));
  }

  // The value at the lower end of a bin.
  start(bin) {
    const level = this.least + bin * this.width;
    return this.x.isLog ? 10 ** level : level;
  }

  draw(plot, context, theme) {
    const bottom = plot.top(0);
    context.fillStyle = theme.series[0];
    this.bins.forEach((number, bin) => {
      const [left, right] = [plot.left(this.start(bin)), plot.left(this.start(bin + 1))];
      const top = plot.top(number);
      context.fillRect(left, top, Math.max(right - left - plot.ratio, plot.ratio), bottom - top);
    });
    if (this.levels.length < 2 || this.x.takesSize) return;
    const { mean, deviation } = this.summary;
    this.drawLine(plot, context, theme.path, mean, []);
    for (const side of [-1, 1]) this.drawLine(plot, context, theme.path, mean + side * deviation, [5, 4]);
  }

  drawLine(plot, context, colour, value, dash) {
    const [least, largest] = this.x.range;
    if (!(value > least && value < largest)) return;
    const left = plot.left(value);
    context.strokeStyle = colour;
    context.lineWidth = 1.5 * plot.ratio;
    context.setLineDash(dash.map((length) => length * plot.ratio));
    context.beginPath();
    context.moveTo(left, plot.box.top);
    context.lineTo(left, plot.box.top + plot.box.height);
    context.stroke();
  }

  at(plot, left) {
    const value = plot.plot.posToVal(left, "x");
    const place = (this.level(value) - this.least) / this.width;
    const bin = Math.floor(place);
    if (!(place >= 0 && bin < this.bins.length)) return null;
    const number = this.bins[bin];
    const range = `${formatNumber(this.start(bin), 4)} … ${formatNumber(this.start(bin + 1), 4)}`;
    const words = [make("strong", {}, number === 1 ? "1 case" : `${number} cases`), make("span", {}, range)];
    return { row: -1, left, top: plot.plot.valToPos(number, "y"), words };
  }

  // At the foot of the case's bar.
  find(plot, row) {
    if (row < 0 || !this.rows.includes(row)) return null;
    return { left: plot.plot.valToPos(this.x.place(this.value.numbers[row]), "x"), top: plot.plot.valToPos(0, "y") };
  }

  notes() {
    const notes = [];
    if (this.levels.length > 1 && !this.x.takesSize) notes.push("Orange: mean and, dashed, a standard deviation to each side.");
    if (this.levels.length < this.rows.length) notes.push("Zeros cannot be shown on a logarithmic axis.");
    return notes;
  }
}
