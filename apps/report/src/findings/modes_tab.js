import { make } from "../elements.js";
import { Plot } from "../figures/plot.js";
import { formatNumber } from "../format.js";
import { addSvgKey } from "../saving/svg.js";
import { makeTableKeys } from "../saving/tables.js";
import { unitOf } from "../units.js";
import { LocusFigure } from "./locus_figure.js";
import { describeMass, describeValue, listColumns, titles } from "./mode_values.js";

const amplitudes = { least: -2, largest: 2, step: 0.1 }; // powers of two

// What the buttons of a mode choose.
export function shapeOf(modes, index) {
  return { shapes: modes.shapes, index, title: `${modes.stage} ${index + 1}`, text: describeValue(modes, index), words: modes.words[index] };
}

// Modes, buckling and eigenvalues of all stages: eigenvalues in the complex plane, then a list for each stage. Choosing one
// lets the picture swing.
export class ModesTab {
  constructor(stages, { swinging, units }) {
    Object.assign(this, { swinging, units });
    this.element = make("div", {});
    const loci = stages.filter(({ kind }) => kind === "eigenvalues");
    if (swinging && stages.some(({ shapes }) => shapes)) this.element.append(this.makeAmplitude());
    if (loci.length > 0) this.element.append(this.makeLocus(loci));
    this.element.append(...stages.map((modes) => this.makeList(modes)));
  }

  makeAmplitude() {
    const { least, largest, step } = amplitudes;
    const slider = make("input", { type: "range", id: "amplitude", min: String(least), max: String(largest), step: String(step), value: "0" });
    const text = make("span", { className: "value" }, "1×");
    slider.addEventListener("input", () => {
      const amplitude = 2 ** Number(slider.value);
      text.textContent = `${formatNumber(amplitude, 2)}×`;
      this.swinging.setAmplitude(amplitude);
    });
    slider.title = "1×: the largest displacement is a tenth of the model";
    return make("label", { className: "amplitude" }, "Amplitude", slider, text);
  }

  canSwing(modes, index) {
    return this.swinging !== null && modes.shapes !== null && index < modes.shapes.count;
  }

  makeLocus(loci) {
    const rate = unitOf("1/time", this.units);
    const figure = new LocusFigure(loci, [`Re λ, ${rate}`, `Im λ, ${unitOf("angle/time", this.units)}`]);
    const attention = { pointed: -1, chosen: -1, listen() {}, point() {} };
    attention.choose = (row) => {
      const { stage, i } = figure.points[row];
      if (this.canSwing(loci[stage], i)) this.swinging.choose(shapeOf(loci[stage], i));
    };
    const body = make("div", { className: "figure" });
    this.plot = new Plot(body, attention, () => []);
    this.plot.show(figure);
    body.figure = () => figure; // for tests
    this.swinging?.listen(() => {
      attention.chosen = figure.points.findIndex(({ stage, i }) => this.swinging.isAt({ shapes: loci[stage].shapes, index: i }));
      this.plot.placeRings();
    });
    const keys = loci.length < 2 ? [] : loci.map(({ stage }, i) => {
      const key = make("span", { className: "key" }, make("i"), stage);
      key.style.setProperty("--series", `var(--series-${(i % 4) + 1})`);
      return key;
    });
    const section = make("section", { className: "chart" }, make("h3", {}, "Eigenvalues λ in the complex plane"), make("div", { className: "keys" }, ...keys), body);
    addSvgKey(section, () => this.plot.plot);
    return section;
  }

  makeList(modes) {
    const columns = listColumns(modes, this.units);
    const heads = columns.map(({ name, unit, title }) => make("th", { scope: "col", title }, name, make("small", {}, unit)));
    const head = make("tr", {}, make("th", { scope: "col" }, ""), ...heads);
    const bodies = modes.words.map((words, i) => this.makeMode(modes, i, columns));
    const kind = titles[modes.kind] ?? modes.kind;
    const title = modes.stage === modes.kind ? kind : `${modes.stage}: ${kind}`;
    const table = make("table", {}, make("thead", {}, head), ...bodies);
    return make(
      "section",
      { className: "modes" },
      makeTableKeys(() => table, () => title),
      make("h2", {}, title),
      make("div", { className: "table", tabIndex: 0 }, table),
      ...this.listNotes(modes).map((note) => make("p", { className: "note" }, note)),
    );
  }

  // Two rows: its numbers, then its shape in words and the mass that moves with it.
  makeMode(modes, i, columns) {
    const numbers = make("tr", {}, make("th", { scope: "row", rowSpan: 2 }, this.makeNumber(modes, i)), ...columns.map(({ at }) => make("td", {}, at(i))));
    const mass = modes.mass_shares ? describeMass(modes.mass_shares[i]) : "";
    const words = make("td", { colSpan: columns.length }, modes.words[i], mass ? make("span", {}, `effective mass ${mass}`) : null);
    const body = make("tbody", {}, numbers, make("tr", { className: "words" }, words));
    if (this.canSwing(modes, i)) this.bindMode(body, shapeOf(modes, i));
    return body;
  }

  makeNumber(modes, i) {
    if (!this.canSwing(modes, i)) return String(i + 1);
    const button = make("button", { className: "swing", type: "button", title: "Show this shape" }, String(i + 1));
    this.swinging.bind(button, shapeOf(modes, i));
    return button;
  }

  bindMode(body, shape) {
    body.className = "choosable";
    body.addEventListener("click", (event) => {
      if (!event.target.closest("button")) body.querySelector("button").click();
    });
    this.swinging.listen(() => body.classList.toggle("chosen", this.swinging.isAt(shape)));
  }

  listNotes(modes) {
    const notes = [];
    if (modes.complete === 0) notes.push("Whether these are all up to the last one was not proved.");
    if (modes.swing?.why_none) notes.push(modes.swing.why_none);
    else if (modes.shapes && modes.shapes.count < modes.words.length) notes.push(`The shapes of the first ${modes.shapes.count} are in this page.`);
    return notes;
  }

  recolour() {
    this.plot?.redraw();
  }
}
