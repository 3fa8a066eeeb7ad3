import { formatNumber } from "../format.js";

// How one column lies along an edge of the chart: numbers, powers of ten of their size, or one place a category.
export class Axis {
  constructor(column, { isLog = false, values = null, places = null } = {}) {
    this.column = column;
    this.places = places;
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

  // As many digits as distinguish neighbouring ticks.
  get digits() {
    const [least, largest] = this.range;
    const size = Math.max(Math.abs(least), Math.abs(largest));
    return this.isLog ? 6 : Math.min(15, Math.max(6, 3 + Math.ceil(Math.log10(size / (largest - least)))));
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

  // Where ticks go in so many pixels; undefined leaves it to the chart.
  ticks(pixels, isUpright) {
    if (this.places) return thinPlaces(this.names.length, pixels);
    if (!this.column.isNumeric) return null;
    return this.isLog ? logTicks(this.range, pixels / (isUpright ? 26 : 62)) : undefined;
  }

  write(tick) {
    if (!this.places) return formatNumber(tick, this.digits);
    return Number.isInteger(tick) && tick in this.places ? this.say(this.places[tick]) : "";
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

// 1, 2 and 5 times powers of ten, or powers only, at most so many.
function logTicks([least, largest], most) {
  const [first, last] = [Math.floor(Math.log10(least)), Math.ceil(Math.log10(largest))];
  for (const factors of [[1, 2, 3, 4, 5, 6, 7, 8, 9], [1, 2, 5], [1]]) {
    const ticks = [];
    for (let power = first; power <= last; power++) {
      for (const factor of factors) ticks.push(Number(`${factor}e${power}`));
    }
    const inside = ticks.filter((tick) => tick >= least && tick <= largest);
    if (inside.length <= most || factors.length === 1) {
      return inside.filter((_, i) => i % Math.max(1, Math.ceil(inside.length / most)) === 0);
    }
  }
  return [];
}
