import { make } from "../elements.js";

// A cell of a CSV as RFC 4180 has it.
const quote = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

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
  const lines = [fields.map(([name]) => quote(name)), ...rows.map((row) => fields.map(([, write]) => quote(write(row))))];
  return lines.map((cells) => `${cells.join(",")}\n`).join("");
}

export function saveRows(cases, rows) {
  const address = URL.createObjectURL(new Blob([writeRows(cases, rows)], { type: "text/csv" }));
  make("a", { href: address, download: `${cases.info.folder || "batch"}.csv` }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
}
