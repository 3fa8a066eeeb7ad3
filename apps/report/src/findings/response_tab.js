import { make } from "../elements.js";
import { Plot } from "../figures/plot.js";
import { inWords } from "../format.js";
import { withSvgKey } from "../saving/svg.js";
import { unitOf } from "../units.js";
import { ResponseFigure } from "./response_figure.js";

const letters = ["x", "y", "z"];
const noAttention = { pointed: -1, chosen: -1, listen() {}, point() {}, choose() {} };

// How a model answers to forces that swing: of each quantity of the histories amplitude and phase over the frequency.
export class ResponseTab {
  constructor(responses, modes, units) {
    this.units = units;
    this.plots = [];
    this.redraws = [];
    this.menu = make("select", { "aria-label": "Frequency" },
      make("option", { value: "omega" }, `ω, ${unitOf("angle/time", units)}`),
      make("option", { value: "frequency" }, `f, cycles per time`));
    this.menu.addEventListener("change", () => this.redraws.forEach((redraw) => redraw()));
    this.naturals = listNaturals(modes);
    const note = this.naturals.length > 0 ? "Dashed lines: natural frequencies, numbered as in the list of modes." : "";
    this.element = make("div", {}, make("div", { className: "along-choices" }, make("span", { className: "over" }, "over"), this.menu), note ? make("p", { className: "note" }, note) : null, ...responses.map((response) => this.makeResponse(response, responses.length > 1)));
  }

  makeResponse(response, isOneOfMany) {
    const groups = new Map();
    for (const curve of response.curves) {
      const key = `${curve.history}: ${inWords(curve.quantity)}`;
      groups.set(key, [...(groups.get(key) ?? []), curve]);
    }
    const sections = [...groups].map(([title, curves]) => this.makeQuantity(title, curves, response));
    if (sections.length === 0) sections.push(make("p", { className: "note" }, "No history moves."));
    return make("section", {}, isOneOfMany ? make("h2", {}, response.stage) : null, ...sections);
  }

  makeQuantity(title, curves, { omegas }) {
    const drawn = curves.map((curve) => ({
      name: letters[curve.component],
      amplitude: Float64Array.from(curve.real, (real, i) => Math.hypot(real, curve.imaginary[i])),
      phase: unwrapDegrees(curve),
      colour: (theme) => theme.series[curve.component],
      isHidden: false,
    }));
    const bodies = [make("div", { className: "figure" }), make("div", { className: "figure low" })];
    const [above, below] = bodies.map((body) => new Plot(body, noAttention, () => []));
    this.plots.push(above, below);
    const unit = unitOf(curves[0].dimension, this.units);
    const show = () => {
      const across = this.acrossOf(omegas);
      const common = { across, isLogAcross: isSpacedByRatio(omegas), ticks: this.naturals.map(({ omega, name }) => ({ value: omega * across.factor, name })) };
      const pick = (part) => drawn.map((curve) => ({ ...curve, values: curve[part] }));
      above.show(new ResponseFigure({ ...common, curves: pick("amplitude"), up: "amplitude", isLogUp: true }));
      below.show(new ResponseFigure({ ...common, curves: pick("phase"), up: "phase, degrees", isLogUp: false }));
    };
    this.redraws.push(show);
    bodies.forEach((body, i) => (body.figure = () => [above, below][i].figure)); // for tests
    const keys = make("div", { className: "keys" }, ...drawn.map((curve, i) => makeKey(curve, curves[i].component, show)));
    show();
    const names = [`amplitude${unit ? `, ${unit}` : ""}`, "phase"];
    const figures = bodies.map((body, i) => withSvgKey(body, [above, below][i], keys, `${title}: ${names[i]}`));
    return make("section", { className: "chart" }, make("h3", {}, title, make("small", {}, unit)), keys, ...figures);
  }

  acrossOf(omegas) {
    const isOmega = this.menu.value === "omega";
    const factor = isOmega ? 1 : 1 / (2 * Math.PI);
    const unit = unitOf(isOmega ? "angle/time" : "1/time", this.units);
    const symbol = isOmega ? "ω" : "f";
    return { name: `${symbol}, ${unit}`, symbol, factor, values: omegas.map((omega) => omega * factor) };
  }

  recolour() {
    this.plots.forEach((plot) => plot.redraw());
  }
}

function makeKey(curve, component, show) {
  const key = make("button", { className: "key", type: "button" }, make("i"), curve.name);
  key.style.setProperty("--series", `var(--series-${component + 1})`);
  key.setAttribute("aria-pressed", "true");
  key.addEventListener("click", () => {
    curve.isHidden = !curve.isHidden;
    key.setAttribute("aria-pressed", String(!curve.isHidden));
    show();
  });
  return key;
}

// Of modes and eigenvalues of the run that swing.
function listNaturals(modes) {
  return modes.flatMap(({ omega }) => (omega ?? []).map((value, i) => ({ omega: value, name: String(i + 1) }))).filter(({ omega }) => omega > 0);
}

// As gxrod-plot has it: then the axis is logarithmic.
function isSpacedByRatio(omegas) {
  const count = omegas.length;
  return count > 2 && omegas[0] > 0 && omegas[count - 1] - omegas[count - 2] > 2 * (omegas[1] - omegas[0]);
}

// Phases without jumps by a whole turn; NaN where there is no answer.
function unwrapDegrees({ real, imaginary }) {
  let before = null;
  return Float64Array.from(real, (re, i) => {
    let phase = (Math.atan2(imaginary[i], re) * 180) / Math.PI;
    if (!Number.isFinite(phase)) return NaN;
    if (before !== null) phase += 360 * Math.round((before - phase) / 360);
    before = phase;
    return phase;
  });
}
