import { make } from "../elements.js";
import { Axis } from "../figures/axis.js";
import { clipTo, drawLine, onPage } from "../figures/line_figure.js";
import { formatNumber } from "../format.js";

// Curves over the frequency: each { name, values, colour(theme), isHidden }. `ticks` are natural frequencies { value, name }.
export class ResponseFigure {
  constructor({ curves, across, isLogAcross, up, isLogUp, ticks }) {
    Object.assign(this, { curves, across, ticks });
    const say = (value, digits) => formatNumber(value, digits);
    const values = curves.filter(({ isHidden }) => !isHidden).flatMap((curve) => Array.from(curve.values));
    this.x = new Axis({ name: across.name, isNumeric: true, say }, { isLog: isLogAcross, values: across.values });
    this.x.range = [across.values[0], across.values.at(-1)];
    if (!(this.x.range[0] < this.x.range[1])) this.x.range = this.x.findRange(across.values);
    this.y = new Axis({ name: up, isNumeric: true, say }, { isLog: isLogUp, values });
    this.lines = curves.map((curve) => Array.from(across.values, (x, i) => ({ i, curve, x, y: isLogUp && !(curve.values[i] > 0) ? NaN : curve.values[i] })));
  }

  draw(plot, context, theme) {
    this.drawTicks(plot, context, theme);
    clipTo(plot, context);
    context.lineJoin = "round";
    context.lineWidth = 1.6 * plot.ratio;
    for (const line of this.lines) {
      if (line.length === 0 || line[0].curve.isHidden) continue;
      context.strokeStyle = line[0].curve.colour(theme);
      drawLine(plot, context, line);
    }
  }

  // Dashed upright lines, with the number of the mode at the top.
  drawTicks(plot, context, theme) {
    const { left, top, width, height } = plot.box;
    context.save();
    context.strokeStyle = context.fillStyle = theme.muted;
    context.lineWidth = plot.ratio;
    context.font = `${10 * plot.ratio}px ${getComputedStyle(document.body).fontFamily}`;
    context.textAlign = "center";
    context.setLineDash([2 * plot.ratio, 3 * plot.ratio]);
    for (const { value, name } of this.ticks) {
      const at = plot.left(value);
      if (!(at >= left && at <= left + width)) continue;
      context.beginPath();
      context.moveTo(at, top);
      context.lineTo(at, top + height);
      context.stroke();
      context.fillText(name, at, top - 3 * plot.ratio);
    }
    context.restore();
  }

  // All curves at the frequency that is nearest.
  at(plot, left) {
    const points = this.lines[0] ?? [];
    let nearest = null;
    for (const point of points) {
      const at = onPage(plot, { left: plot.left(point.x), top: 0 }).left;
      const distance = Math.abs(at - left);
      if (!nearest || distance < nearest.distance) nearest = { i: point.i, at, distance };
    }
    if (!nearest) return null;
    const values = this.curves.filter(({ isHidden }) => !isHidden).map(({ name, values: all }) => make("span", {}, `${name} `, make("b", {}, formatNumber(all[nearest.i], 5))));
    const frequency = make("span", {}, `${this.across.symbol} = ${formatNumber(this.across.values[nearest.i], 5)}`);
    return { row: -1, i: nearest.i, left: nearest.at, top: 12, words: [frequency, ...values] };
  }
}
