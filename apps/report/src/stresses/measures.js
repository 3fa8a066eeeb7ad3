// What is shown of a stress (xx yy zz yz xz xy) at a point of a section.
export const measures = {
  von_mises: { name: "von Mises", of: vonMises },
  sigma_xx: { name: "σxx, axial", of: ([xx]) => xx },
  tau: { name: "τ = √(σxy² + σxz²)", of: (stress) => Math.hypot(stress[4], stress[5]) },
  sigma_xy: { name: "σxy", of: (stress) => stress[5] },
  sigma_xz: { name: "σxz", of: (stress) => stress[4] },
  sigma_yy: { name: "σyy", of: (stress) => stress[1] },
  sigma_zz: { name: "σzz", of: (stress) => stress[2] },
  sigma_yz: { name: "σyz", of: (stress) => stress[3] },
};

function vonMises([xx, yy, zz, yz, xz, xy]) {
  const shear = yz * yz + xz * xz + xy * xy;
  return Math.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * shear);
}

// A measure at all points of a section under six resultants (N, Vy, Vz, T, My, Mz).
export function measureSection({ operators, points }, resultants, { of }) {
  const values = new Float32Array(points.length / 2);
  const stress = new Float64Array(6);
  for (let point = 0; point < values.length; point++) {
    for (let i = 0; i < 6; i++) {
      stress[i] = 0;
      for (let j = 0; j < 6; j++) stress[i] += operators[36 * point + 6 * i + j] * resultants[j];
    }
    values[point] = of(stress);
  }
  return values;
}

// The point where the size is largest, and the range of values; points of infinite stress have no say.
export function surveyValues(values, singular) {
  let [least, largest, point] = [Infinity, -Infinity, -1];
  values.forEach((value, i) => {
    if (singular[i] || !Number.isFinite(value)) return;
    least = Math.min(least, value);
    largest = Math.max(largest, value);
    if (point < 0 || Math.abs(value) > Math.abs(values[point])) point = i;
  });
  return { range: point < 0 ? [0, 0] : [least, largest], point };
}
