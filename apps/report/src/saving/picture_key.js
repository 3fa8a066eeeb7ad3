import { find, make } from "../elements.js";
import { fileStem, pageStem, saveFile } from "./files.js";

const margin = 12;
const barWidth = 240;

// A button next to those of the view that saves the picture as PNG, with the legend of its colours on the paper of the page.
export function addPictureKey(stage) {
  const key = make("button", { id: "save-picture", type: "button", title: "Save the picture as PNG" }, "PNG");
  key.addEventListener("click", () => {
    const canvas = paint(stage);
    const time = find("time-text").textContent.replace(/ = /, "=");
    canvas.toBlob((blob) => saveFile(`${fileStem(pageStem(), time)}.png`, blob), "image/png");
  });
  find("reset-view").parentElement.append(key);
}

// What the canvas of the scene shows is gone once the screen is drawn, so it is drawn and copied at once.
function paint({ renderer, scene, camera, gizmo }) {
  const source = renderer.domElement;
  const canvas = make("canvas", { width: source.width, height: source.height });
  const context = canvas.getContext("2d");
  context.fillStyle = getComputedStyle(document.body).backgroundColor;
  context.fillRect(0, 0, canvas.width, canvas.height);
  renderer.setViewport(0, 0, source.clientWidth, source.clientHeight);
  renderer.render(scene, camera);
  gizmo.draw(renderer, camera);
  context.drawImage(source, 0, 0);
  const ratio = source.width / source.clientWidth;
  context.scale(ratio, ratio);
  paintLegend(context);
  return canvas;
}

function paintLegend(context) {
  const stops = find("legend-bar").style.background.match(/rgb\([^)]*\)/g);
  if (find("colouring").hidden || find("legend").hidden || !stops) return;
  const style = getComputedStyle(document.body);
  const chosen = ["quantity", "component"].map(find).filter(({ hidden }) => !hidden).map((menu) => menu.selectedOptions[0]?.textContent);
  const bar = context.createLinearGradient(margin, 0, margin + barWidth, 0);
  stops.forEach((stop, i) => bar.addColorStop(i / (stops.length - 1), stop));
  context.font = `12px ${style.fontFamily}`;
  context.fillStyle = style.color;
  context.textBaseline = "top";
  context.fillText(chosen.filter(Boolean).join(", "), margin, margin);
  context.fillStyle = bar;
  context.fillRect(margin, margin + 18, barWidth, 9);
  context.fillStyle = style.color;
  [...find("legend-ticks").children].forEach((tick, i, all) => {
    context.textAlign = ["left", "center", "right"][Math.round((2 * i) / Math.max(all.length - 1, 1))];
    context.fillText(tick.textContent, margin + (barWidth * i) / Math.max(all.length - 1, 1), margin + 31);
  });
  context.textAlign = "left";
  context.fillText(find("legend-text").textContent, margin, margin + 47);
}
