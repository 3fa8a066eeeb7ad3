// Writes down as elements of an SVG what is drawn on a canvas meanwhile. What an element looks like is asked of the context itself.

const round = (number) => String(Math.round(100 * number) / 100);
const escapes = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };
export const escapeXml = (text) => String(text).replaceAll(/[&<>"]/g, (letter) => escapes[letter]).replaceAll(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]/g, "");

// A path as commands [letter, …numbers], in the coordinates in which it was drawn.
const pathMethods = {
  moveTo: (x, y) => [["M", x, y]],
  lineTo: (x, y) => [["L", x, y]],
  closePath: () => [["Z"]],
  bezierCurveTo: (...numbers) => [["C", ...numbers]],
  quadraticCurveTo: (...numbers) => [["Q", ...numbers]],
  rect: (x, y, width, height) => [["M", x, y], ["L", x + width, y], ["L", x + width, y + height], ["L", x, y + height], ["Z"]],
  arc: (x, y, radius, from, to, isBack) => [["A", x, y, radius, from, to, Boolean(isBack)]],
};

// Path2D that remembers its commands, for charts that keep their paths.
export class RecordedPath extends Path2D {
  constructor(other) {
    super(other);
    this.commands = other?.commands ? [...other.commands] : [];
  }
}
const drawn = Path2D.prototype;
for (const [name, list] of Object.entries(pathMethods)) {
  RecordedPath.prototype[name] = function (...numbers) {
    this.commands.push(...list(...numbers));
    drawn[name].apply(this, numbers);
  };
}

export class Recorder {
  constructor(context) {
    this.context = context;
    this.elements = [];
    this.definitions = [];
    this.clips = [];
    this.saved = [];
    this.path = [];
  }

  // Records while `draw` draws. New paths are such that can be recorded.
  during(draw) {
    const own = this.methods();
    Object.assign(this.context, own);
    const known = globalThis.Path2D;
    globalThis.Path2D = RecordedPath;
    try {
      draw();
    } finally {
      globalThis.Path2D = known;
      for (const name of Object.keys(own)) delete this.context[name];
    }
  }

  // What stands before the methods of the context, which then do their work.
  methods() {
    const { context } = this;
    const known = Object.getPrototypeOf(context);
    const records = {
      save: () => this.saved.push([...this.clips]),
      restore: () => (this.clips = this.saved.pop() ?? []),
      beginPath: () => (this.path = []),
      stroke: (path) => this.addPath(path?.commands ? this.trace(path.commands) : this.path.join(""), true),
      fill: (path) => this.addPath(path?.commands ? this.trace(path.commands) : this.path.join(""), false),
      clip: (path) => this.addClip(path?.commands ? this.trace(path.commands) : this.path.join("")),
      fillRect: (...box) => this.addPath(this.trace(pathMethods.rect(...box)), false),
      fillText: (text, x, y) => this.addText(text, x, y),
      putImageData: (image, x, y) => this.addImage(image, x, y),
    };
    for (const [name, list] of Object.entries(pathMethods)) records[name] = (...numbers) => this.path.push(this.trace(list(...numbers), this.path.length > 0));
    return Object.fromEntries(Object.entries(records).map(([name, record]) => [name, (...values) => {
      record(...values);
      return known[name].apply(context, values);
    }]));
  }

  // Commands as the text of a path, in pixels of the canvas. As on a canvas, the first line only moves to its point.
  trace(commands, isJoined = false) {
    const at = this.context.getTransform();
    const point = (x, y) => `${round(at.a * x + at.c * y + at.e)} ${round(at.b * x + at.d * y + at.f)}`;
    let text = "";
    for (const [letter, ...numbers] of commands) {
      const isFirst = text === "" && !isJoined;
      if (letter === "A") {
        text += traceArc(point, Math.hypot(at.a, at.b), numbers, !isFirst);
        continue;
      }
      const points = [];
      for (let i = 0; i < numbers.length; i += 2) points.push(point(numbers[i], numbers[i + 1]));
      text += (isFirst && letter === "L" ? "M" : letter) + points.join(" ");
    }
    return text;
  }

  // An element within the clips that hold now.
  add(element) {
    this.elements.push(this.clips.reduceRight((inner, clip) => `<g clip-path="url(#${clip})">${inner}</g>`, element));
  }

  addPath(data, isStroke) {
    const { context } = this;
    if (data === "" || /^M[^LCQA]*$/.test(data)) return;
    const [colour, opacity] = readColour(isStroke ? context.strokeStyle : context.fillStyle);
    const alpha = opacity * context.globalAlpha;
    if (alpha === 0) return;
    const name = isStroke ? "stroke" : "fill";
    const words = [`d="${data}"`, isStroke ? 'fill="none"' : "", `${name}="${colour}"`, alpha < 1 ? `${name}-opacity="${round(alpha)}"` : ""];
    if (isStroke) {
      const dash = context.getLineDash();
      words.push(`stroke-width="${round(context.lineWidth)}"`, `stroke-linejoin="${context.lineJoin}"`, `stroke-linecap="${context.lineCap}"`);
      if (dash.length > 0) words.push(`stroke-dasharray="${dash.map(round).join(" ")}"`);
    }
    this.add(`<path ${words.filter(Boolean).join(" ")}/>`);
  }

  addClip(data) {
    const name = `clip${this.definitions.length + 1}`;
    this.definitions.push(`<clipPath id="${name}"><path d="${data}"/></clipPath>`);
    this.clips = [...this.clips, name];
  }

  addText(text, x, y) {
    const { context } = this;
    if (String(text).trim() === "") return;
    const [, weight, size] = /^(.*?)([\d.]+)px/.exec(context.font) ?? [null, "", "11"];
    const [colour, opacity] = readColour(context.fillStyle);
    const at = context.getTransform();
    // Where the letters stand from where the canvas has them, in their size: the same in all programs.
    const drop = { top: 0.8, hanging: 0.8, middle: 0.35, bottom: -0.22, ideographic: -0.22 }[context.textBaseline] ?? 0;
    const anchor = { center: "middle", right: "end", end: "end" }[context.textAlign] ?? "start";
    const place = `x="${round(x)}" y="${round(y + drop * Number(size))}"`;
    const isTurned = at.b !== 0 || at.c !== 0 || at.a !== 1 || at.d !== 1 || at.e !== 0 || at.f !== 0;
    const matrix = [at.a, at.b, at.c, at.d].map((number) => String(Math.round(1e6 * number) / 1e6)).concat(round(at.e), round(at.f)).join(" ");
    const words = [place, `font-size="${size}"`, /bold|[6-9]00/.test(weight) ? 'font-weight="bold"' : "", `text-anchor="${anchor}"`, `fill="${colour}"`,
      opacity < 1 ? `fill-opacity="${round(opacity)}"` : "", isTurned ? `transform="matrix(${matrix})"` : ""];
    this.add(`<text ${words.filter(Boolean).join(" ")}>${escapeXml(text)}</text>`);
  }

  addImage(image, x, y) {
    const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    canvas.getContext("2d").putImageData(image, 0, 0);
    this.add(`<image x="${round(x)}" y="${round(y)}" width="${image.width}" height="${image.height}" href="${canvas.toDataURL("image/png")}"/>`);
  }
}

// An arc of a circle; a whole one is two halves.
function traceArc(point, scale, [x, y, radius, from, to, isBack], isJoined) {
  const at = (angle) => point(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
  const turn = isBack ? from - to : to - from;
  const size = round(radius * scale);
  const start = `${isJoined ? "L" : "M"}${at(from)}`;
  const sweep = isBack ? 0 : 1;
  if (turn >= 2 * Math.PI - 1e-6) return `M${at(from)}A${size} ${size} 0 1 ${sweep} ${at(from + Math.PI)}A${size} ${size} 0 1 ${sweep} ${at(from)}Z`;
  return `${start}A${size} ${size} 0 ${turn > Math.PI ? 1 : 0} ${sweep} ${at(to)}`;
}

const colours = new Map();

// Any colour of CSS as [#rrggbb, opacity], which all programs know.
export function readColour(style) {
  if (typeof style !== "string") return ["#000000", 1];
  if (!colours.has(style)) {
    const context = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });
    context.fillStyle = style;
    context.fillRect(0, 0, 1, 1);
    const [red, green, blue, alpha] = context.getImageData(0, 0, 1, 1).data;
    colours.set(style, [`#${[red, green, blue].map((byte) => byte.toString(16).padStart(2, "0")).join("")}`, alpha / 255]);
  }
  return colours.get(style);
}
