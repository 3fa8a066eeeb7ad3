import { find, make } from "../elements.js";
import { titleOf } from "../quantities.js";
import { EnvelopeChart } from "./envelope_chart.js";
import { Place } from "./place.js";
import { SectionPanel } from "./section_panel.js";
import { hasStrength, listWorst } from "./stress_data.js";
import { Utilisation } from "./utilisation.js";
import { Words } from "./words.js";

const criteria = { "von-mises": "von Mises", "tsai-wu": "Tsai–Wu", hashin: "Hashin", "max-stress": "the largest stress" };

// A tab of stresses after the charts: what is used of rods, envelopes along them, and a section. Returns what follows the colours
// of the page, and the chosen place.
export function addStressTab(data, stresses, clock, units) {
  const words = new Words(data, units, stresses.sections);
  const place = new Place(data, clock, listRods(data, stresses));
  const members = [];
  const panel = make("div", { id: "stress", role: "tabpanel" });
  if (stresses.envelopes?.ofRod.size > 0) panel.append(...makeEnvelopes(stresses.envelopes, words, place, members));
  if (place.rods.length > 0 && stresses.sections.length > 0) members.push(new SectionPanel(data, stresses, words, place));
  panel.append(...members.filter((member) => member instanceof SectionPanel).map(({ element }) => element));
  find("tabs").querySelector("[aria-controls=charts]").after(make("button", { role: "tab", type: "button", "aria-controls": "stress" }, "Stress"));
  find("charts").after(panel);
  place.notify();
  return { charts: members.filter((member) => member.recolour), place };
}

// Rods that have stresses, in the order of the deck.
function listRods({ cellRods }, { cellSections, envelopes }) {
  const rods = new Set(envelopes?.ofRod.keys() ?? []);
  cellSections.forEach((section, cell) => section >= 0 && rods.add(cellRods[cell]));
  return [...rods].filter((rod) => rod >= 0).sort((a, b) => a - b);
}

// Of exposure first, if materials have strengths.
function makeEnvelopes(envelopes, words, place, members) {
  const names = envelopes.names.filter((name) => name !== "exposure" || hasStrength(envelopes));
  const first = names.includes("exposure") ? "exposure" : names[0];
  const [worst] = listWorst(envelopes, first);
  const shown = { ...envelopes, names };
  if (worst) Object.assign(place, { rod: worst.rod, s: worst.s });
  const menu = make("select", { "aria-label": "Quantity" }, ...names.map((name) => make("option", { value: name }, titleOf(name))));
  menu.value = first;
  const parts = [new Utilisation(shown, words, place, first), new EnvelopeChart(shown, words, place, first)];
  menu.addEventListener("change", () => parts.forEach((part) => part.choose(menu.value)));
  parts.forEach((part) => part.show());
  members.push(...parts);
  const criterion = names.includes("exposure") ? make("span", { className: "over" }, `by ${criteria[envelopes.criterion] ?? envelopes.criterion}`) : null;
  return [make("h2", {}, "Largest of all steps"), make("div", { className: "along-choices" }, menu, criterion), ...parts.map(({ element }) => element)];
}
