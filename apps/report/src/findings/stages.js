// Parts of a run with names, in their order: stages that take time and, of a path with branches, the path and each branch.
export function listParts({ stages, paths, rows }) {
  const branched = paths.filter(({ paths: branches }) => branches.length > 1);
  const whole = stages.filter(({ name, from, until }) => until > from && !branched.some(({ stage }) => stage === name));
  return [...whole, ...branched.flatMap((path) => splitByBranch(path, rows))].sort((a, b) => a.from - b.from);
}

function splitByBranch({ stage, first, count, paths }, { times, branches }) {
  const parts = [];
  for (let row = first; row < first + count; row++) {
    const isNew = row === first || branches[row] !== branches[row - 1];
    const name = paths[branches[row]]?.name ?? (branches[row] === 0 ? stage : `branch ${branches[row]}`);
    if (isNew) parts.push({ name, from: times[Math.max(row - 1, first)], until: times[row] });
    else parts.at(-1).until = times[row];
  }
  return parts;
}

// Stages of a page that take time, in their order.
export const listTimedStages = ({ stages }) => (stages ?? []).filter(({ from, until }) => until > from);

// Which of these parts a time belongs to; a boundary belongs to the part that ends there.
export function partAt(parts, time) {
  return parts.find(({ until }) => time <= until) ?? parts.at(-1) ?? null;
}

// The row of a path that is nearest in time.
export function nearestRow({ first, count }, { times }, time) {
  let [low, high] = [first, first + count - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return Math.abs(times[low] - time) <= Math.abs(times[high] - time) ? low : high;
}

const pathAt = ({ paths, rows }, time) => paths.find(({ first, count }) => time >= rows.times[first] && time <= rows.times[first + count - 1]);

// What the player says in addition to the time: the part of the run and, on a path, the load factor.
export function describeTime(found, parts, time) {
  const path = pathAt(found, time);
  const load = path ? found.rows.loads[nearestRow(path, found.rows, time)] : null;
  const part = partAt(parts, time);
  return { words: part ? [part.name] : [], load };
}

// Frames after which the motion does not go on from frame to frame: the next one is of another branch of a path, or is after it.
export function listSeams(found, times) {
  const seams = new Set();
  const branchAt = (time) => {
    const path = pathAt(found, time);
    return path ? found.rows.branches[nearestRow(path, found.rows, time)] : 0;
  };
  for (let frame = 0; frame + 1 < times.length; frame++) {
    if (branchAt(times[frame]) !== branchAt(times[frame + 1])) seams.add(frame);
  }
  return seams;
}

// Stretches of time [from, until] of paths, and of these the unstable ones: after a point whose tangent has negative pivots.
export function listPathStretches({ paths, rows }) {
  const whole = paths.map(({ first, count }) => [rows.times[first], rows.times[first + count - 1]]);
  const unstable = [];
  for (const { first, count } of paths) {
    for (let row = first; row + 1 < first + count; row++) {
      if (!(rows.pivots[row] > 0) || rows.branches[row] !== rows.branches[row + 1]) continue;
      if (unstable.length > 0 && unstable.at(-1)[1] === rows.times[row]) unstable.at(-1)[1] = rows.times[row + 1];
      else unstable.push([rows.times[row], rows.times[row + 1]]);
    }
  }
  return { whole, unstable };
}
