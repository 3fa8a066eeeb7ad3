const superscripts = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

// "0.125", "−3.2·10⁻⁵": so many digits, without zeros at the end.
export function formatNumber(value, digits = 4) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e7) return withMinus(String(Number(value.toPrecision(digits))));
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  const power = String(Number(exponent)).replace(/[-0-9]/g, (c) => superscripts[c]);
  return withMinus(`${Number(mantissa)}·10${power}`);
}

function withMinus(text) {
  return text.replace(/^-/, "−");
}

// "angular_velocity" as a reader says it.
export function inWords(name) {
  return name.replaceAll("_", " ");
}

export function formatCount(value) {
  return String(value).replace(/\B(?=(\d{3})+$)/g, "\u202f");
}

// Of what the frames count.
export function timeSymbol(timeName) {
  return { "load factor": "λ", "arc length": "s" }[timeName] ?? "t";
}
