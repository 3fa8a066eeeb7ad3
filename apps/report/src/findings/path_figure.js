import { make } from "../elements.js";
import { clipTo, drawLine, drawMark, findNearest, onPage } from "../figures/line_figure.js";
import { Axis } from "../figures/axis.js";
import { formatNumber } from "../format.js";

const reach = 26; // pixels within which a point is found
const reachOfMark = 11;
const dash = [5, 4];

export const marks = {
  limit: { outline: "triangle", symbol: "▲", words: "limit point" },
  bifurcation: { outline: "circle", symbol: "●", words: "bifurcation" },
  divergence: { outline: "square", symbol: "■", words: "divergence" },
  touch: { outline: "arrowhead", symbol: "▼", words: "contact begins" },
  release: { outline: "diamond", symbol: "◆", words: "contact ends" },
};

// Equilibria along the branches of a path, one quantity over another: full lines where they are stable, dashed where they are
// not, and a mark at each critical point. x and y are quantities { name, values, say }; a branch is
// { name, rows, isStable, colour(theme), isHidden }, a row for each point.
export class PathFigure {
  constructor({ branches, points, x, y, rows }) {
    Object.assign(this, { branches, points, quantities: [x, y], rows });
    const axisOf = ({ name, values, say }) => new Axis({ name, isNumeric: true, say }, { values: this.shown().flatMap((branch) => branch.rows.map((row) => values[row])) });
    this.x = axisOf(x);
    this.y = axisOf(y);
    this.places = branches.map((branch) => branch.rows.map((row, i) => ({ row, branch, i, x: x.values[row], y: y.values[row] })));
    this.marks = points.map((point) => ({ point, row: point.row, x: x.values[point.row], y: y.values[point.row] }));
  }

  shown() {
    const shown = this.branches.filter((branch) => !branch.isHidden);
    return shown.length > 0 ? shown : this.branches;
  }

  draw(plot, context, theme) {
    clipTo(plot, context);
    context.lineJoin = "round";
    context.lineWidth = 1.8 * plot.ratio;
    this.branches.forEach((branch, i) => {
      if (branch.isHidden) return;
      context.strokeStyle = branch.colour(theme);
      for (const [first, last, isStable] of splitByStability(branch)) {
        context.setLineDash(isStable ? [] : dash.map((length) => length * plot.ratio));
        drawLine(plot, context, this.places[i].slice(first, last + 1));
      }
    });
    context.setLineDash([]);
    for (const mark of this.marks) {
      mark.left = plot.left(mark.x);
      mark.top = plot.top(mark.y);
      if (this.isSeen(mark)) drawMark(plot, context, marks[mark.point.kind]?.outline ?? "circle", mark, { colour: theme.ink, edge: theme.paper });
    }
  }

  isSeen({ point }) {
    return !this.branches[point.branch]?.isHidden;
  }

  at(plot, left, top) {
    const mark = findNearest(plot, this.marks.filter((each) => this.isSeen(each)), left, top, reachOfMark);
    if (mark) return { row: mark.point.row, left: mark.left, top: mark.top, words: this.describeMark(mark.point) };
    const drawn = this.places.filter((_, i) => !this.branches[i].isHidden).flat();
    const found = findNearest(plot, drawn, left, top, reach);
    return found && { row: found.point.row, left: found.left, top: found.top, words: this.describePlace(found.point) };
  }

  describeMark({ point }) {
    return [make("em", {}, describePoint(point)), ...this.describeValues(point.row)];
  }

  describePlace({ row, branch, i }) {
    const isStable = branch.isStable[Math.min(i, branch.isStable.length - 1)] ?? true;
    return [make("span", {}, `${branch.name}, ${isStable ? "stable" : "unstable"}`), ...this.describeValues(row)];
  }

  describeValues(row) {
    const lines = this.quantities.map(({ name, values }) => [name, values[row]]);
    if (!this.quantities.some(({ values }) => values === this.rows.loads)) lines.push(["λ", this.rows.loads[row]]);
    return lines.map(([name, value]) => make("span", {}, `${name} `, make("b", {}, formatNumber(value, 6))));
  }

  // Where a row is drawn, also one that no branch has of its own.
  find(plot, row) {
    const [x, y] = this.quantities.map(({ values }) => values[row]);
    if (row < 0 || !Number.isFinite(x) || !Number.isFinite(y)) return null;
    return onPage(plot, { left: plot.left(x), top: plot.top(y) });
  }
}

// What the run says of a critical point.
export function describePoint({ kind, load_factor: load, words, finding, is_located: isLocated }) {
  if (finding) return finding;
  const where = isLocated ? `at λ = ${formatNumber(load, 7)}` : `before λ = ${formatNumber(load, 7)}`;
  return `${marks[kind]?.words ?? kind} ${where}${words ? `: ${words}` : ""}`;
}

// Stretches [first, last, isStable] of points of a branch; neighbours share a point.
function splitByStability({ rows, isStable }) {
  const stretches = [];
  for (let i = 0; i + 1 < rows.length; i++) {
    if (stretches.length > 0 && stretches.at(-1)[2] === isStable[i]) stretches.at(-1)[1] = i + 1;
    else stretches.push([i, i + 1, isStable[i]]);
  }
  return stretches;
}
