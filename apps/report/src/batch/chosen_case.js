import { find, make } from "../elements.js";

// The case that was chosen, with words too long for the table.
export function bindChosenCase(cases, attention) {
  const panel = find("chosen");
  const show = () => {
    const row = attention.chosen;
    panel.hidden = row < 0;
    if (row < 0) return;
    const page = cases.page(row);
    const close = make("button", { type: "button", className: "close", "aria-label": "Deselect the case" }, "×");
    close.addEventListener("click", () => attention.choose(row));
    panel.replaceChildren(
      make("p", {}, make("strong", {}, `Case ${cases.numbers[row]}`), ` ${cases.varied.map((column) => `${column.name} = ${column.show(row)}`).join(", ")}`),
      ...(cases.isDone(row) ? [] : [make("p", { className: "bad" }, `${cases.status[row]}: ${cases.reasons[row]}`)]),
      ...(cases.warnings[row] ? [make("p", {}, cases.warnings[row])] : []),
      ...(page ? [make("p", {}, make("a", { href: page }, "Open its report"))] : []),
      close,
    );
  };
  attention.listen((what) => what === "chosen" && show());
}
