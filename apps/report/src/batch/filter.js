import { find, make } from "../elements.js";

const comparisons = {
  "<": (a, b) => a < b,
  "<=": (a, b) => a <= b,
  ">": (a, b) => a > b,
  ">=": (a, b) => a >= b,
  "=": (a, b) => a === b,
};

// "EI>=100" as a test of a row; null if it does not compare a column with a number.
function readComparison(word, cases) {
  const match = /^(.+?)(<=|>=|<|>|=)(.+)$/.exec(word);
  if (!match) return null;
  const [, name, sign, text] = match;
  const column = cases.columns.find(({ key, name: short }) => [key, short].some((n) => n.toLowerCase() === name));
  if (!column) return null;
  if (!column.isNumeric) return sign === "=" ? (row) => column.texts[row].toLowerCase() === text : null;
  const number = Number(text.replace("−", "-"));
  return Number.isFinite(number) ? (row) => comparisons[sign](column.numbers[row], number) : null;
}

// What a text filter sees of each case.
function gather(cases) {
  const said = new Array(cases.count);
  for (let row = 0; row < cases.count; row++) {
    const cells = cases.columns.map((column) => column.write(row));
    said[row] = [...cells, cases.status[row], cases.reasons[row], cases.warnings[row]].join("\n").toLowerCase();
  }
  return said;
}

// The fields that choose among the cases. All words must be met: anywhere in a case, or as a comparison.
export class Filter {
  constructor(cases, onChange) {
    this.cases = cases;
    this.said = null;
    const menu = find("status-filter");
    const counts = new Map();
    for (const status of cases.status) counts.set(status, (counts.get(status) ?? 0) + 1);
    menu.append(make("option", { value: "" }, "every status"));
    for (const status of cases.info.statuses) {
      if (counts.has(status)) menu.append(make("option", { value: status }, `${status} (${counts.get(status)})`));
    }
    const warned = cases.warnings.filter(Boolean).length;
    if (counts.size > 1 && counts.has("done")) menu.append(make("option", { value: "!done" }, "all that failed"));
    if (warned > 0) menu.append(make("option", { value: "!warning" }, `with a warning (${warned})`));
    menu.addEventListener("change", onChange);
    find("text-filter").addEventListener("input", onChange);
  }

  // Rows that pass, in the order of the table as written.
  rows() {
    const status = find("status-filter").value;
    const text = find("text-filter").value.toLowerCase().replace(/\s*(<=|>=|<|>|=)\s*/g, "$1");
    const words = text.split(/\s+/).filter(Boolean);
    if (words.length > 0) this.said ??= gather(this.cases);
    const tests = words.map((word) => readComparison(word, this.cases) ?? ((row) => this.said[row].includes(word)));
    const rows = [];
    for (let row = 0; row < this.cases.count; row++) {
      if (this.hasStatus(row, status) && tests.every((test) => test(row))) rows.push(row);
    }
    return rows;
  }

  hasStatus(row, status) {
    if (status === "") return true;
    if (status === "!done") return !this.cases.isDone(row);
    if (status === "!warning") return this.cases.warnings[row] !== "";
    return this.cases.status[row] === status;
  }
}
