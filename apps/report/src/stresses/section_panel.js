import { listPlaces } from "../charts/along.js";
import { make } from "../elements.js";
import { formatNumber } from "../format.js";
import { makeSvgKey } from "../saving/svg.js";
import { ColourScale } from "../scene/colours.js";
import { measures, measureSection, surveyValues } from "./measures.js";
import { SectionPicture } from "./section_picture.js";

const names = ["N", "Vy", "Vz", "T", "My", "Mz"];
const slides = 1000; // of the slider along a rod

// The section at the chosen place with the stresses of the page's time, or of the worst step.
export class SectionPanel {
  constructor(data, stresses, words, place) {
    Object.assign(this, { data, stresses, words, place });
    this.rod = make("select", { "aria-label": "Rod" }, ...place.rods.map((rod) => make("option", { value: String(rod) }, words.rod(rod))));
    this.measure = make("select", { "aria-label": "Stress" }, ...Object.entries(measures).map(([key, { name }]) => make("option", { value: key }, name)));
    this.slider = make("input", { type: "range", min: "0", max: String(slides), step: "1", "aria-label": "Place along the rod" });
    this.where = make("output", {});
    this.extreme = make("p", { className: "extreme" });
    this.forces = make("p", { className: "note" });
    this.picture = new SectionPicture();
    this.tip = make("div", { className: "tip", hidden: true });
    this.figure = make("div", { className: "section-figure" }, this.picture.canvas, this.tip);
    this.bar = make("div", { className: "section-bar" });
    this.ticks = make("div", { className: "section-ticks" });
    this.element = this.makeElement();
    this.element.panel = () => this; // for tests
    this.bind();
    // Not updated while out of sight.
    new IntersectionObserver(([entry]) => {
      this.isSeen = entry.isIntersecting;
      this.show();
    }).observe(this.element);
  }

  makeElement() {
    this.rod.hidden = this.place.rods.length < 2;
    this.saveKey = makeSvgKey(() => this.element, () => this.readPicture());
    return make(
      "section",
      { className: "section" },
      this.saveKey,
      make("h2", {}, "Section"),
      make("div", { className: "along-choices" }, this.rod, this.measure, make("span", { className: "over" }, "A click on a rod chooses a place, too.")),
      make("label", { className: "place" }, this.slider, this.where),
      this.figure,
      make("div", { className: "section-scale" }, this.bar, this.ticks),
      this.extreme,
      this.forces,
    );
  }

  // As a file of its own.
  readPicture() {
    const words = [this.measure.selectedOptions[0].textContent, this.words.rod(this.place.rod), this.where.textContent];
    return { canvas: this.picture.canvas, draw: () => this.picture.redraw(), title: words.join(", ") };
  }

  bind() {
    const { place } = this;
    this.rod.addEventListener("change", () => place.choose(Number(this.rod.value), 0.5 * this.lengthOf(Number(this.rod.value))));
    this.slider.addEventListener("input", () => place.choose(place.rod, (Number(this.slider.value) / slides) * this.lengthOf(place.rod)));
    this.measure.addEventListener("change", () => this.show());
    place.listen(() => this.show());
    this.picture.canvas.addEventListener("pointermove", (event) => this.point(event));
    this.picture.canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
  }

  lengthOf(rod) {
    this.lengths ??= new Map();
    if (!this.lengths.has(rod)) this.lengths.set(rod, listPlaces(this.data, rod, "node").at(-1)?.s ?? 1);
    return this.lengths.get(rod);
  }

  // The element whose middle is nearest to the place.
  findCell() {
    const { rod, s } = this.place;
    if (this.rodOfCells !== rod) [this.rodOfCells, this.cellsOfRod] = [rod, listPlaces(this.data, rod, "cell")];
    return this.cellsOfRod.reduce((best, one) => (!best || Math.abs(one.s - s) < Math.abs(best.s - s) ? one : best), null);
  }

  // { section, resultants, words }; resultants are null where the page lacks them.
  findState() {
    const { held, clock } = this.place;
    const { words } = this;
    if (held) return { section: held.section, resultants: held.resultants, s: held.s, words: `worst of all steps, ${words.time} = ${formatNumber(held.time, 4)}` };
    const cell = this.findCell();
    const section = this.stresses.cellSections[cell?.row] ?? -1;
    return { section, resultants: cell ? this.resultantsAt(cell.row) : null, s: cell?.s ?? 0, words: `${words.time} = ${formatNumber(clock.time, 4)}` };
  }

  // At the clock's time; between frames, between their values.
  resultantsAt(row) {
    const { force, moment } = this.data.quantities;
    if (!force || !moment) return null;
    const { clock } = this.place;
    const frame = Math.min(Math.floor(clock.position), clock.last);
    const next = Math.min(frame + 1, clock.last);
    const part = clock.position - frame;
    const cells = this.data.offsets.length - 1;
    return [force, moment].flatMap(({ values }) =>
      [0, 1, 2].map((i) => (1 - part) * values[3 * (cells * frame + row) + i] + part * values[3 * (cells * next + row) + i]),
    );
  }

  show() {
    if (!this.isSeen) return;
    const { place, words } = this;
    this.rod.value = String(place.rod);
    this.slider.value = String(Math.round((slides * place.s) / this.lengthOf(place.rod)));
    const state = this.findState();
    const section = this.stresses.sections[state.section];
    this.where.textContent = `s = ${words.with(state.s, "length")}, ${state.words}`;
    const why = whyNothing(section, state);
    for (const part of [this.saveKey, this.figure, this.bar.parentElement, this.forces]) part.hidden = Boolean(why);
    this.extreme.textContent = why;
    if (!why) this.draw(section, state);
  }

  draw(section, { resultants }) {
    const { words } = this;
    const measure = measures[this.measure.value];
    this.section = section;
    this.values = measureSection(section, resultants, measure);
    const { range, point } = surveyValues(this.values, section.singular);
    const scale = new ColourScale(this.measure.value === "von_mises" || this.measure.value === "tau" ? [0, range[1]] : range);
    this.found = point;
    this.picture.show(section, this.values, scale, point);
    this.bar.style.background = scale.gradient();
    const ticks = [scale.least, 0.5 * (scale.least + scale.largest), scale.largest];
    this.ticks.replaceChildren(...ticks.map((value, i) => make("span", {}, i < 2 ? formatNumber(value, 3) : words.with(value, "force/length²", 3))));
    this.extreme.replaceChildren(...this.describe(point));
    const write = (value, i) => `${names[i]} ${words.with(value, i < 3 ? "force" : "force·length")}`;
    this.forces.textContent = `${section.name}: ${resultants.map(write).join(", ")}`;
  }

  // The largest value and where it is.
  describe(point) {
    if (point < 0) return ["No point of this section has a finite stress."];
    const { points, pointLayers, layers, singular } = this.section;
    const value = make("b", {}, this.words.with(this.values[point], "force/length²"));
    const left = singular.some(Boolean) ? "; points of notches without radius are left out" : "";
    const layer = layers.length > 1 ? `, ${layers[pointLayers[point]]}` : "";
    return [make("i", { className: "ring-sign" }), `${measures[this.measure.value].name} `, value, ` at ${this.words.point(points[2 * point], points[2 * point + 1])}${layer}${left}`];
  }

  // Tells the value at the pointer.
  point(event) {
    const point = this.section ? this.picture.find(event.offsetX, event.offsetY) : -1;
    this.tip.hidden = point < 0;
    if (point < 0) return;
    const { points, pointLayers, layers } = this.section;
    const rows = [["", this.words.with(this.values[point], "force/length²")], ["(y, z) =", this.words.point(points[2 * point], points[2 * point + 1])], ["", layers[pointLayers[point]]]];
    this.tip.replaceChildren(...rows.map(([name, text]) => make("span", {}, name ? `${name} ` : "", make("b", {}, text ?? ""))));
    const { clientWidth: width, clientHeight: height } = this.picture.canvas;
    const left = event.offsetX + 16 + this.tip.offsetWidth > width ? event.offsetX - 16 - this.tip.offsetWidth : event.offsetX + 16;
    this.tip.style.transform = `translate(${Math.max(left, 0)}px, ${Math.min(event.offsetY, height - this.tip.offsetHeight)}px)`;
  }

  recolour() {
    this.picture.redraw();
  }
}

// Why there is nothing to draw; "" if there is.
function whyNothing(section, { resultants }) {
  if (!section) return "No stresses here: this section has no shape, or follows a law.";
  if (!section.is_drawn) return "The cells of this section are not in this page, to keep it small.";
  if (!resultants) return "Section forces are not in this page, to keep it small.";
  return "";
}
