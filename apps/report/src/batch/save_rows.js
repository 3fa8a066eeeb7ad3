import { fileStem, saveText } from "../saving/files.js";
import { writeCsv, writeLatex } from "../saving/tables.js";

// These rows as CSV, with the names of index.csv.
export function writeRows(cases, rows) {
  const { parameters, collected, run } = cases;
  const fields = [
    ["case", (row) => String(cases.numbers[row])],
    ...parameters.map((column) => [column.key, (row) => column.write(row)]),
    ["status", (row) => cases.status[row]],
    ["reason", (row) => cases.reasons[row]],
    ...[...collected, ...run].map((column) => [column.key, (row) => column.write(row) || "nan"]),
    ["warning", (row) => cases.warnings[row]],
  ];
  return writeCsv([fields.map(([name]) => name), ...rows.map((row) => fields.map(([, write]) => write(row)))]);
}

const stem = ({ info }) => fileStem(info.folder || "batch");

export const saveRows = (cases, rows) => saveText(`${stem(cases)}.csv`, "text/csv", writeRows(cases, rows));

// These rows as a table of LaTeX: what the page says of each case, without columns that say nothing.
export function saveLatex(cases, rows, fields) {
  const cells = rows.map((row) => fields.map((field) => field.say(row)));
  const kept = fields.map((_, i) => i).filter((i) => i === 0 || cells.some((line) => line[i] !== ""));
  const pick = (line) => kept.map((i) => line[i]);
  const table = [pick(fields.map(({ name }) => name)), ...cells.map(pick)];
  saveText(`${stem(cases)}.tex`, "text/x-tex", writeLatex(table, 1, cases.info.title || cases.info.folder || "batch"));
}
