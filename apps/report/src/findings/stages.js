import { nearestRow } from "./path_tab.js";

// Stages that take time, in their order; none of a run without stages.
export function listTimedStages({ stages }) {
  return stages.filter(({ from, until }) => until > from);
}

// Which of these stages a time belongs to; a boundary belongs to the stage that ends there.
export function stageAt(stages, time) {
  return stages.find(({ until }) => time <= until) ?? stages.at(-1) ?? null;
}

// What the player says in addition to the time: the stage and, on a path, the load factor.
export function describeTime({ stages, paths, rows }, time) {
  const words = [];
  const stage = stageAt(listTimedStages({ stages }), time);
  if (stage) words.push(stage.name);
  const path = paths.find(({ first, count }) => time >= rows.times[first] && time <= rows.times[first + count - 1]);
  const load = path ? rows.loads[nearestRow(path, rows, time)] : null;
  return { words, load };
}

// Frames after which the motion does not go on from frame to frame: the next one is of another branch of a path.
export function listSeams({ paths, rows }, times) {
  const seams = new Set();
  if (paths.length === 0) return seams;
  const branchAt = (time) => {
    const path = paths.find(({ first, count }) => time >= rows.times[first] && time <= rows.times[first + count - 1]);
    return path ? `${path.stage} ${rows.branches[nearestRow(path, rows, time)]}` : "";
  };
  let before = null;
  times.forEach((time, frame) => {
    const branch = branchAt(time);
    if (before && branch && branch !== before && !branch.endsWith(" 0")) seams.add(frame - 1);
    before = branch;
  });
  return seams;
}
