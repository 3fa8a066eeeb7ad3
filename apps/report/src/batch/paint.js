import { ColourScale } from "../scene/colours.js";

const most = 8; // values that get a name each next to the chart

// Colours of the values of one column: a few get a key each, many numbers a scale; null is no column.
export class Paint {
  constructor(column, rows) {
    this.column = column;
    this.hidden = new Set();
    if (!column) return;
    this.values = [...new Set(rows.map((row) => column.numbers[row]))].filter(Number.isFinite).sort((a, b) => a - b);
    this.hasKeys = this.values.length <= most || !column.isNumeric;
    if (!this.hasKeys) this.scale = new ColourScale([this.values[0], this.values.at(-1)], true);
  }

  // Of a row, in these colours of the page.
  colour(row, theme) {
    if (!this.column) return theme.series[0];
    const value = this.column.numbers[row];
    if (!this.hasKeys) return Number.isFinite(value) ? this.scale.css(value) : theme.muted;
    const place = this.values.indexOf(value);
    if (place < 0) return theme.muted;
    // In the order of numbers from blue to orange; texts have no order.
    if (this.values.length <= theme.series.length || !this.column.isNumeric) return theme.series[place % theme.series.length];
    return theme.ranks(place / (this.values.length - 1));
  }

  isHidden(row) {
    return this.column !== null && this.hidden.has(this.column.numbers[row]);
  }
}
