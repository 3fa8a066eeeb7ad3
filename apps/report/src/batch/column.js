import { formatNumber } from "../format.js";

const isNumber = (text) => text.trim() !== "" && Number.isFinite(Number(text));

// One column of the table of cases: numbers (NaN if missing), or texts such as schemes, which are categories.
export class Column {
  constructor({ key, name = key, group, description = "", texts = null, numbers = null }) {
    Object.assign(this, { key, name, group, description });
    this.isNumeric = texts === null || texts.every(isNumber);
    this.texts = texts;
    this.numbers = numbers;
    if (texts && this.isNumeric) this.numbers = texts.map(Number);
    if (!this.isNumeric) this.sortIntoCategories();
  }

  // Texts become the numbers 0, 1, 2 … in the order of their first appearance.
  sortIntoCategories() {
    const places = new Map();
    this.numbers = this.texts.map((text) => {
      if (!places.has(text)) places.set(text, places.size);
      return places.get(text);
    });
    this.categories = [...places.keys()];
  }

  // All values, rising, without NaN.
  get values() {
    this.found ??= [...new Set(this.numbers)].filter(Number.isFinite).sort((a, b) => a - b);
    return this.found;
  }

  // As the table and the lists show a value.
  say(value, digits = 6) {
    return this.isNumeric ? formatNumber(value, digits) : (this.categories[value] ?? "");
  }

  // Of a row, as short as possible.
  show(row) {
    return this.isNumeric ? this.say(this.numbers[row]) : this.texts[row];
  }

  // Of a row, with all its digits.
  write(row) {
    if (this.texts) return this.texts[row];
    return Number.isFinite(this.numbers[row]) ? String(this.numbers[row]) : "";
  }
}
