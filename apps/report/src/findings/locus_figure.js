import { make } from "../elements.js";
import { Axis } from "../figures/axis.js";
import { clipTo, drawMark, findNearest, onPage } from "../figures/line_figure.js";
import { formatNumber } from "../format.js";
import { describeValue, realPart } from "./mode_values.js";

const reach = 24;

// Eigenvalues in the complex plane, a colour for each stage; what lies to the right of the upright line grows. A row is an
// index among all of them.
export class LocusFigure {
  constructor(stages, names) {
    this.stages = stages;
    this.points = stages.flatMap((modes, stage) =>
      modes.words.map((words, i) => ({ stage, i, words, x: realPart(modes, i), y: modes.omega[i] })),
    );
    this.points.forEach((point, row) => (point.row = row));
    const say = (value, digits) => formatNumber(value, digits);
    const axisOf = (name, values) => new Axis({ name, isNumeric: true, say }, { values });
    this.x = axisOf(names[0], [...this.points.map(({ x }) => x), 0]);
    this.y = axisOf(names[1], [...this.points.map(({ y }) => y), 0]);
  }

  draw(plot, context, theme) {
    clipTo(plot, context);
    const { top, height } = plot.box;
    context.strokeStyle = theme.muted;
    context.lineWidth = plot.ratio;
    context.beginPath();
    context.moveTo(plot.left(0), top);
    context.lineTo(plot.left(0), top + height);
    context.stroke();
    for (const point of this.points) {
      point.left = plot.left(point.x);
      point.top = plot.top(point.y);
      const colour = point.x > 0 ? theme.bad : theme.series[point.stage % theme.series.length];
      drawMark(plot, context, "circle", point, { colour, edge: theme.paper, size: 4.5 });
    }
  }

  at(plot, left, top) {
    const found = findNearest(plot, this.points, left, top, reach);
    if (!found) return null;
    const { stage, i, words, row } = found.point;
    const modes = this.stages[stage];
    const name = this.stages.length > 1 ? `${modes.stage}, mode ${i + 1}` : `mode ${i + 1}`;
    return { row, left: found.left, top: found.top, words: [make("b", {}, name), make("span", {}, describeValue(modes, i)), make("em", {}, words)] };
  }

  find(plot, row) {
    const point = this.points[row];
    return point ? onPage(plot, { left: plot.left(point.x), top: plot.top(point.y) }) : null;
  }
}
