const escapes = {
  "\\": "\\textbackslash{}", "{": "\\{", "}": "\\}", "$": "\\$", "&": "\\&", "%": "\\%", "#": "\\#", "_": "\\_", "~": "\\textasciitilde{}",
  "^": "\\textasciicircum{}", "<": "$<$", ">": "$>$", "|": "$|$", "−": "$-$", "·": "$\\cdot$", "×": "$\\times$", "°": "$^\\circ$", "±": "$\\pm$", "≥": "$\\ge$", "≤": "$\\le$",
  "√": "$\\surd$", "∞": "$\\infty$", "→": "$\\to$", "–": "--", "—": "---", "…": "\\dots{}", "“": "``", "”": "''", "’": "'", "µ": "$\\mu$", "\u202f": "\\,", "\u00a0": "~",
};
const greek = Object.fromEntries(
  ("α alpha β beta γ gamma δ delta ε varepsilon ζ zeta η eta θ theta κ kappa λ lambda μ mu ν nu ξ xi π pi ρ rho σ sigma τ tau φ varphi χ chi ψ psi ω omega " +
    "Γ Gamma Δ Delta Θ Theta Λ Lambda Ξ Xi Π Pi Σ Sigma Φ Phi Ψ Psi Ω Omega").split(" ").reduce((pairs, word, i, all) => (i % 2 ? pairs : [...pairs, [word, `$\\${all[i + 1]}$`]]), []),
);
const raised = "⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹";
const lowered = "₀₁₂₃₄₅₆₇₈₉";
const number = /^[−-]?[\d\u202f]+(\.\d+)?(·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+|e[-+]?\d+)?$/;

// Whether a text is one number, as the page writes it; "–" stands for none.
export const isNumber = (text) => text === "–" || number.test(text);

// Any text as LaTeX sets it, numbers in math.
export function escapeLatex(text) {
  if (text !== "–" && number.test(text)) return writeNumber(text);
  const runs = text.replaceAll(new RegExp(`[${raised}]+`, "g"), (run) => `\u0001${[...run].map((sign) => "-+0123456789"[raised.indexOf(sign)]).join("")}\u0002`)
    .replaceAll(new RegExp(`[${lowered}]+`, "g"), (run) => `\u0003${[...run].map((sign) => lowered.indexOf(sign)).join("")}\u0002`);
  const marks = { "\u0001": "$^{", "\u0002": "}$", "\u0003": "$_{" };
  return [...runs].map((letter) => marks[letter] ?? escapes[letter] ?? greek[letter] ?? letter).join("").replaceAll(/\r?\n/g, " ");
}

function writeNumber(text) {
  const plain = text.replace("−", "-").replaceAll("\u202f", "\\,").replaceAll(new RegExp(`[${raised}]`, "g"), (sign) => "-+0123456789"[raised.indexOf(sign)]);
  const [, mantissa, power] = /^(.*?)(?:(?:·10|e)\+?(-?\d+))?$/.exec(plain);
  if (/^-?1$/.test(mantissa) && power !== undefined) return `$${mantissa.replace("1", "")}10^{${power}}$`;
  return power === undefined ? `$${mantissa}$` : `$${mantissa}\\cdot10^{${power}}$`;
}
