import { find, make } from "../elements.js";

const none = "";
const mostPlaces = 400; // values of a parameter of a heat map, or that a menu lists

const kindNames = { lines: "lines", points: "points", heat: "heat map", histogram: "histogram" };
const byNames = { lines: "one line per", points: "colour", heat: "upwards" };

// Of rising numbers of one sign, three or more.
function hasEqualRatios(values) {
  const ratios = values.slice(1).map((value, i) => value / values[i]);
  return ratios.length > 1 && values[0] * values.at(-1) > 0 && ratios.every((ratio) => Math.abs(ratio / ratios[0] - 1) < 1e-5);
}

// What the chart shows, and the menus that choose it.
export class ChartChoices {
  constructor(cases, onChange) {
    this.cases = cases;
    this.onChange = onChange;
    this.menus = Object.fromEntries(["kind", "value", "across", "by"].map((id) => [id, find(id)]));
    this.boxes = { across: find("log-across"), value: find("log-value") };
    this.fixed = new Map(); // of parameters: the value that cases must have
    this.fillMenus();
    this.chooseFirst();
    this.bind();
    this.update();
  }

  fillMenus() {
    const { kind, value, across, by } = this.menus;
    const { parameters, collected, run } = this.cases;
    for (const [name, words] of Object.entries(kindNames)) {
      if (name !== "heat" || this.axesOfHeatMap.length > 1) kind.append(make("option", { value: name }, words));
    }
    const list = (columns, label) =>
      columns.length === 0 ? null : make("optgroup", { label }, ...columns.map(({ key, name }) => make("option", { value: key }, name)));
    const fill = (menu, ...groups) => menu.append(...groups.filter((group) => group !== null));
    fill(value, list(collected, "collected"), list(run, "run"), list(parameters, "parameters"));
    fill(across, list(parameters, "parameters"), list(collected, "collected"), list([this.cases.case, ...run], "run"));
    by.append(make("option", { value: none }, "–"));
    fill(by, list(parameters, "parameters"), list(collected, "collected"));
  }

  get axesOfHeatMap() {
    const { varied, isSampled, info } = this.cases;
    return isSampled || info.combine === "zip" ? [] : varied.filter((column) => column.values.length <= mostPlaces);
  }

  // Over the first swept number, of more than two values if there is one, with a line for each value of the next parameter; samples
  // are points.
  chooseFirst() {
    const { cases, menus } = this;
    const { varied, isSampled, info } = cases;
    const rank = (column) => (column.isNumeric ? Math.min(column.values.length, 3) : 0);
    const ranked = [...varied].sort((a, b) => rank(b) - rank(a));
    const [first, second] = ranked;
    const { collected } = cases;
    const changes = (least) => collected.find((column) => column.values.length > least);
    menus.value.value = (changes(1) ?? changes(0) ?? cases.find("seconds")).key;
    menus.across.value = (first ?? cases.case).key;
    menus.kind.value = isSampled || info.combine === "decks" || !first?.isNumeric ? "points" : "lines";
    const isGrid = info.combine === "grid";
    menus.by.value = isGrid && second && second.values.length <= mostPlaces ? second.key : none;
    this.chooseScale("across");
    this.chooseScale("value");
  }

  // Powers of ten where a sweep goes by equal ratios, or a straight scale would squeeze most of it.
  chooseScale(which) {
    const column = this[which];
    const { values } = column;
    const [least, largest] = [values[0], values.at(-1)];
    const times = which === "across" ? 50 : 1000;
    const isWide = least * largest > 0 && Math.max(largest / least, least / largest) >= times;
    this.boxes[which].checked = column.isNumeric && (isWide || (column.group === "parameter" && hasEqualRatios(values)));
  }

  bind() {
    const { kind, value, across, by } = this.menus;
    kind.addEventListener("change", () => {
      if (kind.value === "heat") this.chooseHeatAxes();
      this.change();
    });
    for (const [which, menu] of Object.entries({ value, across })) {
      menu.addEventListener("change", () => {
        this.chooseScale(which);
        this.change();
      });
    }
    by.addEventListener("change", () => this.change());
    for (const box of Object.values(this.boxes)) box.addEventListener("change", () => this.change());
  }

  change() {
    this.update();
    this.onChange();
  }

  chooseHeatAxes() {
    const axes = this.axesOfHeatMap;
    const { across, by } = this.menus;
    if (!axes.includes(this.across)) across.value = axes.find((column) => column !== this.by).key;
    if (!axes.includes(this.by) || this.by === this.across) by.value = axes.find((column) => column !== this.across).key;
  }

  // Updates names, enabled choices and menus of the other parameters.
  update() {
    const { kind } = this;
    const isHeat = kind === "heat";
    const hasAcross = kind !== "histogram";
    this.menus.across.closest("label").hidden = !hasAcross;
    this.menus.by.closest("label").hidden = !hasAcross;
    find("by-name").textContent = byNames[kind] ?? "";
    find("value-name").textContent = isHeat ? "colour" : "value";
    const axes = this.axesOfHeatMap.map(({ key }) => key);
    for (const menu of [this.menus.across, this.menus.by]) {
      for (const option of menu.options) option.disabled = isHeat && !axes.includes(option.value);
    }
    if (isHeat && (this.by === null || this.by === this.across)) this.chooseHeatAxes();
    this.boxes.across.closest("label").hidden = !hasAcross || isHeat || !this.across.isNumeric;
    this.boxes.value.closest("label").hidden = !this.value.isNumeric;
    this.listOthers();
  }

  // A menu for each parameter that is neither an axis nor a colour, if there are few enough values.
  listOthers() {
    const others = this.others.filter((column) => column.values.length <= mostPlaces);
    const isHeat = this.kind === "heat";
    for (const key of this.fixed.keys()) {
      if (!others.some((column) => column.key === key)) this.fixed.delete(key);
    }
    const menus = others.map((column) => {
      const { key, name, values } = column;
      if (isHeat && !this.fixed.has(key)) this.fixed.set(key, values[0]);
      const menu = make("select", { "data-fixes": key });
      if (!isHeat) menu.append(make("option", { value: none }, "all"));
      values.forEach((value, i) => menu.append(make("option", { value: String(i) }, column.say(value))));
      menu.value = this.fixed.has(key) ? String(values.indexOf(this.fixed.get(key))) : none;
      menu.addEventListener("change", () => {
        if (menu.value === none) this.fixed.delete(key);
        else this.fixed.set(key, values[Number(menu.value)]);
        this.onChange();
      });
      return make("label", {}, make("span", {}, name), " ", menu);
    });
    find("others").replaceChildren(...menus);
  }

  get kind() {
    return this.menus.kind.value;
  }

  get value() {
    return this.cases.find(this.menus.value.value);
  }

  get across() {
    return this.cases.find(this.menus.across.value);
  }

  get by() {
    return this.kind === "histogram" ? null : (this.cases.find(this.menus.by.value) ?? null);
  }

  // Varied parameters that the chart does not show; in a sample all vary, and none can be held.
  get others() {
    const { varied, isSampled, info } = this.cases;
    if (isSampled || info.combine === "zip" || info.combine === "decks") return [];
    const shown = this.kind === "histogram" ? [] : [this.across, this.by];
    return varied.filter((column) => !shown.includes(column));
  }

  get logAcross() {
    return this.boxes.across.checked;
  }

  get logValue() {
    return this.boxes.value.checked;
  }

  // Rows that have the values which are held.
  held(rows) {
    const tests = [...this.fixed].map(([key, value]) => [this.cases.find(key).numbers, value]);
    return rows.filter((row) => tests.every(([numbers, value]) => numbers[row] === value));
  }
}
