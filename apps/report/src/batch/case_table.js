import { find, make } from "../elements.js";
import { formatCount } from "../format.js";
import { saveLatex, saveRows } from "./save_rows.js";

const rowHeight = 27;
const spare = 12; // rows drawn beyond those in sight, above and below
const mostMeasured = 5000; // rows from which widths of columns are found
const { compare: inOrder } = new Intl.Collator("en", { numeric: true });

// The table of the cases. Only the rows in sight are in the document, between two empty ones as high as the rest.
export class CaseTable {
  constructor(cases, attention) {
    this.cases = cases;
    this.attention = attention;
    this.rows = [];
    this.sorted = { field: null, falls: false };
    this.frame = find("table");
    this.fields = listFields(cases);
    this.above = make("tr", { className: "gap" });
    this.below = make("tr", { className: "gap" });
    this.body = make("tbody", {}, this.above, this.below);
    this.frame.append(this.makeTable());
    this.bind();
  }

  makeTable() {
    this.headings = this.fields.map((field) => {
      const button = make("button", { type: "button", title: field.description }, field.name);
      button.addEventListener("click", () => this.sortBy(field));
      return make("th", { scope: "col", className: field.isNumeric ? "number" : "" }, button);
    });
    const widths = this.fields.map((field) => {
      const column = make("col");
      column.style.width = `${field.width}px`;
      return column;
    });
    const table = make(
      "table",
      { className: "cases" },
      make("colgroup", {}, ...widths),
      make("thead", {}, make("tr", {}, ...this.headings)),
      this.body,
    );
    table.style.width = `${this.fields.reduce((sum, field) => sum + field.width, 0)}px`;
    return table;
  }

  bind() {
    this.frame.addEventListener("scroll", () => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.frame);
    const rowOf = (event) => Number(event.target.closest("tr[data-row]")?.dataset.row ?? -1);
    this.body.addEventListener("pointerover", (event) => this.attention.point(rowOf(event)));
    this.body.addEventListener("pointerleave", () => this.attention.point(-1));
    this.body.addEventListener("click", (event) => {
      const row = rowOf(event);
      if (row >= 0 && !event.target.closest("a")) this.attention.choose(row);
    });
    this.attention.listen((what) => {
      if (what === "chosen") this.reveal(this.attention.chosen);
      this.mark();
    });
    find("save-rows").addEventListener("click", () => saveRows(this.cases, this.rows));
    find("save-latex").addEventListener("click", () => saveLatex(this.cases, this.rows, this.fields));
  }

  // Shows these rows, in the order chosen.
  show(rows) {
    this.rows = [...rows];
    this.sort();
    const { count } = this.cases;
    find("shown-count").textContent =
      rows.length === count ? `${formatCount(count)} cases` : `${formatCount(rows.length)} of ${formatCount(count)} cases`;
    this.frame.scrollTop = 0;
    this.draw(true);
  }

  // First rising, then falling.
  sortBy(field) {
    const isSame = this.sorted.field === field;
    this.sorted = { field, falls: isSame && !this.sorted.falls };
    this.headings.forEach((heading, i) => {
      if (this.fields[i] === field) heading.setAttribute("aria-sort", this.sorted.falls ? "descending" : "ascending");
      else heading.removeAttribute("aria-sort");
    });
    this.sort();
    this.frame.scrollTop = 0;
    this.draw(true);
  }

  // Missing values come last either way; equal ones stay in the order of the cases.
  sort() {
    const { field, falls } = this.sorted;
    if (!field) return;
    const sign = falls ? -1 : 1;
    this.rows.sort((a, b) => {
      const [one, other] = [field.rank(a), field.rank(b)];
      const [lacksOne, lacksOther] = [isMissing(one), isMissing(other)];
      if (lacksOne || lacksOther) return lacksOne - lacksOther || a - b;
      if (typeof one === "number") return sign * (one - other) || a - b;
      return sign * inOrder(one, other) || a - b;
    });
  }

  draw(isChanged = false) {
    const first = Math.max(0, Math.floor(this.frame.scrollTop / rowHeight) - spare);
    const last = Math.min(this.rows.length, first + Math.ceil(this.frame.clientHeight / rowHeight) + 2 * spare);
    if (!isChanged && first === this.first && last === this.last) return;
    [this.first, this.last] = [first, last];
    this.above.style.height = `${first * rowHeight}px`;
    this.below.style.height = `${(this.rows.length - last) * rowHeight}px`;
    const drawn = this.rows.slice(first, last).map((row) => this.makeRow(row));
    this.body.replaceChildren(this.above, ...drawn, this.below);
    this.mark();
  }

  makeRow(row) {
    const cells = this.fields.map((field) => {
      const cell = make("td", { className: field.isNumeric ? "number" : "" }, ...field.cell(row));
      if (field.hint) cell.title = field.hint(row);
      return cell;
    });
    return make("tr", { "data-row": String(row), "data-done": String(this.cases.isDone(row)) }, ...cells);
  }

  mark() {
    for (const row of this.body.querySelectorAll("tr[data-row]")) {
      const number = Number(row.dataset.row);
      row.classList.toggle("pointed", number === this.attention.pointed);
      row.classList.toggle("chosen", number === this.attention.chosen);
    }
  }

  // Scrolls as little as it takes.
  reveal(row) {
    const place = this.rows.indexOf(row);
    if (place < 0) return;
    const top = place * rowHeight;
    const room = this.frame.clientHeight - 2 * rowHeight;
    if (top < this.frame.scrollTop) this.frame.scrollTop = Math.max(0, top - rowHeight);
    else if (top > this.frame.scrollTop + room) this.frame.scrollTop = top - room + rowHeight;
    this.draw();
  }
}

const isMissing = (rank) => rank === "" || Number.isNaN(rank);

// Pixels for the widest of what a column shows, within limits.
function widthFor(name, texts, most = 300) {
  let longest = 0;
  for (const text of texts) longest = Math.max(longest, text.length);
  return Math.ceil(Math.min(most, Math.max(34 + 7.4 * name.length, 24 + 8.3 * longest)));
}

function listFields(cases) {
  const stride = Math.max(1, Math.ceil(cases.count / mostMeasured));
  const measured = Array.from({ length: Math.ceil(cases.count / stride) }, (_, i) => stride * i);
  const ofColumn = (column) => ({
    name: column.name,
    description: column.description,
    isNumeric: column.isNumeric,
    width: widthFor(column.name, measured.map((row) => column.show(row)), 220),
    rank: (row) => (column.isNumeric ? column.numbers[row] : column.texts[row]),
    say: (row) => column.show(row),
    cell: (row) => [column.show(row)],
    hint: (row) => column.write(row),
  });
  const ofTexts = (name, description, texts) => ({
    name,
    description,
    isNumeric: false,
    width: widthFor(name, measured.map((row) => texts[row]), 420),
    rank: (row) => texts[row],
    say: (row) => texts[row],
    cell: (row) => [texts[row]],
    hint: (row) => texts[row],
  });
  const number = {
    ...ofColumn(cases.case),
    width: Math.max(72, 30 + 8 * String(cases.info.cases).length),
    cell: (row) => {
      const page = cases.page(row);
      return page ? [make("a", { href: page, title: "the case's own report" }, String(cases.numbers[row]))] : [String(cases.numbers[row])];
    },
    hint: null,
  };
  const status = {
    ...ofTexts("status", "how the case ended", cases.status),
    cell: (row) => [make("span", { className: "status", "data-status": cases.isDone(row) ? "complete" : "failed" }, cases.status[row])],
  };
  status.width += 14;
  const fields = [number, status, ...cases.parameters.map(ofColumn), ...cases.collected.map(ofColumn)];
  if (cases.reasons.some(Boolean)) fields.push(ofTexts("reason", "why the case failed", cases.reasons));
  if (cases.warnings.some(Boolean)) fields.push(ofTexts("warning", "warning about the case", cases.warnings));
  fields.push(...cases.run.map(ofColumn));
  return fields;
}
