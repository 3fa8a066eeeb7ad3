import { find, make } from "./elements.js";
import { formatNumber, inWords } from "./format.js";

const sectionForce = ["axial", "shear y", "shear z"];
const componentNames = {
  force: sectionForce,
  moment: ["torque", "bending about y", "bending about z"],
  strain: sectionForce,
  curvature: ["twist", "bending about y", "bending about z"],
};
const dimensions = {
  displacement: "length",
  rotation_vector: "angle",
  velocity: "length/time",
  angular_velocity: "angle/time",
  force: "force",
  moment: "force·length",
  strain: "",
  curvature: "angle/length",
};

// The menus that choose what colours the rods, and the legend.
export function bindColouring(data, picture) {
  const quantity = find("quantity");
  const component = find("component");
  quantity.append(make("option", { value: "" }, "plain"));
  for (const name of Object.keys(data.quantities)) quantity.append(make("option", { value: name }, inWords(name)));
  const hasRods = data.offsets.length > 1;
  find("colouring").hidden = !hasRods;
  quantity.value = hasRods && data.quantities.moment ? "moment" : "";

  const listComponents = () => {
    const names = componentNames[quantity.value] ?? ["x", "y", "z"];
    component.replaceChildren(
      make("option", { value: "3" }, "magnitude"),
      ...names.map((name, i) => make("option", { value: String(i) }, name)),
    );
    component.hidden = quantity.value === "";
  };
  const apply = () => showLegend(picture.colourBy(quantity.value, Number(component.value || 3)), quantity.value);
  quantity.addEventListener("change", () => {
    listComponents();
    apply();
  });
  component.addEventListener("change", apply);
  listComponents();
  apply();
}

function showLegend(scale, name) {
  find("legend").hidden = !scale;
  if (!scale) return;
  find("legend-bar").style.background = scale.gradient();
  const middle = 0.5 * (scale.least + scale.largest);
  const ticks = [scale.least, middle, scale.largest].map((value) => make("span", {}, formatNumber(value, 3)));
  find("legend-ticks").replaceChildren(...ticks);
  const dimension = dimensions[name] ? `, ${dimensions[name]}` : "";
  const where = name in componentNames ? "element middles, " : "";
  find("legend-text").textContent = `${where}over all frames${dimension}`;
}
