import { make } from "../elements.js";
import { Axis } from "../figures/axis.js";
import { clipTo, drawLine, onPage } from "../figures/line_figure.js";
import { formatNumber } from "../format.js";

// The largest value of all steps along a rod, and the limit of exposure. `points` are rows of the envelopes by arc length.
export class EnvelopeFigure {
  constructor({ points, across, up, limit, describe }) {
    Object.assign(this, { limit, describe });
    this.line = points.map((worst) => ({ x: worst.s, y: worst.value, worst }));
    const say = (value, digits) => formatNumber(value, digits);
    const values = this.line.map(({ y }) => y).concat(0, limit === null ? [] : [limit]);
    this.x = new Axis({ name: across, isNumeric: true, say }, { values: this.line.map(({ x }) => x) });
    this.y = new Axis({ name: up, isNumeric: true, say }, { values });
    this.y.range[0] = 0;
  }

  draw(plot, context, theme) {
    clipTo(plot, context);
    context.lineJoin = "round";
    context.lineWidth = 2 * plot.ratio;
    context.strokeStyle = theme.series[0];
    drawLine(plot, context, this.line);
    if (this.limit === null) return;
    const { left, width } = plot.box;
    context.strokeStyle = theme.bad;
    context.lineWidth = 1.2 * plot.ratio;
    context.setLineDash([6 * plot.ratio, 4 * plot.ratio]);
    context.beginPath();
    context.moveTo(left, plot.top(this.limit));
    context.lineTo(left + width, plot.top(this.limit));
    context.stroke();
  }

  // The place nearest to the pointer across; of two at a node the larger value.
  at(plot, left) {
    let nearest = null;
    for (const [row, point] of this.line.entries()) {
      if (!Number.isFinite(point.y)) continue;
      const at = onPage(plot, { left: plot.left(point.x), top: plot.top(point.y) });
      const distance = Math.abs(at.left - left);
      const isNearer = !nearest || distance < nearest.distance - 0.5 || (distance < nearest.distance + 0.5 && point.y > nearest.point.y);
      if (isNearer) nearest = { row, point, at, distance };
    }
    if (!nearest) return null;
    const words = this.describe(nearest.point.worst).map(([name, value]) => make("span", {}, `${name} `, make("b", {}, value)));
    return { row: nearest.row, ...nearest.at, words };
  }

  // Where the ring of a row is.
  find(plot, row) {
    const point = this.line[row];
    return point && Number.isFinite(point.y) ? onPage(plot, { left: plot.left(point.x), top: plot.top(point.y) }) : null;
  }
}
