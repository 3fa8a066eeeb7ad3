import { formatTicks, linearTicks, logTicks, ticksAtValues } from "./ticks.js";

// How one column lies along an edge of the chart: numbers, powers of ten of their size, or one place a category. `marks` are values
// at which ticks should be.
export class Axis {
  constructor(column, { isLog = false, values = null, places = null, marks = [] } = {}) {
    Object.assign(this, { column, places, marks });
    this.isLog = isLog && !places && column.isNumeric;
    this.takesSize = this.isLog && values.some((value) => value < 0);
    this.range = places ? [-0.5, places.length - 0.5] : this.findRange(values);
  }

  // Every value of a column gets a place of its own, whatever lies between them.
  static ofPlaces(column) {
    return new Axis(column, { places: column.values });
  }

  findRange(values) {
    let least = Infinity;
    let largest = -Infinity;
    for (const value of values) {
      const at = this.isLog ? Math.abs(value) : value;
      if (!Number.isFinite(at) || (this.isLog && at === 0)) continue;
      least = Math.min(least, at);
      largest = Math.max(largest, at);
    }
    if (least > largest) return this.isLog ? [0.1, 1] : [0, 1];
    if (this.isLog) {
      const margin = Math.max((largest / least) ** 0.05, 1.05);
      return [least / margin, largest * margin];
    }
    // Round-off about a constant stays a flat line.
    const size = Math.max(Math.abs(least), Math.abs(largest));
    const isConstant = largest - least <= 1e-12 * size;
    const margin = isConstant ? 0.05 * size || 0.5 : 0.05 * (largest - least);
    return [least - margin, largest + margin];
  }

  // Where a value goes on the scale; NaN if it has no place there.
  place(value) {
    if (this.places) return this.places.indexOf(value);
    if (!this.isLog) return value;
    return value === 0 ? NaN : Math.abs(value);
  }

  get label() {
    const { name } = this.column;
    if (!this.isLog) return name;
    return this.takesSize ? `|${name}|, logarithmic` : `${name}, logarithmic`;
  }

  // Whether the names of places are slanted, since they would touch one another in a row.
  isSlanted(pixels) {
    return Boolean(this.places) && widthOfNames(this.names) > pixels;
  }

  get names() {
    return this.places.map((value) => this.say(value));
  }

  // Where ticks go in so many pixels; null where there are none.
  ticks(pixels, isUpright) {
    if (this.places) return thinPlaces(this.names.length, pixels);
    if (!this.column.isNumeric) return null;
    const marks = this.marks.map((value) => this.place(value)).sort((a, b) => a - b);
    return ticksAtValues(marks, this.range, pixels, isUpright, this.isLog) ?? (this.isLog ? logTicks : linearTicks)(this.range, pixels, isUpright);
  }

  // Labels of these ticks.
  write(ticks) {
    if (!this.places) return formatTicks(ticks.map((tick) => tick ?? NaN));
    return ticks.map((tick) => (Number.isInteger(tick) && tick in this.places ? this.say(this.places[tick]) : ""));
  }

  say(value) {
    const text = this.column.say(value, 5);
    return text.length > 22 ? `${text.slice(0, 21)}…` : text;
  }
}

// Of all names in a row, in pixels.
const widthOfNames = (names) => names.length * (14 + 6.4 * Math.max(...names.map((name) => name.length), 1));

// All places, or every n-th if even slanted labels do not fit.
function thinPlaces(count, pixels) {
  const stride = Math.max(1, Math.ceil((count * 18) / pixels));
  return Array.from({ length: count }, (_, i) => i).filter((i) => i % stride === 0);
}
