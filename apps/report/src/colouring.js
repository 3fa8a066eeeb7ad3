import { find, make } from "./elements.js";
import { formatNumber } from "./format.js";
import { componentsOf, dimensionOf, titleOf } from "./quantities.js";
import { unitOf } from "./units.js";

// The menus that choose what colours the rods, and the legend.
export function bindColouring(data, picture, units) {
  const quantity = find("quantity");
  const component = find("component");
  quantity.append(make("option", { value: "" }, "plain"));
  for (const name of Object.keys(data.quantities)) quantity.append(make("option", { value: name }, titleOf(name)));
  const hasRods = picture.hasColours;
  find("colouring").hidden = !hasRods;
  quantity.value = hasRods && data.quantities.moment ? "moment" : "";

  const listComponents = () => {
    const names = componentsOf(quantity.value);
    component.replaceChildren(
      make("option", { value: "3" }, "magnitude"),
      ...names.map((name, i) => make("option", { value: String(i) }, name)),
    );
    component.hidden = quantity.value === "" || (data.quantities[quantity.value].isScalar ?? false);
  };
  const apply = () => showLegend(picture.colourBy(quantity.value, Number(component.value || 3)), data.quantities[quantity.value]?.of === "cell", unitOf(dimensionOf(quantity.value), units));
  quantity.addEventListener("change", () => {
    listComponents();
    apply();
  });
  component.addEventListener("change", apply);
  listComponents();
  apply();
}

function showLegend(scale, isOfCells, unit) {
  find("legend").hidden = !scale;
  if (!scale) return;
  find("legend-bar").style.background = scale.gradient();
  const middle = 0.5 * (scale.least + scale.largest);
  const ticks = [scale.least, middle, scale.largest].map((value) => make("span", {}, formatNumber(value, 3)));
  find("legend-ticks").replaceChildren(...ticks);
  find("legend-text").textContent = [isOfCells ? "element middles" : "", "over all frames", unit].filter(Boolean).join(", ");
}
