// Where multiples of a speed meet modes, and how far around each meeting a frequency is near its multiple.
export const mostMultiples = 8;
const near = 0.1; // of the multiple

// `across`: places of the values, rising or falling; `speeds`: the speed there in the unit of frequencies; `frequencies`: a list
// for each mode, NaN where it was lost; linear between values. Returns [{ mode, multiple, place, frequency, from, until }] by
// rising place; from and until: between which places the frequency is within a tenth of the multiple.
export function findCrossings(across, speeds, frequencies) {
  const found = [];
  frequencies.forEach((list, mode) => {
    for (let multiple = 1; multiple <= mostMultiples; multiple++) {
      const line = speeds.map((speed) => multiple * Math.abs(speed));
      const off = list.map((value, i) => value - line[i]);
      for (let i = 0; i + 1 < list.length; i++) {
        if (!isMet(off, line, i)) continue;
        const part = off[i] / (off[i] - off[i + 1]);
        const frequency = mix(line[i], line[i + 1], part);
        const meeting = { x: mix(across[i], across[i + 1], part), over: -near * frequency };
        const over = off.map((difference, k) => Math.abs(difference) - near * line[k]);
        const ends = [findEnd(across, over, meeting, i, -1), findEnd(across, over, meeting, i + 1, 1)];
        found.push({ mode, multiple, place: meeting.x, frequency, from: Math.min(...ends), until: Math.max(...ends) });
      }
    }
  });
  return found.sort((a, b) => a.place - b.place);
}

const mix = (a, b, part) => a + (b - a) * part;

// Whether a curve meets a line that rises from rest, after value i and up to the next one.
function isMet(off, line, i) {
  if (off[i] === off[i + 1]) return false;
  if (off[i] === 0) return i === 0 && line[0] > 0;
  return off[i] * off[i + 1] < 0 || (off[i + 1] === 0 && line[i + 1] > 0);
}

// The place beyond which `over` is more than 0, from a meeting on in one direction, or the last one that is known.
function findEnd(across, over, meeting, start, step) {
  let before = meeting;
  for (let at = start; at >= 0 && at < over.length && Number.isFinite(over[at]); at += step) {
    if (over[at] > 0) return mix(before.x, across[at], before.over / (before.over - over[at]));
    before = { x: across[at], over: over[at] };
  }
  return before.x;
}
