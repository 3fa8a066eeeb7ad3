import { find } from "../elements.js";
import { bindThemeButton } from "../theme.js";
import { showSeries } from "./series_charts.js";
import { showAbout, showErrors, showHeader, showJudgement, showProperties, showRuns } from "./story.js";

const study = JSON.parse(document.getElementById("report").textContent);

showHeader(study);
showJudgement(study);
showErrors(study);
showProperties(study);
showRuns(study);
showAbout();
const charts = showSeries(study);
bindThemeButton(find("theme"), () => charts.forEach((chart) => chart.recolour()));
document.documentElement.dataset.ready = "true";
