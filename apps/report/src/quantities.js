import { inWords } from "./format.js";

// What frames have of nodes and of elements: names of components, and dimensions.

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
  effective_tension: "force",
  wall_tension: "force",
  bending_moment: "force·length",
  bending_curvature: "angle/length",
  von_mises: "force/length²",
};
const names = { von_mises: "von Mises stress" };

export const componentsOf = (quantity) => componentNames[quantity] ?? ["x", "y", "z"];
export const dimensionOf = (quantity) => dimensions[quantity] ?? "";
export const titleOf = (quantity) => names[quantity] ?? inWords(quantity);
// Of a history. "force_a" of a joint is a force, whose axes charts name beside it.
export const nameQuantity = (quantity) => titleOf(quantity.replace(/^(force|moment)_a$/, "$1"));
