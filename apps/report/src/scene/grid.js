import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments } from "three";

// A grid below a box, a little larger than it, with squares of 1, 2 or 5 times a power of ten.
export function makeGrid([least, largest]) {
  const span = Math.max(largest.x - least.x, largest.y - least.y, 1e-30);
  const power = 10 ** Math.floor(Math.log10(span / 8));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= span / 16);
  const from = (x) => Math.floor(x / step - 0.5) * step;
  const to = (x) => Math.ceil(x / step + 0.5) * step;
  const [x0, x1, y0, y1] = [from(least.x), to(largest.x), from(least.y), to(largest.y)];
  const points = [];
  for (let x = x0; x < x1 + 0.5 * step; x += step) points.push(x, y0, least.z, x, y1, least.z);
  for (let y = y0; y < y1 + 0.5 * step; y += step) points.push(x0, y, least.z, x1, y, least.z);
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  const material = new LineBasicMaterial({ transparent: true, opacity: 0.75, depthWrite: false });
  return { lines: new LineSegments(geometry, material), step };
}
