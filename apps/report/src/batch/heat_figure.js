import { ColourScale } from "../scene/colours.js";
import { Axis } from "../figures/axis.js";
import { count } from "./point_figure.js";

// A rectangle a case, for two parameters; its colour is a value. Each value of a parameter takes the same room.
export class HeatFigure {
  constructor({ cases, rows, across, upwards, value, logValue }) {
    Object.assign(this, { cases, across, upwards, value });
    this.x = Axis.ofPlaces(across);
    this.y = Axis.ofPlaces(upwards);
    this.cells = new Map();
    this.hidden = 0;
    for (const row of rows) {
      const place = this.x.place(across.numbers[row]) + this.x.places.length * this.y.place(upwards.numbers[row]);
      if (this.cells.has(place)) this.hidden++;
      this.cells.set(place, row);
    }
    this.scaleAxis = new Axis(value, { isLog: logValue, values: rows.map((row) => this.valueOf(row)).filter(Number.isFinite) });
    const levels = rows.map((row) => this.level(row)).filter(Number.isFinite);
    this.range = [levels.reduce((a, b) => Math.min(a, b), Infinity), levels.reduce((a, b) => Math.max(a, b), -Infinity)];
    // Powers of ten have no sign, so no middle.
    this.scale = levels.length > 0 ? new ColourScale(this.range, this.scaleAxis.isLog) : null;
  }

  valueOf(row) {
    const isKept = this.value.group !== "collected" || this.cases.isDone(row);
    return isKept ? this.value.numbers[row] : NaN;
  }

  // What the colour shows: the value or the power of ten of its size.
  level(row) {
    const place = this.scaleAxis.place(this.valueOf(row));
    return this.scaleAxis.isLog ? Math.log10(place) : place;
  }

  draw(plot, context, theme) {
    const { length: columns } = this.x.places;
    for (const [place, row] of this.cells) {
      const [column, line] = [place % columns, Math.floor(place / columns)];
      // Whole pixels, so that neighbours touch without a seam.
      const [left, right] = [Math.round(plot.left(column - 0.5)), Math.round(plot.left(column + 0.5))];
      const [bottom, top] = [Math.round(plot.top(line - 0.5)), Math.round(plot.top(line + 0.5))];
      const gap = Math.min(right - left, bottom - top) > 14 * plot.ratio ? Math.round(plot.ratio) : 0;
      const [width, height] = [right - left - gap, bottom - top - gap];
      const level = this.level(row);
      const isDone = this.cases.isDone(row);
      if (Number.isFinite(level)) {
        context.fillStyle = this.scale.css(level);
        context.fillRect(left, top, width, height);
      }
      if (Number.isFinite(level) && isDone) continue;
      const size = Math.min(5 * plot.ratio, width / 2, height / 2);
      this.drawCross(context, isDone ? theme.muted : theme.bad, (left + right) / 2, (top + bottom) / 2, size, plot.ratio);
    }
  }

  drawCross(context, colour, left, top, size, ratio) {
    context.strokeStyle = colour;
    context.lineWidth = Math.min(1.8 * ratio, 0.5 * size);
    context.beginPath();
    context.moveTo(left - size, top - size);
    context.lineTo(left + size, top + size);
    context.moveTo(left + size, top - size);
    context.lineTo(left - size, top + size);
    context.stroke();
  }

  at(plot, left, top) {
    const { length: columns } = this.x.places;
    const column = Math.round(plot.plot.posToVal(left, "x"));
    const line = Math.round(plot.plot.posToVal(top, "y"));
    if (column < 0 || column >= columns || line < 0) return null;
    const row = this.cells.get(column + columns * line);
    return row === undefined ? null : { row, ...this.middle(plot, column, line) };
  }

  find(plot, row) {
    for (const [place, other] of row < 0 ? [] : this.cells) {
      const { length: columns } = this.x.places;
      if (other === row) return this.middle(plot, place % columns, Math.floor(place / columns));
    }
    return null;
  }

  middle(plot, column, line) {
    return { left: plot.plot.valToPos(column, "x"), top: plot.plot.valToPos(line, "y") };
  }

  notes() {
    const failed = [...this.cells.values()].filter((row) => !this.cases.isDone(row)).length;
    const empty = this.x.places.length * this.y.places.length - this.cells.size;
    const notes = [];
    if (failed > 0) notes.push(`Red crosses: ${count(failed, "case")} that failed.`);
    if (empty > 0) notes.push(`${empty === 1 ? "One cell is" : `${empty} cells are`} empty: no case there has ended, or is shown.`);
    if (this.hidden > 0) notes.push(`${count(this.hidden, "case")} hidden behind others with the same values.`);
    return notes;
  }
}
