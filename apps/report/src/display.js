import { find, make } from "./elements.js";
import { formatNumber } from "./format.js";

const scales = [0, 0.5, 1, 2, 5, 10, 20, 50, 100, 1000, 10000];

// What is drawn, how thick, and how much larger than true the displacements are.
export function bindDisplay(data, picture, clock) {
  const { parts, reference, grid, stage } = picture;
  const toggles = [
    ["show-supports", [parts.supports.group], parts.supports.marks.length > 0],
    ["show-loads", [parts.loads.group], parts.loads.arrows.length > 0],
    ["show-joints", [parts.joints.group], parts.joints.marks.length > 0],
    ["show-springs", [parts.springs.group], parts.springs.marks.length > 0],
    ["show-bodies", [parts.bodies.group, parts.bodies.paths], parts.bodies.bodies.length > 0],
    ["show-centres", [parts.centres.group], parts.centres.places.length > 0],
    ["show-obstacles", [parts.obstacles.group], parts.obstacles.marks.length > 0],
    ["show-contacts", [parts.contacts.group], parts.contacts.count > 0],
    ["show-reference", [reference], data.offsets.length > 1],
    ["show-shapes", [picture.shapes], data.offsets.length > 1 && data.times.length > 1],
    ["show-grid", [grid], true],
  ];
  for (const [id, groups, isThere] of toggles) {
    const box = find(id);
    box.closest("label").hidden = !isThere;
    box.addEventListener("change", () => {
      for (const group of groups) group.visible = box.checked;
      stage.draw();
    });
  }
  bindLegend("centres", parts.centres, parts.centres.places.length > 0);
  bindLegend("contacts", parts.contacts, parts.contacts.count > 0);
  bindScale(picture, clock);
  bindThickness(data, picture);
  const views = { "view-x": [[-1, 0, 0], [0, 0, 1]], "view-y": [[0, 1, 0], [0, 0, 1]], "view-z": [[0, 0, -1], [0, 1, 0]] };
  for (const [id, view] of Object.entries(views)) find(id).addEventListener("click", () => stage.look(...view));
  find("reset-view").addEventListener("click", () => picture.resetView());
  find("fit-view").addEventListener("click", () => {
    stage.direction = null;
    stage.fit();
  });
}

// What colours mean, while the marks are shown.
function bindLegend(name, part, isThere) {
  const legend = find(`${name}-legend`);
  const box = find(`show-${name}`);
  const show = () => (legend.hidden = !isThere || !box.checked);
  if (isThere) legend.append(...part.makeLegend());
  box.addEventListener("change", show);
  show();
}

function bindScale(picture, clock) {
  const menu = find("scale");
  for (const scale of scales) {
    menu.append(make("option", { value: String(scale), selected: scale === 1 }, scale === 1 ? "1× (true)" : `${scale}×`));
  }
  menu.addEventListener("change", () => {
    picture.motion.scale = Number(menu.value);
    find("scale-note").textContent = menu.value === "1" ? "" : `displacements drawn ${menu.value} times as large`;
    picture.updateBox();
    picture.move(clock.position);
  });
}

function bindThickness(data, picture) {
  const slider = find("thickness");
  const { rods } = picture.parts;
  slider.closest("label").hidden = rods.cells === 0;
  const notify = () => {
    const factor = rods.thickness * rods.drawnRadii.factor;
    find("thickness-text").textContent = factor > 0 ? `${formatNumber(factor, 2)}× true` : "not to scale";
  };
  slider.addEventListener("input", () => {
    rods.thickness = 2 ** Number(slider.value);
    rods.move();
    picture.parts.centres.move();
    picture.stage.draw();
    notify();
  });
  notify();
}
