import { formatNumber, timeSymbol } from "../format.js";
import { dimensionOf, titleOf } from "../quantities.js";
import { unitOf } from "../units.js";

// How places and values of stresses are said on a page.
export class Words {
  constructor({ info }, units, sections) {
    Object.assign(this, { info, units, sections });
    this.time = timeSymbol(info.time_name);
  }

  // "" where the deck's label does not name it.
  unit(dimension) {
    const unit = unitOf(dimension, this.units);
    return unit === dimension ? "" : unit;
  }

  unitOfQuantity(name) {
    return this.unit(dimensionOf(name));
  }

  with(value, dimension, digits = 4) {
    return [formatNumber(value, digits), this.unit(dimension)].filter(Boolean).join(" ");
  }

  value(name, value, digits = 4) {
    return this.with(value, dimensionOf(name), digits);
  }

  point(y, z) {
    return `(${formatNumber(y, 3)}, ${formatNumber(z, 3)})`;
  }

  rod(rod) {
    return this.info.rods[rod] ?? `rod ${rod + 1}`;
  }

  layer(section, layer) {
    return this.sections[section]?.layers[layer] ?? "";
  }

  // [name, text] of what is known of a worst place.
  list({ name, section, s, time, value, y, z, layer }) {
    return [
      [titleOf(name), this.value(name, value)],
      ["s =", this.with(s, "length")],
      [`${this.time} =`, formatNumber(time, 4)],
      ["(y, z) =", this.point(y, z)],
      ["in", [this.sections[section]?.name, this.layer(section, layer)].filter(Boolean).join(", ")],
    ].filter(([, text]) => text !== "");
  }
}
