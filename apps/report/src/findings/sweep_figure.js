import { make } from "../elements.js";
import { Axis } from "../figures/axis.js";
import { clipTo, drawLine, drawMark, onPage } from "../figures/line_figure.js";
import { formatNumber } from "../format.js";
import { mostMultiples } from "./crossings.js";
import { ResponseFigure } from "./response_figure.js";

const reach = 14; // pixels from a curve to the pointer

// Curves of modes over a number of the deck, with the multiples of a speed { x, y } as rays, named 1P, 2P … where they leave the
// axes, the places where they meet curves { place, frequency }, and onsets { value, height, name } as marks. `rowOf(value, mode)`:
// what a press near a curve chooses, −1 for nothing; `wordsOf` likewise: what the mode is called there.
export class SweepFigure extends ResponseFigure {
  constructor({ speeds, onsets, crossings = [], startsAtZero = false, rowOf = () => -1, wordsOf = () => "", ...rest }) {
    super({ ...rest, isLogAcross: false, isLogUp: false, ticks: onsets.map(({ value, name }) => ({ value, name })) });
    const { values } = rest.across;
    this.x = new Axis({ name: rest.across.name, isNumeric: true, say: formatNumber }, { values });
    this.x.range = [Math.min(...values), Math.max(...values)];
    if (!(this.x.range[0] < this.x.range[1])) this.x.range = this.x.findRange(values);
    if (startsAtZero) this.y.range = [0, this.y.range[1] > 0 ? this.y.range[1] : 1];
    Object.assign(this, { rowOf, wordsOf, crossings });
    this.onsets = onsets.filter(({ height }) => height !== null);
    const [, top] = this.y.range;
    this.rays = speeds.some((speed) => speed !== 0)
      ? Array.from({ length: mostMultiples }, (_, i) => ({ multiple: i + 1, points: values.map((x, at) => ({ x, y: (i + 1) * Math.abs(speeds[at]) })) })).filter(({ points }) => Math.min(...points.map(({ y }) => y)) < top)
      : [];
  }

  draw(plot, context, theme) {
    this.drawRays(plot, context, theme);
    super.draw(plot, context, theme);
    for (const { curve, place, frequency } of this.crossings) {
      if (!this.curves[curve].isHidden) drawMark(plot, context, "circle", { left: plot.left(place), top: plot.top(frequency) }, { colour: theme.paper, edge: this.curves[curve].colour(theme), size: 2.5 });
    }
    for (const { value, height } of this.onsets) drawMark(plot, context, "circle", { left: plot.left(value), top: plot.top(height) }, { colour: theme.bad, edge: theme.paper, size: 4.5 });
  }

  drawRays(plot, context, theme) {
    context.save();
    clipTo(plot, context);
    context.strokeStyle = context.fillStyle = theme.muted;
    context.lineWidth = 0.7 * plot.ratio;
    context.font = `${10 * plot.ratio}px ${getComputedStyle(document.body).fontFamily}`;
    for (const { multiple, points } of this.rays) {
      context.setLineDash([4 * plot.ratio, 3 * plot.ratio]);
      drawLine(plot, context, points);
      this.nameRay(plot, context, `${multiple}P`, points);
    }
    context.restore();
  }

  // Where it leaves the axes: at their right end, or below their top.
  nameRay(plot, context, name, points) {
    const [, top] = this.y.range;
    const [first, ...others] = [...points].sort((a, b) => a.x - b.x);
    let [before, end] = [first, first];
    for (const point of others) {
      if (before.y >= top) break;
      const part = point.y > top ? (top - before.y) / (point.y - before.y) : 1;
      end = { x: before.x + part * (point.x - before.x), y: Math.min(point.y, top) };
      before = point;
    }
    const isAtTop = end.y >= top;
    context.textAlign = "right";
    context.textBaseline = isAtTop ? "top" : "bottom";
    context.fillText(name, plot.left(end.x) - 3 * plot.ratio, plot.top(end.y) + (isAtTop ? 3 : -1) * plot.ratio);
  }

  // All curves at the nearest value, and the mode whose curve is nearest there.
  at(plot, left, top) {
    const found = super.at(plot, left);
    if (!found) return null;
    let nearest = null;
    this.lines.forEach((line, mode) => {
      const point = line[found.i];
      if (point.curve.isHidden || !Number.isFinite(point.y)) return;
      const height = onPage(plot, { left: 0, top: plot.top(point.y) }).top;
      const distance = Math.abs(height - top);
      if (distance < (nearest?.distance ?? reach)) nearest = { mode, height, distance };
    });
    if (!nearest) return found;
    const words = this.wordsOf(found.i, nearest.mode);
    return { ...found, row: this.rowOf(found.i, nearest.mode), top: nearest.height, words: [...found.words, ...(words ? [make("span", {}, words)] : [])] };
  }

  // The point of a row, within the axes.
  find(plot, row) {
    if (row < 0) return null;
    for (const [mode, line] of this.lines.entries()) {
      const point = line.find(({ i }) => this.rowOf(i, mode) === row);
      if (!point) continue;
      return point.curve.isHidden || !Number.isFinite(point.y) ? null : onPage(plot, { left: plot.left(point.x), top: plot.top(point.y) });
    }
    return null;
  }
}
