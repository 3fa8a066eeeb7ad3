import { formatNumber } from "../format.js";

const widthOfDigit = 6.4; // pixels
const gap = 16; // between two labels, in pixels
const mostDigits = 15;

// Multiples of 1, 2 or 5 times a power of ten, at most so many: the numbers that their labels say, not sums of steps.
function multiples([least, largest], most) {
  const rough = (largest - least) / Math.max(most, 1);
  if (!(rough > 0) || !Number.isFinite(rough)) return [];
  const power = Math.floor(Math.log10(rough));
  const factor = [1, 2, 5, 10].find((each) => each * 10 ** power >= rough * (1 - 1e-9)) ?? 10;
  const step = Number(`${factor}e${power}`);
  const first = Math.ceil(least / step - 1e-9);
  const last = Math.floor(largest / step + 1e-9);
  return Array.from({ length: Math.max(0, Math.min(last - first + 1, 200)) }, (_, i) => Number(`${(first + i) * factor}e${power}`));
}

// Ticks in so many pixels of an axis: as many as have room, so that labels do not touch.
export function linearTicks(range, pixels, isUpright) {
  if (isUpright) return multiples(range, Math.max(2, pixels / 26));
  for (let most = Math.max(2, Math.floor(pixels / 50)); most > 2; most--) {
    const ticks = multiples(range, most);
    if (ticks.length * widthOf(ticks) <= pixels) return ticks;
  }
  return multiples(range, 2);
}

// 1, 2 and 5 times powers of ten, or powers only, at most so many; within a few of them multiples as on a straight axis.
export function logTicks([least, largest], pixels, isUpright) {
  const most = pixels / (isUpright ? 26 : 62);
  const [first, last] = [Math.floor(Math.log10(least)), Math.ceil(Math.log10(largest))];
  const listed = [[1, 2, 5], [1]].map((factors) => {
    const ticks = [];
    for (let power = first; power <= last; power++) {
      for (const factor of factors) ticks.push(Number(`${factor}e${power}`));
    }
    return ticks.filter((tick) => tick >= least && tick <= largest);
  });
  if (listed[0].length < 3) return linearTicks([least, largest], 0.6 * pixels, isUpright);
  const inside = listed[0].length <= most ? listed[0] : listed[1];
  return inside.filter((_, i) => i % Math.max(1, Math.ceil(inside.length / most)) === 0);
}

// The values of a sweep within the range as its ticks, if they are few, short to write and have room; null otherwise.
export function ticksAtValues(all, [least, largest], pixels, isUpright, isLog) {
  const values = all.filter((value) => value >= least && value <= largest);
  if (values.length < 2 || values.length > 12 || values.some((value) => Number(value.toPrecision(5)) !== value)) return null;
  const at = isLog ? Math.log : Number;
  const places = values.map((value) => (pixels * (at(value) - at(least))) / (at(largest) - at(least)));
  const room = isUpright ? 16 : widthOf(values);
  return places.every((place, i) => i === 0 || place - places[i - 1] >= room) ? values : null;
}

function widthOf(ticks) {
  return gap + widthOfDigit * Math.max(...formatTicks(ticks).map((text) => text.length), 1);
}

// Labels of ticks, with as many digits as say each of them exactly, so that no two are alike.
export function formatTicks(ticks) {
  const isExact = (digits) => ticks.every((tick) => !Number.isFinite(tick) || Number(tick.toPrecision(digits)) === tick);
  let digits = 2;
  while (digits < mostDigits && !isExact(digits)) digits++;
  return ticks.map((tick) => (Number.isFinite(tick) ? formatNumber(tick, digits) : ""));
}
