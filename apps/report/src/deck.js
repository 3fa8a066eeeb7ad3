import { find, make } from "./elements.js";

// TOML by its parts; what matches nothing stays plain.
const token =
  /(?<comment>#.*)|(?<text>"""|'''|"(?:\\.|[^"\\])*"|'[^']*')|(?<number>[+-]?\b\d[\d_.]*(?:[eE][+-]?\d+)?\b)|(?<word>\b(?:true|false)\b)/g;
const heading = /^\s*\[.*\]\s*(#.*)?$/;
const key = /^\s*[\w.-]+(?=\s*=)/;

function highlight(line) {
  if (heading.test(line)) return [make("b", {}, line)];
  const parts = [];
  const name = key.exec(line);
  let at = 0;
  if (name) {
    parts.push(make("span", { className: "toml-key" }, name[0]));
    at = name[0].length;
  }
  for (const match of line.slice(at).matchAll(token)) {
    const first = match.index + (name ? name[0].length : 0);
    const kind = Object.keys(match.groups).find((group) => match.groups[group] !== undefined);
    parts.push(line.slice(at, first), make("span", { className: `toml-${kind}` }, match[0]));
    at = first + match[0].length;
  }
  parts.push(line.slice(at));
  return parts;
}

// The text of a deck with numbers of its lines.
export function makeDeck(text) {
  const code = make("code", {});
  for (const line of text.replace(/\n$/, "").split("\n")) code.append(make("span", { className: "line" }, ...highlight(line), "\n"));
  return make("pre", { className: "deck", tabIndex: 0 }, code);
}

export function showDeck(info) {
  find("deck").append(
    make("p", { className: "note" }, `${info.deck_name}, as run. SHA-256 `, make("code", {}, info.deck_sha256)),
    makeDeck(info.deck),
  );
}
