import { find, make } from "../elements.js";
import { formatCount, formatNumber, inWords } from "../format.js";
import { makeTableKeys } from "../saving/tables.js";

// "0.12 %", or "3·10⁻⁷" of what is small.
export function formatShare(share) {
  if (!Number.isFinite(share)) return "–";
  return share >= 1e-4 || share === 0 ? `${formatNumber(100 * share, 2)} %` : formatNumber(share, 2);
}

export const nameOf = (series) => `${series.point} ${inWords(series.quantity)}`;

const findRun = (study, name) => study.runs.find((run) => run.run === name);

export function showHeader(study) {
  const title = study.title || study.deck;
  document.title = `${title} – gxrod verify`;
  find("title").textContent = title;
  const [base] = study.runs;
  const state = base?.failure || study.sound === false ? "failed" : study.interrupted ? "interrupted" : study.accurate ? "complete" : "running";
  const goal = formatShare(study.tolerance);
  const words = {
    failed: base && base.failure ? "does not reach its end" : "a property is violated",
    interrupted: "interrupted",
    complete: `right to ${goal}`,
    running: study.series.some((series) => series.error === null) ? "errors are not known" : `not all is right to ${goal}`,
  };
  find("status").dataset.status = state;
  find("status").textContent = words[state];
  find("subtitle").textContent = `gxrod verify ${study.deck} · ${study.analysis} · ${study.runs.length} runs · gxrod ${study.gxrod_version}`;
}

export function showJudgement(study) {
  find("judgement").append(make("ul", {}, ...study.judgement.map((sentence) => make("li", {}, sentence))));
}

function makeTable(title, columns, rows) {
  const head = make("thead", {}, make("tr", {}, ...columns.map((name) => make("th", { scope: "col" }, name))));
  const body = rows.map(([first, ...cells]) =>
    make("tr", {}, make("th", { scope: "row" }, first), ...cells.map((cell) => (cell instanceof Node ? cell : make("td", {}, cell)))),
  );
  const table = make("table", {}, head, make("tbody", {}, ...body));
  return make("div", {}, makeTableKeys(() => table, () => title), make("div", { className: "table", tabIndex: 0 }, table));
}

// What step or mesh adds, and the order in which it falls.
function describePart(series, part) {
  if (!part) return ["–", "–"];
  const isSeen = part.supported || part.differences.length === 1;
  const share = formatShare(part.error / series.scale) + (isSeen ? "" : " ?");
  return [share, part.order === null ? "–" : formatNumber(part.order, 3)];
}

export function showErrors(study) {
  const clock = study.analysis === "static" ? "load factor" : "time";
  const rows = study.series.map((series) => {
    const isKnown = series.relative_error !== null;
    const isRight = isKnown && series.relative_error <= study.tolerance;
    const until = !isKnown ? "?" : series.trusted_until >= study.end_time ? "the end" : formatNumber(series.trusted_until, 4);
    const error = make("td", { className: isRight ? "right" : "wrong" }, isKnown ? formatShare(series.relative_error) : "?");
    return [
      nameOf(series),
      series.still ? "none" : formatNumber(series.scale, 4),
      ...describePart(series, series.steps),
      ...describePart(series, series.mesh),
      error,
      until,
    ];
  });
  const step = study.analysis === "static" ? "load steps" : "step";
  const goal = formatShare(study.tolerance);
  find("errors").append(
    makeTable("errors", ["series", "change", step, "order", "mesh", "order", "error", `right to ${clock}`], rows),
    make(
      "p",
      { className: "note" },
      `Largest errors of the run relative to the largest change (at most 1 rad for rotations; without a change, to what is large in the model), estimated from the finer runs. ` +
        `A question mark means that differences do not fall as errors do. Right: below ${goal}.`,
    ),
  );
}

const quotient = (part, whole) => (whole > 0 ? part / whole : 0);

function describeBalance(study, of, by) {
  const finer = study.runs.find((run) => /^(half the step|1\/16 of the tolerance|twice the load steps)$/.test(run.run));
  const value = (run) => formatShare(quotient(run.books[of], run.books[by]));
  const [base] = study.runs;
  return finer && !finer.failure ? `${value(base)}; with ${finer.run} ${value(finer)}` : value(base);
}

function describeDifference(study, run, quantity) {
  if (run.failure) return run.failure;
  if (run.untried) return `not known: ${run.untried}`;
  const largest = Math.max(0, ...study.series.map((series) => quotient(series[quantity], series.scale)));
  return `differs by ${formatShare(largest)} at most`;
}

export function showProperties(study) {
  const [base] = study.runs;
  if (!base || base.failure) return;
  const rows = [];
  if (base.books.largest_energy > 0) rows.push(["energy out of balance", describeBalance(study, "energy_error", "largest_energy")]);
  if (study.analysis === "dynamic" && base.books.momentum_scale > 0) {
    rows.push(["linear momentum less impulse", describeBalance(study, "linear_imbalance", "momentum_scale")]);
    rows.push(["angular momentum less impulse", describeBalance(study, "angular_imbalance", "angular_scale")]);
  }
  const differences = { "turned in space": "turned_difference", "turned by 1e-6 rad more": "round_off", "elements of the next order": "next_order_difference", "elements simo": "simo_difference" };
  for (const [name, quantity] of Object.entries(differences)) {
    const run = findRun(study, name);
    if (run) rows.push([name, describeDifference(study, run, quantity)]);
  }
  for (const name of ["stopped midway and resumed", "two threads"]) {
    const run = findRun(study, name);
    if (run) rows.push([name, run.untried ? `not tried: ${run.untried}` : run.failure ? `not the same: ${run.failure}` : "the same to the last bit"]);
  }
  find("properties").append(makeTable("properties", ["", ""], rows.map(([name, words]) => [name, make("td", { className: "words" }, words)])));
}

export function showRuns(study) {
  const rows = study.runs.map((run) => [
    run.run,
    formatCount(run.elements),
    formatCount(run.unknowns),
    formatCount(run.steps),
    formatCount(run.newton_iterations),
    formatNumber(run.seconds, 3),
    make("td", { className: "words" }, run.failure || run.set.map((change) => `--set ${change}`).join(" ")),
  ]);
  find("runs").append(makeTable("runs", ["run", "elements", "unknowns", "steps", "Newton", "seconds", ""], rows));
}

export function showAbout() {
  const licences = make("pre", {}, find("licences").textContent);
  find("about").append(
    make("p", { className: "note" }, "Written by gxrod verify. The page loads nothing from elsewhere. It contains:"),
    make("details", {}, make("summary", {}, "licences of libraries"), licences),
  );
}
