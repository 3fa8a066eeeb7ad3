import uPlot from "uplot";
import { formatTicks, linearTicks, logTicks } from "../figures/ticks.js";
import { timeSymbol } from "../format.js";
import { unitOf } from "../units.js";
import { readTheme } from "../theme.js";

// What the axes of all charts of a run have in common.
function axisOptions(isUpright, isLog) {
  const pixels = ({ bbox }) => (isUpright ? bbox.height : bbox.width) / uPlot.pxRatio || (isUpright ? 120 : 300);
  return {
    stroke: () => readTheme().muted,
    grid: { stroke: () => readTheme().line, width: 1 },
    ticks: { show: false },
    font: `11px ${getComputedStyle(document.body).fontFamily}`,
    splits: (plot, axis, least, largest) => (isLog ? logTicks : linearTicks)([least, largest], pixels(plot), isUpright),
    filter: (plot, ticks) => ticks,
    values: (plot, ticks) => formatTicks(ticks),
    gap: 4,
  };
}

export function axesOptions(isLog = false) {
  const size = (plot, ticks) => 16 + 6.2 * Math.max(3, ...(ticks ?? []).map((tick) => String(tick).length));
  return [{ ...axisOptions(false, false), size: 26 }, { ...axisOptions(true, isLog), size }];
}

// "time t, s": what the axis across is of a chart over the steps.
export function nameAcross(timeName, units) {
  return `${timeName} ${timeSymbol(timeName)}${timeName === "time" ? `, ${unitOf("time", units)}` : ""}`;
}

export function widen(least, largest) {
  return least < largest ? [least, largest] : [least - 0.5, largest + 0.5];
}

// Around what there is, with room above and below. What varies by less than `least_height` stays a flat line.
export function rangeAround(least, largest, leastHeight) {
  if (least === null) return [0, 1];
  const size = Math.max(Math.abs(least), Math.abs(largest));
  const margin = Math.max(0.06 * (largest - least), 1e-6 * size, leastHeight);
  return margin === 0 ? [-1, 1] : [least - margin, largest + margin];
}

// Of columns of numbers, gaps left out.
export function largestSize(columns) {
  let largest = 0;
  for (const column of columns) {
    for (const value of column) {
      if (Number.isFinite(value)) largest = Math.max(largest, Math.abs(value));
    }
  }
  return largest;
}
