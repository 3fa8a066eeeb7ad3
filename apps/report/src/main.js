import { showCharts } from "./chart.js";
import { Clock } from "./clock.js";
import { bindColouring } from "./colouring.js";
import { readData } from "./data.js";
import { showDeck } from "./deck.js";
import { bindDisplay } from "./display.js";
import { find } from "./elements.js";
import { Motion } from "./motion.js";
import { Picture } from "./picture.js";
import { bindPlayer } from "./player.js";
import { showAbout, showFailure, showHeader, showModel } from "./story.js";
import { bindTabs } from "./tabs.js";
import { bindThemeButton, readTheme } from "./theme.js";

const data = readData();
const { info } = data;
const timeName = info.is_static ? "load factor" : "time";
const clock = new Clock(data.times, info.is_static);

// null where the browser cannot draw in 3D.
function makePicture() {
  try {
    const picture = new Picture(find("canvas"), data, new Motion(data));
    clock.listen(() => picture.move(clock.position));
    return picture;
  } catch (error) {
    find("no-picture").hidden = false;
    find("no-picture").textContent = `This browser shows no 3D picture here (${error.message}). The charts work all the same.`;
    return null;
  }
}

showHeader(info);
showDeck(info);
showModel(data);
bindTabs(find("tabs"));
bindPlayer(clock, timeName);
const picture = makePicture();
const charts = showCharts(data, clock, timeName);
showAbout(data, picture);
if (picture) {
  bindColouring(data, picture);
  bindDisplay(data, picture, clock);
  showFailure(info);
  picture.stage.resize();
  picture.resetView();
}
bindThemeButton(find("theme"), () => {
  picture?.setColours(readTheme());
  charts.forEach((chart) => chart.recolour());
});
picture?.setColours(readTheme());
clock.goToFrame(info.status === "failed" || info.is_static ? clock.last : 0);
document.documentElement.dataset.ready = "true";
