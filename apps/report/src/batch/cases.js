import { Column } from "./column.js";

const orNaN = (numbers) => numbers.map((number) => number ?? NaN);

// "parameters.EI" as a reader calls it, as long as no other would have that name.
function shorten(keys) {
  const short = keys.map((key) => key.replace(/^parameters\./, ""));
  return short.map((name, i) => (short.indexOf(name) === i && short.lastIndexOf(name) === i ? name : keys[i]));
}

// The batch and its cases, from the JSON of the page. A row is a place in the table as written; its case has a number.
export class Cases {
  constructor(info) {
    const { rows, texts } = info;
    this.info = info;
    this.count = rows.case.length;
    this.numbers = rows.case;
    this.status = rows.status.map((which) => info.statuses[which]);
    this.reasons = rows.reason.map((which) => texts[which]);
    this.warnings = rows.warning.map((which) => texts[which]);
    const names = shorten(info.parameters);
    this.parameters = info.parameters.map(
      (key, i) => new Column({ key, name: names[i], group: "parameter", texts: rows.parameters[i], description: key }),
    );
    this.collected = info.columns.map(
      ({ name, description }, i) =>
        new Column({ key: name, description, group: "collected", numbers: orNaN(rows.collected[i]) }),
    );
    const ofRun = (key, name, description) => new Column({ key, name, description, group: "run", numbers: orNaN(rows[key]) });
    this.run = [
      ofRun("time", "t reached", "time or load factor that the case reached"),
      ofRun("steps", "steps", "accepted steps"),
      ofRun("newton_iterations", "iterations", "Newton iterations"),
      ofRun("rejected_steps", "rejected", "steps that were rejected and tried again"),
      ofRun("seconds", "seconds", "wall time"),
    ];
    this.case = new Column({ key: "case", group: "run", numbers: rows.case, description: "number of the case" });
    this.columns = [this.case, ...this.parameters, ...this.collected, ...this.run];
    this.withPage = new Set(info.pages.cases);
  }

  static read() {
    return new Cases(JSON.parse(document.getElementById("report").textContent));
  }

  isDone(row) {
    return this.status[row] === "done";
  }

  // Address of the case's own page, null if it has none.
  page(row) {
    const { folder, width } = this.info.pages;
    const number = this.numbers[row];
    return this.withPage.has(number) ? `${folder}${String(number).padStart(width, "0")}.html` : null;
  }

  find(key) {
    return this.columns.find((column) => column.key === key);
  }

  // Parameters that differ between cases.
  get varied() {
    return this.parameters.filter((column) => column.values.length > 1);
  }

  get isSampled() {
    return this.info.combine === "latin-hypercube";
  }
}
