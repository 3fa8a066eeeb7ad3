import { make } from "../elements.js";
import { formatNumber } from "../format.js";
import { titleOf } from "../quantities.js";
import { makeTableKeys } from "../saving/tables.js";
import { listWorst } from "./stress_data.js";

const fewRows = 12;

// A table of the largest values of all steps, a row for each rod, the largest first. A row chooses its place.
export class Utilisation {
  constructor(envelopes, words, place, quantity) {
    Object.assign(this, { envelopes, words, place, quantity });
    this.body = make("div", { className: "table", tabIndex: 0 });
    this.note = make("p", { className: "note" });
    this.more = make("button", { type: "button", className: "more" });
    this.more.addEventListener("click", () => {
      this.showsAll = !this.showsAll;
      this.show();
    });
    const keys = makeTableKeys(() => this.body.querySelector("table"), () => "stresses");
    this.element = make("section", { className: "utilisation" }, keys, this.body, this.more, this.note);
    place.listen(() => this.mark());
  }

  choose(quantity) {
    this.quantity = quantity;
    this.show();
  }

  // The chosen one first.
  listNames() {
    return [this.quantity, ...this.envelopes.names.filter((name) => name !== this.quantity)];
  }

  // Of a rod the largest value of each quantity; the first one is where the row leads to.
  list() {
    const [chosen, ...others] = this.listNames().map((name) => listWorst(this.envelopes, name));
    const byRod = others.map((list) => new Map(list.map((worst) => [worst.rod, worst])));
    return chosen.map((worst) => ({ worst, others: byRod.map((list) => list.get(worst.rod)) }));
  }

  show() {
    const rows = this.list();
    const shown = this.showsAll ? rows : rows.slice(0, fewRows);
    this.more.hidden = rows.length <= fewRows;
    this.more.textContent = this.showsAll ? `The first ${fewRows}` : `All ${rows.length} rods`;
    this.rows = shown.map((row) => this.makeRow(row));
    this.body.replaceChildren(make("table", {}, make("thead", {}, this.makeHead()), make("tbody", {}, ...this.rows.map(({ element }) => element))));
    const over = this.envelopes.names.includes("exposure") ? listWorst(this.envelopes, "exposure").filter(({ value }) => value > 1).length : 0;
    const verb = over === 1 ? "rod exceeds" : "rods exceed";
    this.note.textContent = over > 0 ? `${over} ${verb} an exposure of 1: the material yields or fails there.` : "";
    this.note.classList.toggle("bad", over > 0);
    this.mark();
  }

  makeHead() {
    const { words } = this;
    const heads = [
      ["rod", ""],
      ...this.listNames().map((name) => [titleOf(name), words.unitOfQuantity(name)]),
      ["at s", words.unit("length")],
      [words.time, words.info.time_name === "time" ? words.unit("time") : ""],
      ["(y, z)", words.unit("length")],
    ];
    return make("tr", {}, ...heads.map(([name, unit]) => make("th", { scope: "col" }, name, unit ? make("small", {}, ` ${unit}`) : null)));
  }

  makeRow({ worst, others }) {
    // A rod without strength has no exposure.
    const number = (one) => make("td", { className: one?.name === "exposure" && one.value > 1 ? "bad" : "" }, formatNumber(one?.value, 4));
    const button = make("button", { type: "button", className: "go" }, this.words.rod(worst.rod));
    const element = make(
      "tr",
      { className: "choosable" },
      make("th", { scope: "row" }, button),
      ...[worst, ...others].map(number),
      make("td", {}, formatNumber(worst.s, 4)),
      make("td", {}, formatNumber(worst.time, 4)),
      make("td", {}, this.words.point(worst.y, worst.z)),
    );
    element.addEventListener("click", () => this.place.hold(worst));
    return { worst, element };
  }

  mark() {
    for (const { worst, element } of this.rows ?? []) element.classList.toggle("chosen", worst.rod === this.place.rod);
  }
}
