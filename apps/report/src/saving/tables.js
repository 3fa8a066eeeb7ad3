import { fileStem, makeSaveKeys, pageStem, saveText } from "./files.js";
import { escapeLatex, isNumber } from "./latex.js";

// A cell of a CSV as RFC 4180 has it.
const quote = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

// Rows of texts as CSV.
export const writeCsv = (rows) => rows.map((cells) => `${cells.map(quote).join(",")}\n`).join("");

// Rows of texts as a table of LaTeX with the lines of booktabs; the first `heads` rows are headings. Columns of numbers stand to the right.
export function writeLatex(rows, heads, title) {
  const body = rows.slice(heads);
  const count = Math.max(0, ...rows.map((cells) => cells.length));
  const letters = Array.from({ length: count }, (_, i) => (i > 0 && body.every((cells) => !cells[i] || isNumber(cells[i])) ? "r" : "l"));
  const line = (cells) => `${Array.from({ length: count }, (_, i) => escapeLatex(cells[i] ?? "")).join(" & ")} \\\\`;
  return [
    `% ${title.replaceAll(/\s+/g, " ")}`,
    "% \\usepackage{booktabs}",
    `\\begin{tabular}{${letters.join("")}}`,
    "\\toprule",
    ...(heads > 0 ? [...rows.slice(0, heads).map(line), "\\midrule"] : []),
    ...body.map(line),
    "\\bottomrule",
    "\\end{tabular}",
    "",
  ].join("\n");
}

// "−3.2·10⁻⁵", as the page writes numbers, as a program reads them.
export function toPlainNumber(text) {
  if (!isNumber(text)) return text;
  const power = text.replace("−", "-").replaceAll(/[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (sign) => "-0123456789"["⁻⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(sign)]);
  return power.replace("·10", "e").replaceAll("\u202f", "");
}

// What a table of the page says: rows of texts, with the numbers that stand behind them where a cell has one. Bodies with two rows for one
// thing become one row.
function readTable(table, isExact) {
  const say = (cell) => {
    if (isExact && typeof cell.exact === "number" && Number.isFinite(cell.exact)) return String(cell.exact);
    const text = [...cell.childNodes].map((node) => node.textContent.trim()).filter(Boolean).join(" ");
    return isExact ? toPlainNumber(text) : text;
  };
  const heads = table.tHead ? [...table.tHead.rows].map((row) => [...row.cells].map(say)) : [];
  const rows = [...table.tBodies].flatMap((body) => {
    const list = [...body.rows].map((row) => [...row.cells].map(say));
    return body.rows[0]?.cells[0]?.rowSpan > 1 ? [list.flat()] : list;
  });
  const wide = Math.max(...rows.map((row) => row.length));
  for (const head of heads) while (head.length < wide) head.push("");
  return { heads: heads.length, rows: [...heads, ...rows] };
}

// Buttons that save a table as CSV and LaTeX; `find` gives the table of the page.
export function makeTableKeys(find, titleOf) {
  const save = (ending, type, write) => {
    const title = titleOf();
    saveText(`${fileStem(pageStem(), title)}.${ending}`, type, write(title));
  };
  return makeSaveKeys({
    CSV: () => save("csv", "text/csv", () => writeCsv(readTable(find(), true).rows)),
    LaTeX: () => save("tex", "text/x-tex", (title) => {
      const { heads, rows } = readTable(find(), false);
      return writeLatex(rows, heads, title);
    }),
  }, "the table");
}
