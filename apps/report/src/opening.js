import { formatNumber, timeSymbol } from "./format.js";
import { componentOf } from "./motion.js";

const instabilities = new Set(["limit", "bifurcation", "divergence"]);

// Where the page opens, { frame, why }: at the time of the address, #t=0.5, or where something happens.
export function findOpening(data, found, clock, address) {
  const asked = /^#t=(.*)$/.exec(address);
  if (!asked) return findEvent(data, found, clock);
  const time = readNumber(asked[1]);
  const symbol = timeSymbol(data.info.time_name);
  if (Number.isFinite(time)) return { frame: Math.round(clock.positionAt(time)), why: `the frame nearest to ${symbol} = ${formatNumber(time, 6)} of the address`, isAsked: true };
  return { ...findEvent(data, found, clock), fault: `The address has ${address}; expected a number, as in #t=0.5` };
}

// Of a part of an address; NaN if it is not a number.
function readNumber(text) {
  try {
    return Number(decodeURIComponent(text).replace("−", "-").trim() || NaN);
  } catch {
    return NaN;
  }
}

function findEvent(data, found, clock) {
  const { info } = data;
  if (info.status === "failed") return { frame: clock.last, why: "the last frame before the run failed" };
  const broken = findBreak(data, found, clock);
  if (broken) return broken;
  const critical = findCritical(found, clock);
  if (critical) return critical;
  const [moved, frame] = findMostMoved(data);
  if (info.is_static && moved.at(-1) > 0.5 * moved[frame]) return { frame: clock.last, why: "the last state" };
  const first = findFirstContact(data);
  if (first) return { frame: first, why: "the largest contact force" };
  return { frame, why: moved[frame] > 0 ? "the frame that has moved most" : "the last frame" };
}

// Where the first joint breaks, as far as histories say whether they hold. One that ceases to hold where a stage begins rests in it.
function findBreak({ info, stepTimes }, { stages }, clock) {
  const [, ...later] = stages.filter(({ from, until }) => until > from);
  const begins = new Set(later.map(({ from }) => from));
  let found = null;
  for (const { title, quantity, columns } of info.charts) {
    if (quantity !== "holds") continue;
    const [holds] = columns;
    const step = holds.findIndex((value, i) => i > 0 && value === 0 && holds[i - 1] === 1 && !begins.has(stepTimes[i - 1]));
    if (step >= 0 && !(found?.step <= step)) found = { step, title };
  }
  return found && { frame: Math.ceil(clock.positionAt(stepTimes[found.step])), why: `${found.title} breaks` };
}

// Where a path becomes unstable for the first time, else its first critical point.
function findCritical({ paths, rows }, clock) {
  const points = paths.flatMap(({ points: list }) => list);
  const point = points.find(({ kind }) => instabilities.has(kind)) ?? points[0];
  if (!point) return null;
  const words = { limit: "limit point", touch: "place where contact begins", release: "place where contact ends" };
  return { frame: Math.round(clock.positionAt(rows.times[point.row])), why: `the first ${words[point.kind] ?? point.kind}` };
}

// Where contact forces are largest, if contact begins in the run; 0 otherwise.
function findFirstContact({ contacts, contactOffsets, times }) {
  if (contactOffsets.length < 2 || contactOffsets[1] > 0) return 0;
  let [most, found] = [0, 0];
  for (let frame = 1; frame < times.length; frame++) {
    for (let i = contactOffsets[frame]; i < contactOffsets[frame + 1]; i++) {
      const force = componentOf(contacts, 7 * i + 3, 3);
      if (force > most) [most, found] = [force, frame];
    }
  }
  return found;
}

// For each frame how far the farthest node is from where it was when the motion began, which is at t = 0 where stages of statics
// come before; and the frame in which that is largest, the last one if nothing moves.
function findMostMoved({ quantities, times }) {
  const { values } = quantities.displacement;
  const size = values.length / times.length;
  const first = Math.max(0, times.findIndex((time) => time >= 0));
  const start = values.subarray(first * size, (first + 1) * size);
  const moved = new Float64Array(times.length);
  let [most, found] = [0, times.length - 1];
  for (let frame = first; frame < times.length; frame++) {
    const here = values.subarray(frame * size, (frame + 1) * size);
    for (let i = 0; i < size; i += 3) {
      moved[frame] = Math.max(moved[frame], Math.hypot(here[i] - start[i], here[i + 1] - start[i + 1], here[i + 2] - start[i + 2]));
    }
    if (moved[frame] > most * (1 + 1e-6)) [most, found] = [moved[frame], frame];
  }
  return [moved, found];
}
