// Which case the pointer is at and which was chosen, in the chart or in the table: -1 for none.
export class Attention {
  constructor() {
    this.pointed = -1;
    this.chosen = -1;
    this.listeners = [];
  }

  listen(listener) {
    this.listeners.push(listener);
  }

  point(row) {
    if (row === this.pointed) return;
    this.pointed = row;
    this.notify("pointed");
  }

  choose(row) {
    this.chosen = row === this.chosen ? -1 : row;
    this.notify("chosen");
  }

  notify(what) {
    for (const listener of this.listeners) listener(what);
  }
}
