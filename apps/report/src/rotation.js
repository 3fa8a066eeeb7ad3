// Quaternions as four numbers (w x y z) in flat arrays.

// The rotation by `factor` times the vector at `from` in `vectors`.
export function fromVector(vectors, from, factor, out, at) {
  const x = vectors[from] * factor;
  const y = vectors[from + 1] * factor;
  const z = vectors[from + 2] * factor;
  const angle = Math.sqrt(x * x + y * y + z * z);
  const ratio = angle > 1e-8 ? Math.sin(angle / 2) / angle : 0.5;
  out[at] = Math.cos(angle / 2);
  out[at + 1] = x * ratio;
  out[at + 2] = y * ratio;
  out[at + 3] = z * ratio;
}

// out = a b: first b, then a.
export function multiply(a, i, b, j, out, at) {
  const aw = a[i], ax = a[i + 1], ay = a[i + 2], az = a[i + 3];
  const bw = b[j], bx = b[j + 1], by = b[j + 2], bz = b[j + 3];
  out[at] = aw * bw - ax * bx - ay * by - az * bz;
  out[at + 1] = aw * bx + ax * bw + ay * bz - az * by;
  out[at + 2] = aw * by - ax * bz + ay * bw + az * bx;
  out[at + 3] = aw * bz + ax * by - ay * bx + az * bw;
}

// Between two rotations, in proportion; the nearer of them where they are more than a right angle apart.
export function between(a, i, b, j, part, out, at) {
  let dot = 0;
  for (let k = 0; k < 4; k++) dot += a[i + k] * b[j + k];
  const share = Math.abs(dot) < Math.SQRT1_2 ? Math.round(part) : part;
  const sign = dot < 0 ? -share : share;
  let norm = 0;
  for (let k = 0; k < 4; k++) {
    const value = (1 - share) * a[i + k] + sign * b[j + k];
    out[at + k] = value;
    norm += value * value;
  }
  norm = 1 / Math.sqrt(norm);
  for (let k = 0; k < 4; k++) out[at + k] *= norm;
}
