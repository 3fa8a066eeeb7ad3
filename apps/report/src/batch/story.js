import { makeDeck } from "../deck.js";
import { find, make } from "../elements.js";
import { formatCount, formatNumber } from "../format.js";

export function sayDuration(seconds) {
  if (seconds < 120) return `${formatNumber(seconds, 3)} s`;
  if (seconds < 7200) return `${formatNumber(seconds / 60, 3)} min`;
  return `${formatNumber(seconds / 3600, 3)} h`;
}

function countStatuses({ statuses, counts }) {
  const words = statuses.map((status, i) => [counts[i], status]).filter(([number]) => number > 0);
  return words.map(([number, status]) => `${formatCount(number)} ${status}`).join(", ");
}

// Title, counts and warnings at the top.
export function showHeader(cases) {
  const { info } = cases;
  const title = info.title || info.plan || info.folder;
  document.title = `${title} – gxrod`;
  find("title").textContent = title;
  const failed = info.finished - info.counts[info.statuses.indexOf("done")];
  const waiting = info.cases - info.finished;
  const state = failed > 0 ? "failed" : waiting > 0 ? "running" : "complete";
  find("status").dataset.status = state;
  const words = { failed: `${formatCount(failed)} failed`, running: "not all run", complete: "all done" };
  find("status").textContent = words[state];
  const parts = [
    `${formatCount(info.cases)} case${info.cases === 1 ? "" : "s"}: ${countStatuses(info) || "none done"}`,
    waiting > 0 && `${formatCount(waiting)} not run yet`,
    info.warned > 0 && `${formatCount(info.warned)} with a warning`,
    `${sayDuration(info.seconds)} of computing`,
    info.plan && `plan ${info.plan}`,
    info.combine !== "decks" && info.combine + (cases.isSampled ? `, seed ${info.seed}` : ""),
    `gxrod ${info.gxrod_version}`,
  ];
  find("subtitle").textContent = parts.filter(Boolean).join(" · ");
  find("thinned").hidden = info.left_out.length === 0;
  find("thinned").addEventListener("click", () => document.querySelector("[aria-controls=about]").click());
}

export function showPlan(info) {
  const panel = find("plan");
  if (!info.plan_text) {
    panel.append(make("p", { className: "note" }, "There is no plan: the decks were run as they are."));
    return;
  }
  panel.append(make("p", { className: "note" }, `${info.plan}, as run.`), makeDeck(info.plan_text));
}

// One deck, or a menu of them.
export function showDecks({ decks }) {
  const panel = find("deck");
  if (decks.length === 0) {
    panel.append(make("p", { className: "note" }, "The page holds no text of a deck; About says why."));
    return;
  }
  const place = make("div");
  const show = ({ name, sha256, text }) =>
    place.replaceChildren(make("p", { className: "note" }, `${name}. SHA-256 `, make("code", {}, sha256)), makeDeck(text));
  if (decks.length > 1) {
    const menu = make("select", { id: "which-deck", "aria-label": "Deck" }, ...decks.map(({ name }, i) => make("option", { value: String(i) }, name)));
    menu.addEventListener("change", () => show(decks[Number(menu.value)]));
    panel.append(menu);
  }
  panel.append(place);
  show(decks[0]);
}

export function showAbout(cases) {
  const { info } = cases;
  const kept = info.left_out.length === 0
    ? [make("p", {}, "Nothing is left out: the page has every case that has ended, with all its numbers.")]
    : [make("p", {}, `To stay within ${formatNumber(info.budget_megabytes)} MB, the page leaves out:`),
       make("ul", { id: "left-out" }, ...info.left_out.map((sentence) => make("li", {}, sentence)))];
  const lines = (sentences) => make("ul", {}, ...sentences.map((sentence) => make("li", {}, sentence)));
  const pages = info.pages.cases.length;
  find("about").append(
    make("h2", {}, "What is in this page"),
    ...kept,
    make("p", {}, pages === 0
      ? "No case has a report of its own."
      : `${formatCount(pages)} case${pages === 1 ? " has its" : "s have their"} own report, linked from the number of the case. These pages are in ${decodeURIComponent(info.pages.folder)}, relative to this one.`),
    make("h2", {}, "The chart"),
    lines([
      "It shows the cases that the table shows: a filter applies to both.",
      "Lines join cases whose other parameters are all equal, in the order of the axis; a failed case leaves a gap.",
      "A cross is a case that failed, or has no value in this column. What failed cases had collected is in the table, but not in the chart, the statistics and the histograms.",
      "If there are negative numbers, logarithmic axes show |value|, and say so. With both axes logarithmic, each line is labelled with its slope by least squares: the order of convergence.",
      "In a heat map all values of a parameter are equally spaced.",
      "Click a point or a row to choose a case, click again to deselect it.",
    ]),
    make("h2", {}, "The filter"),
    lines([
      "A case must contain all words: in a value, its status, its reason or its warning.",
      "EI>=100, steps<50, scheme=sdirk-4 compare a column with a value.",
    ]),
    make("details", {}, make("summary", {}, "Libraries and their licences"), make("pre", {}, find("licences").textContent)),
  );
}
