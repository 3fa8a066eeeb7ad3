import uPlot from "uplot";
import { make } from "../elements.js";
import { readTheme } from "../theme.js";

// A chart whose axes uPlot draws and whose figure draws itself between them. A figure has
//   x, y           its axes,
//   draw(plot, context, theme)  in pixels of the canvas, through plot.left() and plot.top(),
//   at(plot, left, top)         what is there in pixels of the page: { row, left, top, words }, or null.
export class Plot {
  constructor(body, attention, describe) {
    this.body = body;
    this.attention = attention;
    this.describe = describe;
    this.tip = make("div", { className: "tip", hidden: true });
    this.rings = { pointed: make("div", { className: "ring" }), chosen: make("div", { className: "ring chosen" }) };
    new ResizeObserver(() => this.resize()).observe(body);
    attention.listen(() => this.placeRings());
  }

  show(figure) {
    this.figure = figure;
    this.plot?.destroy();
    this.tip.hidden = true;
    const { width, height } = this.size();
    const ends = (axis) => ({ time: false, distr: axis.isLog ? 3 : 1, range: () => axis.range });
    this.plot = new uPlot(
      {
        width,
        height,
        legend: { show: false },
        cursor: { show: false },
        pxAlign: 0,
        padding: [12, 16, 0, 0],
        scales: { x: ends(figure.x), y: ends(figure.y) },
        axes: [this.axis(figure.x, false), this.axis(figure.y, true)],
        series: [{}, { paths: () => null, points: { show: false } }],
        hooks: { draw: [() => this.draw(), () => this.placeRings()] }, // only now the axes are known
      },
      [figure.x.range, [null, null]],
      this.body,
    );
    const { over } = this.plot;
    over.append(this.rings.pointed, this.rings.chosen, this.tip);
    this.bindPointer(over);
    this.placeRings();
  }

  size() {
    return { width: Math.max(this.body.clientWidth, 220), height: Math.max(this.body.clientHeight, 200) };
  }

  resize() {
    if (!this.plot || this.body.clientWidth === 0) return;
    this.plot.setSize(this.size());
    this.placeRings();
  }

  redraw() {
    this.plot?.redraw(false, true);
  }

  axis(axis, isUpright) {
    const font = getComputedStyle(document.body).fontFamily;
    const pixels = (plot) => (isUpright ? plot.bbox.height : plot.bbox.width) / uPlot.pxRatio || 400;
    const options = {
      stroke: () => readTheme().muted,
      grid: { stroke: () => readTheme().line, width: 1, show: !axis.places },
      ticks: { show: false },
      font: `11px ${font}`,
      labelFont: `12px ${font}`,
      label: axis.label,
      labelSize: 20,
      labelGap: 0,
      gap: 5,
      size: isUpright ? widthOfTicks : 24,
      values: (plot, ticks) => axis.write(ticks),
      splits: (plot) => axis.ticks(pixels(plot), isUpright) ?? [],
      filter: (plot, ticks) => ticks,
    };
    if (!isUpright && axis.places) {
      options.rotate = (plot) => (axis.isSlanted(pixels(plot)) ? slant : 0);
      options.size = (plot) => (axis.isSlanted(pixels(plot)) ? 12 + 6.4 * longestName(axis) * Math.sin((slant * Math.PI) / 180) + 10 : 24);
    }
    return options;
  }

  // Pixels of the canvas.
  left(value) {
    return this.plot.valToPos(value, "x", true);
  }

  top(value) {
    return this.plot.valToPos(value, "y", true);
  }

  get ratio() {
    return uPlot.pxRatio;
  }

  get box() {
    return this.plot.bbox;
  }

  draw() {
    const { ctx: context } = this.plot ?? {};
    if (!context) return;
    context.save();
    this.figure.draw(this, context, readTheme());
    context.restore();
  }

  bindPointer(over) {
    const find = (event) => {
      const box = over.getBoundingClientRect();
      return this.figure.at(this, event.clientX - box.left, event.clientY - box.top);
    };
    over.addEventListener("pointermove", (event) => {
      const found = find(event);
      this.attention.point(found?.row ?? -1);
      this.showTip(found);
      over.style.cursor = found && found.row >= 0 ? "pointer" : "";
    });
    over.addEventListener("pointerleave", (event) => {
      if (event.pointerType !== "touch") this.leave();
    });
    over.addEventListener("click", (event) => {
      const found = find(event);
      if (found && found.row >= 0) this.attention.choose(found.row);
    });
  }

  leave() {
    this.attention.point(-1);
    this.showTip(null);
  }

  showTip(found) {
    this.tip.hidden = !found;
    if (!found) return;
    this.tip.replaceChildren(...(found.words ?? this.describe(found.row)));
    const { clientWidth: width, clientHeight: height } = this.plot.over;
    const left = found.left + 14 + this.tip.offsetWidth > width ? found.left - 14 - this.tip.offsetWidth : found.left + 14;
    const top = Math.min(Math.max(found.top - 12, 0), height - this.tip.offsetHeight);
    this.tip.style.transform = `translate(${Math.max(left, -40)}px, ${Math.max(top, 0)}px)`;
  }

  // Around the points of the case pointed at and of that chosen.
  placeRings() {
    if (!this.plot) return;
    for (const [which, ring] of Object.entries(this.rings)) {
      const place = this.figure.find?.(this, this.attention[which]);
      ring.hidden = !place;
      if (place) ring.style.transform = `translate(${place.left}px, ${place.top}px)`;
    }
  }
}

const slant = 35; // degrees
const longestName = (axis) => Math.max(...axis.names.map((name) => name.length));
const widthOfTicks = (plot, ticks) => 14 + 6.4 * Math.max(3, ...(ticks ?? []).map((tick) => tick.length));
