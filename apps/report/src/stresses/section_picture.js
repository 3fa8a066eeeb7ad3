import { make } from "../elements.js";
import { readTheme } from "../theme.js";

const margin = 26;
const legendOfAxes = 30;

// A section as seen against x: y to the right, z up; values between points of its cells, + at the rod.
export class SectionPicture {
  constructor() {
    this.canvas = make("canvas", { className: "section-canvas", "aria-label": "Stresses in the section" });
    new ResizeObserver(() => this.redraw()).observe(this.canvas);
  }

  // values: at the points of the section; point: the one that is marked.
  show(section, values, scale, point) {
    Object.assign(this, { section, values, scale, point });
    this.redraw();
  }

  redraw() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const context = this.canvas.getContext("2d");
    if (!context || width === 0) return;
    this.ratio = Math.min(devicePixelRatio, 2);
    Object.assign(this.canvas, { width: Math.round(width * this.ratio), height: Math.round(height * this.ratio) });
    if (!this.section) return;
    this.place();
    this.paintCells(context);
    this.drawOutline(context);
    this.drawMarks(context);
  }

  // From y, z to pixels of the canvas.
  place() {
    const { points } = this.section;
    const [least, largest] = [[0, 0], [0, 0]]; // the rod is in the picture
    for (let i = 0; i < points.length; i++) {
      least[i % 2] = Math.min(least[i % 2], points[i]);
      largest[i % 2] = Math.max(largest[i % 2], points[i]);
    }
    const { width, height } = this.canvas;
    const room = 2 * margin * this.ratio;
    this.size = Math.min((width - room) / (largest[0] - least[0] || 1), (height - room) / (largest[1] - least[1] || 1));
    this.middle = [0, 1].map((i) => 0.5 * (least[i] + largest[i]));
    this.pixels = new Float32Array(points.length);
    for (let i = 0; i < points.length; i += 2) this.pixels.set(this.toPixels(points[i], points[i + 1]), i);
  }

  toPixels(y, z) {
    return [0.5 * this.canvas.width + this.size * (y - this.middle[0]), 0.5 * this.canvas.height - this.size * (z - this.middle[1])];
  }

  // The point nearest to a place on the page, within reach; −1 without.
  find(left, top) {
    let [found, nearest] = [-1, (12 * this.ratio) ** 2];
    for (let i = 0; i < (this.pixels?.length ?? 0); i += 2) {
      const distance = (this.pixels[i] - left * this.ratio) ** 2 + (this.pixels[i + 1] - top * this.ratio) ** 2;
      if (distance < nearest) [found, nearest] = [i / 2, distance];
    }
    return found;
  }

  paintCells(context) {
    const image = context.createImageData(this.canvas.width, this.canvas.height);
    const colours = this.scale.bytes();
    const { cells, corners } = this.section;
    for (let first = 0; first < cells.length; first += corners) {
      for (let third = 2; third < corners; third++) this.paintTriangle(image, colours, [cells[first], cells[first + third - 1], cells[first + third]]);
    }
    context.putImageData(image, 0, 0);
  }

  // Linear between the corners.
  paintTriangle({ data, width, height }, colours, corners) {
    const [ax, bx, cx] = corners.map((point) => this.pixels[2 * point]);
    const [ay, by, cy] = corners.map((point) => this.pixels[2 * point + 1]);
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (area === 0) return;
    const { least, largest } = this.scale;
    const steps = colours.length / 3 - 1;
    const [va, vb, vc] = corners.map((point) => (steps * (this.values[point] - least)) / (largest - least || 1));
    const rows = [Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5)), Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5))];
    const columns = [Math.max(0, Math.ceil(Math.min(ax, bx, cx) - 0.5)), Math.min(width - 1, Math.floor(Math.max(ax, bx, cx) - 0.5))];
    for (let row = rows[0]; row <= rows[1]; row++) {
      for (let column = columns[0]; column <= columns[1]; column++) {
        const [x, y] = [column + 0.5, row + 0.5];
        const b = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area;
        const c = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
        if (b < 0 || c < 0 || b + c > 1) continue;
        const value = va + b * (vb - va) + c * (vc - va);
        const from = 3 * Math.max(0, Math.min(steps, Math.round(value)));
        const to = 4 * (row * width + column);
        data[to] = colours[from];
        data[to + 1] = colours[from + 1];
        data[to + 2] = colours[from + 2];
        data[to + 3] = 255;
      }
    }
  }

  drawOutline(context) {
    this.section.outline ??= listOutline(this.section);
    context.beginPath();
    for (const [from, to] of this.section.outline) {
      context.moveTo(this.pixels[2 * from], this.pixels[2 * from + 1]);
      context.lineTo(this.pixels[2 * to], this.pixels[2 * to + 1]);
    }
    context.strokeStyle = readTheme().ink;
    context.lineWidth = 1.1 * this.ratio;
    context.stroke();
  }

  drawMarks(context) {
    const theme = readTheme();
    const { ratio } = this;
    context.font = `${11 * ratio}px ${getComputedStyle(document.body).fontFamily}`;
    const [y, z] = this.toPixels(0, 0);
    drawLines(context, theme, ratio, [[y - 6 * ratio, z, y + 6 * ratio, z], [y, z - 6 * ratio, y, z + 6 * ratio]]);
    this.drawAxes(context, theme);
    if (this.point < 0) return;
    context.beginPath();
    context.arc(this.pixels[2 * this.point], this.pixels[2 * this.point + 1], 6 * ratio, 0, 2 * Math.PI);
    context.lineWidth = 4.5 * ratio;
    context.strokeStyle = theme.paper;
    context.stroke();
    context.lineWidth = 2 * ratio;
    context.strokeStyle = theme.bad;
    context.stroke();
  }

  drawAxes(context, theme) {
    const { ratio } = this;
    const [left, bottom, length] = [8 * ratio, this.canvas.height - 10 * ratio, legendOfAxes * ratio];
    drawLines(context, theme, ratio, [[left, bottom, left + length, bottom], [left, bottom, left, bottom - length]]);
    context.fillStyle = theme.muted;
    context.fillText("y", left + length + 4 * ratio, bottom + 4 * ratio);
    context.fillText("z", left - 3 * ratio, bottom - length - 5 * ratio);
  }
}

function drawLines(context, theme, ratio, lines) {
  for (const [colour, width] of [[theme.paper, 3.5], [theme.ink, 1.4]]) {
    context.beginPath();
    for (const [fromX, fromY, toX, toY] of lines) {
      context.moveTo(fromX, fromY);
      context.lineTo(toX, toY);
    }
    context.strokeStyle = colour;
    context.lineWidth = width * ratio;
    context.stroke();
  }
}

// Edges of one cell alone: the outline, and where layers meet, which have points of their own.
function listOutline({ cells, corners }) {
  const edges = new Map();
  for (let first = 0; first < cells.length; first += corners) {
    for (let i = 0; i < corners; i++) {
      const [from, to] = [cells[first + i], cells[first + ((i + 1) % corners)]];
      if (from === to) continue;
      const key = from < to ? `${from} ${to}` : `${to} ${from}`;
      if (edges.has(key)) edges.set(key, null);
      else edges.set(key, [from, to]);
    }
  }
  return [...edges.values()].filter(Boolean);
}
