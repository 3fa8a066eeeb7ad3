import { Axis } from "../figures/axis.js";
import { clipTo, drawLine, drawMark } from "../figures/line_figure.js";
import { formatNumber } from "../format.js";
import { ResponseFigure } from "./response_figure.js";

const mostRays = 8;

// Curves of modes over a number of the deck, with the multiples of a speed { x, y } as rays and onsets { value, height, name }
// as marks.
export class SweepFigure extends ResponseFigure {
  constructor({ speeds, onsets, ...rest }) {
    super({ ...rest, isLogAcross: false, isLogUp: false, ticks: onsets.map(({ value, name }) => ({ value, name })) });
    const { values } = rest.across;
    this.x = new Axis({ name: rest.across.name, isNumeric: true, say: formatNumber }, { values });
    this.onsets = onsets.filter(({ height }) => height !== null);
    this.rays = speeds.some((speed) => speed !== 0)
      ? Array.from({ length: mostRays }, (_, i) => values.map((x, at) => ({ x, y: (i + 1) * Math.abs(speeds[at]) })))
      : [];
  }

  draw(plot, context, theme) {
    context.save();
    clipTo(plot, context);
    context.strokeStyle = context.fillStyle = theme.muted;
    context.lineWidth = 0.7 * plot.ratio;
    context.font = `${10 * plot.ratio}px ${getComputedStyle(document.body).fontFamily}`;
    context.textAlign = "right";
    context.setLineDash([4 * plot.ratio, 3 * plot.ratio]);
    const { top } = plot.box;
    this.rays.forEach((ray, i) => {
      drawLine(plot, context, ray);
      const inside = ray.filter((point) => point.top > top + 12 * plot.ratio).sort((a, b) => a.left - b.left);
      if (inside.length > 0) context.fillText(`${i + 1}×`, inside.at(-1).left, inside.at(-1).top - 2 * plot.ratio);
    });
    context.restore();
    super.draw(plot, context, theme);
    for (const { value, height } of this.onsets) drawMark(plot, context, "circle", { left: plot.left(value), top: plot.top(height) }, { colour: theme.bad, edge: theme.paper, size: 4.5 });
  }
}
