import { Axis } from "../figures/axis.js";
import { slopeOf } from "./statistics.js";

const edge = 8; // pixels between a mark at the edge and the edge
const reach = 20; // pixels within which a point is found

// A point a case; those that share all other parameters are joined by a line. A case without a value is a cross at
// the lower edge.
export class PointFigure {
  constructor({ cases, rows, across, value, paint, others, isJoined, logAcross, logValue }) {
    Object.assign(this, { cases, paint, value, across });
    const kept = rows.filter((row) => Number.isFinite(across.numbers[row]));
    this.hasNoPlace = rows.length - kept.length;
    const marks = across.group === "parameter" ? across.values : [];
    this.x = across.isNumeric ? new Axis(across, { isLog: logAcross, values: kept.map((row) => across.numbers[row]), marks }) : Axis.ofPlaces(across);
    const withValue = kept.filter((row) => this.hasValue(row));
    this.y = value.isNumeric ? new Axis(value, { isLog: logValue, values: withValue.map((row) => value.numbers[row]) }) : Axis.ofPlaces(value);
    this.points = kept.map((row) => this.makePoint(row)).filter((point) => Number.isFinite(point.x));
    this.zeros = kept.length - this.points.length + this.points.filter((point) => point.isZero).length;
    this.lines = isJoined ? this.joinPoints(others) : [];
    this.slopes = this.x.isLog && this.y.isLog ? this.findSlopes() : new Map();
  }

  // A failed case has values only in columns of the run itself.
  hasValue(row) {
    const isFinite = Number.isFinite(this.value.numbers[row]);
    return isFinite && (this.value.group !== "collected" || this.cases.isDone(row));
  }

  makePoint(row) {
    const has = this.hasValue(row);
    const y = has ? this.y.place(this.value.numbers[row]) : NaN;
    return { row, x: this.x.place(this.across.numbers[row]), y, isZero: has && Number.isNaN(y), isDone: this.cases.isDone(row) };
  }

  joinPoints(others) {
    const groups = new Map();
    for (const point of this.points) {
      const key = others.map((column) => column.numbers[point.row]).join(" ");
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(point);
    }
    const lines = [...groups.values()].filter((line) => line.length > 1);
    for (const line of lines) line.sort((a, b) => a.x - b.x || a.row - b.row);
    return lines;
  }

  // Of each colour that is one line: how a value falls or rises with the parameter, as a power.
  findSlopes() {
    const lines = new Map();
    for (const line of this.lines) {
      const of = this.paint.column ? this.paint.column.numbers[line[0].row] : 0;
      lines.set(of, [...(lines.get(of) ?? []), line]);
    }
    const slopes = new Map();
    for (const [of, [line, ...more]] of lines) {
      const points = line.filter((point) => point.y > 0 && point.isDone);
      if (more.length === 0 && points.length > 2) slopes.set(of, slopeOf(points));
    }
    return slopes;
  }

  draw(plot, context, theme) {
    const { left, top, width, height } = plot.box;
    const bottom = top + height - edge * plot.ratio;
    for (const point of this.points) {
      point.left = plot.left(point.x);
      point.top = Number.isFinite(point.y) ? plot.top(point.y) : bottom;
    }
    this.origin = { left, top, ratio: plot.ratio };
    context.beginPath();
    context.rect(left, top, width, height);
    context.clip();
    this.drawLines(context, theme, plot.ratio);
    this.drawPoints(context, theme, plot.ratio);
    this.drawCrosses(context, theme, plot.ratio);
  }

  drawLines(context, theme, ratio) {
    context.lineWidth = 1.5 * ratio;
    context.lineJoin = "round";
    for (const line of this.lines) {
      if (this.paint.isHidden(line[0].row)) continue;
      context.strokeStyle = this.paint.colour(line[0].row, theme);
      context.beginPath();
      let isDown = false;
      for (const point of line) {
        // A case that failed leaves a gap.
        if (!Number.isFinite(point.y)) isDown = false;
        else if (isDown) context.lineTo(point.left, point.top);
        else {
          context.moveTo(point.left, point.top);
          isDown = true;
        }
      }
      context.stroke();
    }
  }

  drawPoints(context, theme, ratio) {
    const many = this.points.length;
    const radius = ratio * (many > 3000 ? 1.8 : many > 600 ? 2.4 : 3.2);
    context.globalAlpha = many > 3000 ? 0.6 : 1;
    const byColour = new Map();
    for (const point of this.points) {
      if (!Number.isFinite(point.y) || !point.isDone || this.paint.isHidden(point.row)) continue;
      const colour = this.paint.colour(point.row, theme);
      if (!byColour.has(colour)) byColour.set(colour, []);
      byColour.get(colour).push(point);
    }
    for (const [colour, points] of byColour) {
      context.fillStyle = colour;
      context.beginPath();
      for (const { left, top } of points) {
        context.moveTo(left + radius, top);
        context.arc(left, top, radius, 0, 2 * Math.PI);
      }
      context.fill();
    }
    context.globalAlpha = 1;
  }

  drawCrosses(context, theme, ratio) {
    const size = 3.6 * ratio;
    context.lineWidth = 1.8 * ratio;
    for (const isDone of [true, false]) {
      context.strokeStyle = isDone ? theme.muted : theme.bad;
      context.beginPath();
      for (const point of this.points) {
        if (point.isDone !== isDone || (isDone && Number.isFinite(point.y)) || this.paint.isHidden(point.row)) continue;
        const { left, top } = point;
        context.moveTo(left - size, top - size);
        context.lineTo(left + size, top + size);
        context.moveTo(left + size, top - size);
        context.lineTo(left - size, top + size);
      }
      context.stroke();
    }
  }

  // Pixels of the page from those of the canvas.
  placeOf(point) {
    const { left, top, ratio } = this.origin;
    return { left: (point.left - left) / ratio, top: (point.top - top) / ratio };
  }

  at(plot, left, top) {
    let nearest = null;
    let least = reach ** 2;
    for (const point of this.points) {
      if (this.paint.isHidden(point.row)) continue;
      const place = this.placeOf(point);
      const distance = (place.left - left) ** 2 + (place.top - top) ** 2;
      if (distance < least) [nearest, least] = [{ row: point.row, ...place }, distance];
    }
    return nearest;
  }

  find(plot, row) {
    const point = row < 0 || !this.origin ? undefined : this.points.find((candidate) => candidate.row === row);
    return point && !this.paint.isHidden(row) ? this.placeOf(point) : null;
  }

  notes() {
    const notes = [];
    const lost = this.points.filter((point) => !Number.isFinite(point.y) && !point.isZero);
    const failed = lost.filter((point) => !point.isDone).length;
    if (failed > 0) notes.push(`Red crosses at the lower edge: ${count(failed, "case")} that failed.`);
    if (lost.length > failed) notes.push(`Grey crosses at the lower edge: ${count(lost.length - failed, "case")} without a value.`);
    if (this.zeros > 0) notes.push(`${count(this.zeros, "case")} at zero, which a logarithmic axis cannot show.`);
    if (this.hasNoPlace > 0) notes.push(`${count(this.hasNoPlace, "case")} without a value of ${this.across.name}, not shown.`);
    return notes;
  }
}

export const count = (number, noun) => `${number} ${noun}${number === 1 ? "" : "s"}`;
