import { Along } from "./charts/along.js";
import { showCharts } from "./charts/chart.js";
import { Clock } from "./clock.js";
import { bindColouring } from "./colouring.js";
import { readData } from "./data.js";
import { showDeck } from "./deck.js";
import { bindDisplay } from "./display.js";
import { find } from "./elements.js";
import { readFindings } from "./findings/found_data.js";
import { addFoundTabs } from "./findings/found_tabs.js";
import { shapeOf } from "./findings/modes_tab.js";
import { describeTime, listParts, listPathStretches, listSeams } from "./findings/stages.js";
import { Swinging } from "./findings/swinging.js";
import { Motion } from "./motion.js";
import { findOpening } from "./opening.js";
import { Names } from "./scene/names.js";
import { Picture } from "./scene/picture.js";
import { RodPicking } from "./scene/rod_picking.js";
import { bindPlayer } from "./player.js";
import { showAbout, showFailure, showHeader, showModel, showOpening } from "./story.js";
import { readStresses } from "./stresses/stress_data.js";
import { addStressTab } from "./stresses/stress_tab.js";
import { bindTabs } from "./tabs.js";
import { addPictureKey } from "./saving/picture_key.js";
import { isWet, listTensions } from "./charts/tensions.js";
import { TouchDown } from "./charts/touch_down.js";
import { bindThemeButton, readTheme } from "./theme.js";
import { readUnits } from "./units.js";

const data = readData();
const { info } = data;
const found = readFindings(info);
const stresses = readStresses(info);
const parts = listParts(found);
// Whether it found something without a step.
const isStill = data.stepTimes.length === 1 && found.modes.length + found.responses.length > 0;
const timeName = info.time_name;
const units = readUnits(info.units);
const clock = new Clock(data.times, info.is_static);

// null where the browser cannot draw in 3D.
function makePicture() {
  try {
    const motion = new Motion(data);
    motion.seams = listSeams(found, data.times);
    const picture = new Picture(find("canvas"), data, motion);
    clock.listen(() => picture.move(clock.position));
    return picture;
  } catch (error) {
    find("no-picture").hidden = false;
    find("no-picture").textContent = `This browser cannot draw in 3D here (${error.message}). The charts still work.`;
    return null;
  }
}

// A click on a rod chooses the place whose section is shown, which the picture marks meanwhile.
function bindPlace(place) {
  let isSeen = false;
  new RodPicking(picture, find("canvas"), (rod, s) => place.choose(rod, s));
  place.listen(() => picture.markPlace(place, isSeen));
  new IntersectionObserver(([entry]) => {
    isSeen = entry.isIntersecting;
    picture.markPlace(place, isSeen);
  }).observe(find("stress"));
}

showHeader(info);
showDeck(info);
showModel(data, units);
const picture = makePicture();
const swinging = picture && [...found.modes, ...found.paths, ...found.sweeps].some(({ shapes }) => shapes) ? new Swinging(picture, clock) : null;
const foundCharts = addFoundTabs(found, { clock, swinging, units, timeName });
const stressTab = stresses && addStressTab(data, stresses, clock, units);
bindTabs(find("tabs"));
bindPlayer(clock, timeName, { swinging, describe: (time) => describeTime(found, parts, time) });
const tensions = Along.isPossible(data) ? listTensions(data) : null;
const ranges = tensions && new Along(data, clock, units, { title: "Ranges of tension and bending", quantities: tensions, first: "effective_tension", hasRod: (rod) => isWet(data, rod), hasMean: !info.is_static });
const along = Along.isPossible(data) ? new Along(data, clock, units) : null;
const touchDown = TouchDown.isPossible(data) ? new TouchDown(data, clock, units) : null;
const charts = [...showCharts(data, clock, { timeName, units, along: [ranges, along, touchDown?.rods.length ? touchDown : null], parts, onPaths: listPathStretches(found), isStill }), ...[ranges, along, touchDown].filter(Boolean), ...foundCharts, ...(stressTab?.charts ?? [])];
showAbout(data, picture);
if (picture) {
  bindColouring(data, picture, units);
  bindDisplay(data, picture, clock);
  new Names(picture, find("canvas"));
  if (stressTab) bindPlace(stressTab.place);
  showFailure(info);
  addPictureKey(picture.stage);
  const legend = document.querySelector(".overlay.top");
  picture.stage.covered = () => (find("colouring").hidden && !swinging?.chosen ? 0 : legend.offsetTop + legend.offsetHeight);
  picture.stage.resize();
  picture.resetView();
}
bindThemeButton(find("theme"), () => {
  picture?.setColours(readTheme());
  charts.forEach((chart) => chart.recolour());
});
picture?.setColours(readTheme());
const open = () => {
  const opening = findOpening(data, found, clock, location.hash);
  showOpening(opening, clock, timeName);
  clock.openAt(opening.frame);
  return opening;
};
const { isAsked } = open();
window.addEventListener("hashchange", open);
// Of a run that moved nothing, its first mode.
const [first] = found.modes.filter(({ shapes }) => shapes);
if (swinging && first && clock.last === 0 && !isAsked) swinging.choose(shapeOf(first, 0), { isPlaying: false });
document.documentElement.dataset.ready = "true";
