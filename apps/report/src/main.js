import { Along } from "./along.js";
import { showCharts } from "./chart.js";
import { Clock } from "./clock.js";
import { bindColouring } from "./colouring.js";
import { readData } from "./data.js";
import { showDeck } from "./deck.js";
import { bindDisplay } from "./display.js";
import { find } from "./elements.js";
import { findMostMoved, Motion } from "./motion.js";
import { Picture } from "./picture.js";
import { bindPlayer } from "./player.js";
import { showAbout, showFailure, showHeader, showModel } from "./story.js";
import { bindTabs } from "./tabs.js";
import { bindThemeButton, readTheme } from "./theme.js";
import { readUnits } from "./units.js";

const data = readData();
const { info } = data;
const timeName = info.time_name;
const units = readUnits(info.units);
const clock = new Clock(data.times, info.is_static);

// null where the browser cannot draw in 3D.
function makePicture() {
  try {
    const picture = new Picture(find("canvas"), data, new Motion(data));
    clock.listen(() => picture.move(clock.position));
    return picture;
  } catch (error) {
    find("no-picture").hidden = false;
    find("no-picture").textContent = `This browser cannot draw in 3D here (${error.message}). The charts still work.`;
    return null;
  }
}

showHeader(info);
showDeck(info);
showModel(data);
bindTabs(find("tabs"));
bindPlayer(clock, timeName);
const picture = makePicture();
const along = Along.isPossible(data) ? new Along(data, clock, units) : null;
const charts = [...showCharts(data, clock, { timeName, units, along }), ...(along ? [along] : [])];
showAbout(data, picture);
if (picture) {
  bindColouring(data, picture, units);
  bindDisplay(data, picture, clock);
  showFailure(info);
  const legend = document.querySelector(".overlay.top");
  picture.stage.covered = () => (find("colouring").hidden ? 0 : legend.offsetTop + legend.offsetHeight);
  picture.stage.resize();
  picture.resetView();
}
bindThemeButton(find("theme"), () => {
  picture?.setColours(readTheme());
  charts.forEach((chart) => chart.recolour());
});
picture?.setColours(readTheme());
clock.openAt(info.status === "failed" || info.is_static ? clock.last : findMostMoved(data));
document.documentElement.dataset.ready = "true";
