import { make } from "../elements.js";

// Offers a file to the browser, which saves it as it saves downloads.
export function saveFile(name, content) {
  const address = URL.createObjectURL(content);
  make("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
}

export const saveText = (name, type, text) => saveFile(name, new Blob([text], { type }));

// "free_flight tip displacement" as the stem of a file's name, without what file systems refuse.
export function fileStem(...words) {
  const text = words.filter(Boolean).join(" ").replaceAll(/[^\p{L}\p{N}.+-]+/gu, "_").replace(/^[_.]+|_+$/g, "");
  return text.slice(0, 80) || "gxrod";
}

// Of the results that the page shows.
export function pageStem() {
  const { file, folder, deck } = JSON.parse(document.getElementById("report").textContent);
  return String(file || folder || deck || "gxrod").replace(/\.(vtkhdf|toml)$/, "");
}

// Small buttons that save what is next to them: { SVG: () => … }.
export function makeSaveKeys(actions, what) {
  const keys = Object.entries(actions).map(([name, act]) => {
    const key = make("button", { type: "button", title: `Save ${what} as ${name}`, "aria-label": `Save ${what} as ${name}`, "data-format": name });
    key.addEventListener("click", (event) => {
      event.stopPropagation();
      act();
    });
    return key;
  });
  return make("div", { className: "save" }, ...keys);
}
