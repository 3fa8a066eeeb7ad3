import { find, make } from "../elements.js";
import { ModesTab } from "./modes_tab.js";
import { PathTab } from "./path_tab.js";
import { ResponseTab } from "./response_tab.js";
import { SweepTab } from "./sweep_tab.js";

// Tabs of what the stages of a run have found, before the others. Returns what follows the colours of the page.
export function addFoundTabs(found, { clock, swinging, units, timeName }) {
  const charts = [];
  const tabs = [];
  const add = (id, name, members) => {
    tabs.push([make("button", { role: "tab", type: "button", "aria-controls": id }, name), make("div", { id, role: "tabpanel" }, ...members.map(({ element }) => element))]);
    charts.push(...members);
  };
  if (found.paths.length > 0) {
    const titled = (path, tab) => {
      if (found.paths.length > 1) tab.element.prepend(make("h2", {}, path.stage));
      return tab;
    };
    add("path", "Path", found.paths.map((path) => titled(path, new PathTab(path, { rows: found.rows, clock, swinging, units, timeName }))));
  }
  if (found.modes.length > 0) add("modes", found.modes.every(({ kind }) => kind === "buckling") ? "Buckling" : "Modes", [new ModesTab(found.modes, { swinging, units })]);
  if (found.responses.length > 0) add("response", "Response", [new ResponseTab(found.responses, found.modes, units)]);
  if (found.sweeps.length > 0) add("sweep", "Sweep", [new SweepTab(found.sweeps, { swinging, units })]);
  find("tabs").classList.toggle("many", tabs.length > 1);
  find("tabs").prepend(...tabs.map(([tab]) => tab));
  find("charts").before(...tabs.map(([, panel]) => panel));
  return charts;
}
