import { make } from "../elements.js";
import { Plot } from "../figures/plot.js";
import { titleOf } from "../quantities.js";
import { EnvelopeFigure } from "./envelope_figure.js";
import { addSvgKey } from "../saving/svg.js";
import { readWorst } from "./stress_data.js";

// A chart of the largest values of all steps along the chosen rod. Clicking a place chooses it.
export class EnvelopeChart {
  constructor(envelopes, words, place, quantity) {
    Object.assign(this, { envelopes, words, place, quantity });
    this.body = make("div", { className: "figure" });
    Object.assign(this.body, { figure: () => this.figure, chart: () => this }); // for tests
    this.title = make("h3", {});
    this.element = make("section", { className: "chart" }, this.title, this.body);
    addSvgKey(this.element, () => this.plot?.plot);
    const attention = { pointed: -1, chosen: -1, listen() {}, point: (row) => (attention.pointed = row) };
    attention.choose = (row) => place.hold(this.points[row]);
    this.attention = attention;
    this.plot = new Plot(this.body, attention, () => []);
    place.listen(() => this.follow());
  }

  choose(quantity) {
    this.quantity = quantity;
    this.show();
  }

  show() {
    const { envelopes, words, place, quantity } = this;
    this.rod = place.rod;
    this.points = (envelopes.ofRod.get(place.rod) ?? []).map((row) => readWorst(envelopes, quantity, row));
    const unit = words.unitOfQuantity(quantity);
    const length = words.unit("length");
    this.title.replaceChildren(`${words.rod(place.rod)}: ${titleOf(quantity)}`, make("small", {}, "largest of all steps"));
    this.figure = new EnvelopeFigure({
      points: this.points,
      across: `s${length ? `, ${length}` : ""}`,
      up: titleOf(quantity) + (unit ? `, ${unit}` : ""),
      limit: quantity === "exposure" ? 1 : null,
      describe: (worst) => words.list(worst),
    });
    this.findChosen();
    this.plot.show(this.figure);
  }

  follow() {
    if (this.place.rod !== this.rod) this.show();
    this.findChosen();
    this.plot.placeRings();
  }

  // The place of the section that is shown, if it is one of the envelope's.
  findChosen() {
    const { held, s } = this.place;
    const distance = (i) => (i < 0 ? Infinity : Math.abs(this.points[i].s - s));
    this.attention.chosen = held ? this.points.findIndex(({ row }) => row === held.row) : this.points.reduce((best, _, i) => (distance(i) < distance(best) ? i : best), -1);
  }

  recolour() {
    this.plot.redraw();
  }
}
