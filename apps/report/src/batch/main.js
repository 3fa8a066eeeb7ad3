import { find } from "../elements.js";
import { bindTabs } from "../tabs.js";
import { bindThemeButton } from "../theme.js";
import { Attention } from "./attention.js";
import { CaseChart } from "./case_chart.js";
import { CaseTable } from "./case_table.js";
import { Cases } from "./cases.js";
import { bindChosenCase } from "./chosen_case.js";
import { Filter } from "./filter.js";
import { showAbout, showDecks, showHeader, showPlan } from "./story.js";

const cases = Cases.read();
const attention = new Attention();

showHeader(cases);
showPlan(cases.info);
showDecks(cases.info);
showAbout(cases);
bindTabs(find("tabs"));
bindChosenCase(cases, attention);
const table = new CaseTable(cases, attention);
const chart = new CaseChart(cases, attention);
const filter = new Filter(cases, () => show());

function show() {
  const rows = filter.rows();
  table.show(rows);
  chart.show(rows);
}

show();
bindThemeButton(find("theme"), () => chart.recolour());
document.documentElement.dataset.ready = "true";
