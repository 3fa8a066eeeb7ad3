import { find, make } from "./elements.js";
import { formatCount, formatNumber, timeSymbol } from "./format.js";
import { listTables } from "./joint_table.js";
import { makeTableKeys } from "./saving/tables.js";

const statusWords = { complete: "complete", failed: "failed", interrupted: "interrupted", running: "not ended" };

// Title, status and warnings at the top.
export function showHeader(info) {
  const title = info.title || info.deck_name || info.file;
  document.title = `${title} – gxrod`;
  find("title").textContent = title;
  find("status").textContent = statusWords[info.status] ?? info.status;
  find("status").dataset.status = info.status;
  const words = [info.file, nameAnalysis(info), info.units && `units ${info.units}`];
  find("subtitle").textContent = words.filter(Boolean).join(" · ");
  find("thinned").hidden = info.left_out.length === 0;
  find("thinned").addEventListener("click", () => document.querySelector("[aria-controls=about]").click());
  find("warnings").append(...info.warnings.map((warning) => make("p", { className: "warning" }, warning)));
}

// Of a run with stages the kinds of all of them.
function nameAnalysis({ stages, paths, modes, responses, is_static: isStatic }) {
  if (stages) return [...new Set(stages.map(({ kind }) => kind))].join(", ");
  if (paths) return "path";
  return modes ? modes[0].kind : responses ? "response" : isStatic ? "static" : "dynamic";
}

const inTable = (cell) => (typeof cell === "number" ? formatNumber(cell, 6) : cell);

function makeTable({ title, columns, rows, note }) {
  const table = make("table", {});
  if (columns.length > 0) {
    table.append(make("thead", {}, make("tr", {}, ...columns.map((name) => make("th", { scope: "col" }, name)))));
  }
  const body = rows.map(([first, ...others]) =>
    make("tr", {}, make("th", { scope: "row", exact: first }, first), ...others.map((cell) => make("td", { exact: cell }, inTable(cell)))),
  );
  table.append(make("tbody", {}, ...body));
  return make(
    "section",
    {},
    makeTableKeys(() => table, () => title),
    make("h2", {}, title),
    make("div", { className: "table", tabIndex: 0 }, table),
    note ? make("p", { className: "note" }, note) : null,
  );
}

export function showModel(data, units) {
  const { info, times } = data;
  const rows = [
    ["nodes", formatCount(info.nodes)],
    ["elements", formatCount(info.elements)],
    ...(info.unknowns === undefined ? [] : [["unknowns", formatCount(info.unknowns)]]),
    ["steps", formatCount(Math.max(info.steps - 1, 0))],
    [`${info.time_name} reached`, formatNumber(times[times.length - 1], 6)],
    ["gxrod", info.gxrod_version],
  ];
  find("model").append(makeTable({ title: "Run", columns: [], rows }), ...listTables(data, units).map(makeTable));
  if (info.why_no_model) {
    const words = `Supports, loads, sections and shapes of bodies are not shown: ${info.why_no_model}`;
    find("model").append(make("p", { className: "note" }, words));
  }
}

// What was left out, how things are drawn, and whose libraries are in the page.
export function showAbout(data, picture) {
  const { info } = data;
  const budget = `${formatNumber(info.budget_megabytes)} MB`;
  const kept = info.left_out.length === 0
    ? [make("p", {}, "Nothing is left out: the page has every frame and every step of the results.")]
    : [make("p", {}, `To stay within ${budget}, or to move smoothly, the page leaves out:`),
       make("ul", { id: "left-out" }, ...info.left_out.map((sentence) => make("li", {}, sentence)))];
  const rounding = "Numbers are rounded to single precision, some seven digits; times are exact. While the motion plays, the picture is interpolated between frames; when it is paused, it shows a computed frame.";
  const drawing = [
    "Rods are ellipses with semi-axes 2√(EIz/EA) along section y and 2√(EIy/EA) along z, within limits: thin rods stay visible and thick ones slender. The dark stripe marks the side of section y.",
    "Bodies are as their looks in the deck say, else the shape with which they touch or the cuboid of the same mass and inertia; the line they leave is the path of the centre of mass or, if that does not move, of the z axis. Axes x, y, z are red, green, blue.",
    "Supports: a block clamps a node, a ball lets it rotate, a cylinder is a hinge about its axis; otherwise each cone holds a displacement and each ring a rotation. Violet supports move as prescribed.",
    "Joints are balls, sleeves on a pin (hinges) or on a rail as long as their way (cylinders, screws; sliders are blocks), balls around a rod (sleeves along it), crosses (universal joints), plates (planes), bars (distances), blocks (welds, and smaller ones that hold some directions). Grey joints are on the ground, violet ones are moved by a motor. Bars go to the nodes. Pointing at one tells its name.",
    "Springs are coils, dampers pistons, bushings boxes.",
    "Thin lines are the shape at t = 0 and, fainter, shapes at other times.",
    "Orange arrows are forces; magenta arrows with two heads are moments. Their length is the current value relative to the largest.",
    ...(picture ? [`A square of the grid is ${formatNumber(picture.gridStep)} wide.`] : []),
  ];
  find("about").append(
    make("h2", {}, "What is in this page"),
    ...kept,
    make("p", {}, rounding),
    make("p", { id: "opening" }),
    make("h2", {}, "How it is drawn"),
    make("ul", {}, ...drawing.map((sentence) => make("li", {}, sentence))),
    make("h2", {}, "Keys"),
    make("p", {}, "Space plays and pauses; the left and right keys move by one frame, Home and End to the first and the last. Click or drag in a chart to go to that time."),
    make("details", {}, make("summary", {}, "Libraries and their licences"), make("pre", {}, find("licences").textContent)),
  );
}

// Where the page opens and why: under About, and at the slider.
export function showOpening({ frame, why, fault }, clock, timeName) {
  const place = `${timeSymbol(timeName)} = ${formatNumber(clock.times[frame], 5)}`;
  find("opening").textContent = `The page opens at ${place}: ${why}. An address that ends in #t= and a number opens it there.`;
  find("time-slider").title = `opened at ${place}: ${why}`;
  find("opening-fault")?.remove();
  if (fault) find("warnings").append(make("p", { className: "warning", id: "opening-fault" }, `${fault}. ${find("opening").textContent}`));
}

// A failed run's reason, over the picture.
export function showFailure(info) {
  if (info.fail_nodes.length === 0) return;
  find("failure").hidden = false;
  find("failure").textContent = "○ where it failed";
}

