import { find, make } from "./elements.js";
import { readToml } from "./toml.js";

const partsOf = (line) => line.map(({ kind, text }) => (kind ? make("span", { className: `toml-${kind}` }, text) : text));

// The text of a deck with numbers of its lines.
export function makeDeck(text) {
  const code = make("code", {});
  for (const line of readToml(text.replace(/\n$/, ""))) code.append(make("span", { className: "line" }, ...partsOf(line), "\n"));
  return make("pre", { className: "deck", tabIndex: 0 }, code);
}

export function showDeck(info) {
  find("deck").append(
    make("p", { className: "note" }, `${info.deck_name}, as run. SHA-256 `, make("code", {}, info.deck_sha256)),
    makeDeck(info.deck),
  );
}
