import { make } from "../elements.js";
import { Plot } from "../figures/plot.js";
import { formatNumber } from "../format.js";
import { withSvgKey } from "../saving/svg.js";
import { makeTableKeys } from "../saving/tables.js";
import { unitOf } from "../units.js";
import { findCrossings } from "./crossings.js";
import { SweepFigure } from "./sweep_figure.js";

const mostCrossings = 40;
const roundOff = 1e-6; // of a growth, compared with |λ|

// Eigenvalues over a number of the deck: frequencies, with multiples of the speed if the model turns, and growth if any motion
// grows or decays.
export class SweepTab {
  constructor(sweeps, { swinging, units }) {
    Object.assign(this, { swinging, units });
    this.plots = [];
    this.element = make("div", {}, ...sweeps.map((sweep) => this.makeSweep(sweep)));
  }

  // What a sweep is drawn over: revolutions a minute and Hz if it turns and time is in seconds, else the number and ω.
  scalesOf(sweep) {
    const steps = sweep.speeds.slice(1).map((speed, i) => speed - sweep.speeds[i]);
    const turns = steps.length > 0 && (steps.every((step) => step > 0) || steps.every((step) => step < 0));
    const hasSeconds = this.units?.time?.length === 1 && this.units.time[0][0] === "s";
    if (!turns || !hasSeconds) return { up: 1, upName: `ω, ${unitOf("angle/time", this.units)}`, across: sweep.values, acrossName: sweep.key, place: (value) => value, turns };
    const across = sweep.speeds.map((speed) => (speed * 30) / Math.PI);
    const order = sweep.values.map((value, i) => [value, across[i]]).sort((a, b) => a[0] - b[0]);
    const place = (value) => {
      const next = Math.max(1, order.findIndex(([at]) => at >= value));
      const [[a, left], [b, right]] = [order[next - 1], order[next]];
      return left + ((right - left) * (value - a)) / (b - a);
    };
    return { up: 1 / (2 * Math.PI), upName: "frequency, Hz", across, acrossName: "speed, rpm", place, turns };
  }

  makeSweep(sweep) {
    const scales = this.scalesOf(sweep);
    const growth = sweep.growth.map((list, mode) =>
      list.map((value, i) => (value === null ? NaN : Math.abs(value) > roundOff * Math.hypot(value, sweep.omega[mode][i]) ? value : 0)),
    );
    const colourOf = (mode) => (theme) => theme.series[mode % theme.series.length];
    const drawn = sweep.words.map((words, mode) => ({ name: String(mode + 1), words: describeNames(sweep, mode, words), colour: colourOf(mode), isHidden: false }));
    const parts = [{ up: scales.upName, lists: sweep.omega.map((list) => list.map((value) => (value ?? NaN) * scales.up)), isGrowth: false }];
    if (growth.some((list) => list.some((value) => value !== 0 && Number.isFinite(value)))) parts.push({ up: `growth, ${unitOf("1/time", this.units)}`, lists: growth, isGrowth: true });
    const bodies = parts.map(() => make("div", { className: "figure" }));
    const attention = this.makeAttention(sweep, scales);
    const plots = bodies.map((body) => new Plot(body, attention, () => []));
    const crossings = scales.turns ? findCrossings(scales.across, sweep.speeds.map((speed) => speed * scales.up), parts[0].lists) : [];
    this.plots.push(...plots);
    const across = { name: scales.acrossName, symbol: scales.acrossName, values: scales.across };
    const show = () =>
      parts.forEach(({ up, lists, isGrowth }, i) =>
        plots[i].show(
          new SweepFigure({
            across,
            up,
            curves: drawn.map((curve, mode) => ({ ...curve, values: lists[mode] })),
            crossings: isGrowth ? [] : crossings.map((one) => ({ ...one, curve: one.mode })),
            startsAtZero: scales.turns && !isGrowth,
            rowOf: (value, mode) => (this.canSwing(sweep, value, mode) ? value * sweep.words.length + mode : -1),
            wordsOf: (value, mode) => `${mode + 1} ${sweep.words_at_values[mode]?.[value] || sweep.words[mode]}`,
            speeds: isGrowth ? [] : sweep.speeds.map((speed) => speed * scales.up),
            onsets: sweep.onsets.map(({ value, omega }) => ({ value: scales.place(value), name: "", height: isGrowth ? null : omega * scales.up })),
          }),
        ),
      );
    bodies.forEach((body, i) => (body.figure = () => plots[i].figure)); // for tests
    const keys = make("div", { className: "keys" }, ...drawn.map((curve, mode) => makeKey(curve, mode, show)));
    const sentences = sweep.onsets.map(({ kind, begins, value, omega }) => {
      const frequency = omega > 0 ? `, ω = ${formatNumber(omega, 6)}` : "";
      return make("p", { className: "note" }, make("b", {}, `${kind} ${begins ? "begins" : "ends"}`), ` at ${sweep.key} = ${formatNumber(value, 8)}${frequency}`);
    });
    show();
    const title = `${sweep.stage}: modes over ${sweep.key}`;
    const figures = bodies.map((body, i) => withSvgKey(body, plots[i], keys, `${title}, ${parts[i].up}`));
    const hint = sweep.shapes ? [make("p", { className: "note" }, "Press a curve to see the shape of that mode there.")] : [];
    return make("section", { className: "chart" }, make("h3", {}, title), keys, ...sentences, ...hint, ...figures, ...this.makeCrossings(crossings, drawn, scales, title));
  }

  canSwing({ shapes, words }, value, mode) {
    return this.swinging !== null && !!shapes && value * words.length + mode < shapes.count;
  }

  // What presses on curves choose: a row is the number of a shape.
  makeAttention(sweep, { across, acrossName }) {
    const attention = { pointed: -1, chosen: -1, listeners: [] };
    attention.listen = (listener) => attention.listeners.push(listener);
    attention.point = (row) => {
      attention.pointed = row;
      attention.listeners.forEach((listener) => listener());
    };
    attention.choose = (row) => {
      const count = sweep.words.length;
      const [value, mode] = [Math.floor(row / count), row % count];
      const words = sweep.words_at_values[mode]?.[value] || sweep.words[mode];
      this.swinging.choose({ shapes: sweep.shapes, index: row, title: `${sweep.stage} ${mode + 1}`, text: `${acrossName} ${formatNumber(across[value], 5)}`, words });
    };
    this.swinging?.listen(() => {
      const { chosen } = this.swinging;
      attention.chosen = chosen !== null && chosen.shapes === sweep.shapes && sweep.shapes ? chosen.index : -1;
      attention.listeners.forEach((listener) => listener());
    });
    return attention;
  }

  makeCrossings(crossings, drawn, { upName, acrossName }, title) {
    if (crossings.length === 0) return [];
    const heads = [acrossName, "line", upName, `within 10 %, ${acrossName.split(", ").at(-1)}`, "mode"];
    const rows = crossings.slice(0, mostCrossings).map(({ mode, multiple, place, frequency, from, until }) => {
      const cells = [formatNumber(place, 4), `${multiple}P`, formatNumber(frequency, 4), `${formatNumber(from, 4)} to ${formatNumber(until, 4)}`, `${mode + 1} ${drawn[mode].words}`];
      return make("tr", {}, ...cells.map((cell) => make("td", {}, cell)));
    });
    const table = make("table", {}, make("thead", {}, make("tr", {}, ...heads.map((head) => make("th", { scope: "col" }, head)))), make("tbody", {}, ...rows));
    const left = crossings.length - rows.length;
    return [
      make(
        "section",
        { className: "crossings" },
        makeTableKeys(() => table, () => `${title}, multiples of the speed`),
        make("h4", {}, "Multiples of the speed that meet modes"),
        make("div", { className: "table", tabIndex: 0 }, table),
        ...(left > 0 ? [make("p", { className: "note" }, `And ${left} more at higher speeds.`)] : []),
      ),
    ];
  }

  recolour() {
    this.plots.forEach((plot) => plot.redraw());
  }
}

// A mode in words, at the first value and, if others fit it there, at the last one.
function describeNames(sweep, mode, words) {
  const last = (sweep.words_at_values[mode] ?? []).findLast((text) => text !== "");
  return !last || last === words ? words : `${words}, in the end ${last}`;
}

function makeKey(curve, mode, show) {
  const key = make("button", { className: "key", type: "button" }, make("i"), `${curve.name} ${curve.words}`);
  key.style.setProperty("--series", `var(--series-${(mode % 4) + 1})`);
  key.setAttribute("aria-pressed", "true");
  key.addEventListener("click", () => {
    curve.isHidden = !curve.isHidden;
    key.setAttribute("aria-pressed", String(!curve.isHidden));
    show();
  });
  return key;
}
