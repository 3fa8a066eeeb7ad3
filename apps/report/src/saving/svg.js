import { make } from "../elements.js";
import { fileStem, makeSaveKeys, pageStem, saveText } from "./files.js";
import { escapeXml, readColour, Recorder } from "./recorder.js";

const margin = 10;
const rowHeight = 18;
const letter = 6.3; // of its width, in pixels
const family = "'DejaVu Sans', Verdana, Arial, Helvetica, sans-serif";
const round = (number) => Math.round(10 * number) / 10;
const ink = "#1d2128";
const grey = "#5d6675";

// A chart as a file of its own: in the colours of the light page on white, its title and its keys above it. `draw` draws on the
// canvas again; what stands above is read from the page, from `section`.
export function writeSvg({ canvas, draw, title, section, across = "" }) {
  return inLightColours(draw, () => {
    const context = canvas.getContext("2d");
    const recorder = new Recorder(context);
    recorder.during(draw);
    const ratio = canvas.width / (canvas.clientWidth || canvas.width);
    const [width, height] = [canvas.width / ratio, canvas.height / ratio];
    const above = [...writeTitle(title, width), ...writeRows(readKeys(section), width), ...writeBar(section, width)];
    const top = above.reduce((sum, row) => sum + row.height, margin);
    let at = margin;
    const rows = above.map(({ text, height: used }) => {
      at += used;
      return `<g transform="translate(0 ${at - 5})">${text}</g>`;
    });
    const below = across ? rowHeight : 0;
    const size = [Math.ceil(width + 2 * margin), Math.ceil(top + height + below + margin)];
    return [
      '<?xml version="1.0" encoding="UTF-8"?>',
      `<svg xmlns="http://www.w3.org/2000/svg" width="${size[0]}" height="${size[1]}" viewBox="0 0 ${size.join(" ")}" font-family="${family}" font-size="12">`,
      `<title>${escapeXml(title)}</title>`,
      `<rect width="100%" height="100%" fill="#ffffff"/>`,
      `<defs>${recorder.definitions.join("")}</defs>`,
      ...rows,
      `<g transform="translate(${margin} ${top}) scale(${1 / ratio})">`,
      ...recorder.elements,
      "</g>",
      across ? `<text x="${round(margin + 0.5 * width)}" y="${round(top + height + 12)}" text-anchor="middle" fill="${grey}">${escapeXml(across)}</text>` : "",
      "</svg>",
      "",
    ].join("\n");
  });
}

// The page is in light colours while `work` works; it is drawn in its own again before it is seen.
function inLightColours(draw, work) {
  const { dataset } = document.documentElement;
  const { theme } = dataset;
  dataset.theme = "light";
  try {
    return work();
  } finally {
    dataset.theme = theme;
    draw();
  }
}

function writeTitle(title, width) {
  const most = Math.max(20, Math.floor(width / (1.15 * letter)));
  const lines = [];
  for (const word of title.split(" ")) {
    if (lines.length > 0 && lines.at(-1).length + word.length < most) lines[lines.length - 1] += ` ${word}`;
    else lines.push(word);
  }
  return lines.map((line) => ({ height: rowHeight, text: `<text x="${margin}" y="0" font-weight="bold" fill="${ink}">${escapeXml(line)}</text>` }));
}

// Keys that are shown: their colours, and their words without the value at the time of the page.
function readKeys(section) {
  return [...section.querySelectorAll(".keys .key, .keys .keys-title")].filter((key) => key.getAttribute("aria-pressed") !== "false").map((key) => {
    const mark = key.querySelector("i");
    const style = mark && getComputedStyle(mark);
    const dash = key.classList.contains("unstable");
    const words = [...key.childNodes].filter((node) => node !== mark && !node.classList?.contains("value")).map((node) => node.textContent).join("").trim();
    const value = key.querySelector(".value")?.textContent ?? "";
    const says = words || value || "";
    // The slope of a line is of the line, not of the time.
    const text = value.startsWith("slope") && words ? `${words}, ${value}` : says;
    return { text, colour: style ? readColour(style.backgroundColor)[0] : null, dash, opacity: style?.opacity ?? "1", height: parseFloat(style?.height ?? "3") };
  });
}

function writeRows(keys, width) {
  const rows = [[]];
  let left = 0;
  for (const key of keys) {
    const wide = (key.colour ? 20 : 0) + letter * key.text.length + 14;
    if (left + wide > width && rows.at(-1).length > 0) {
      rows.push([]);
      left = 0;
    }
    rows.at(-1).push({ ...key, left });
    left += wide;
  }
  return rows.filter((row) => row.length > 0).map((row) => ({ height: rowHeight, text: row.map(writeKey).join("") }));
}

function writeKey({ text, colour, dash, opacity, height, left }) {
  const x = round(margin + left);
  const words = `<text x="${x + (colour ? 20 : 0)}" y="0" font-size="11" fill="${colour ? ink : grey}">${escapeXml(text)}</text>`;
  if (!colour) return words;
  if (height > 5) return `<rect x="${x}" y="-9" width="14" height="${height}" fill="${colour}" fill-opacity="${opacity}"/>${words}`;
  const colourOfLine = dash ? grey : colour;
  return `<path d="M${x} -4h15" stroke="${colourOfLine}" stroke-width="2"${dash ? ' stroke-dasharray="4 2.5"' : ""}/>${words}`;
}

// A bar of colours with its ticks, if there is one next to the chart.
function writeBar(section, width) {
  const bar = section.querySelector(".section-bar, #bar:not([hidden]) #bar-colours");
  const stops = bar ? bar.style.background.match(/rgb\([^)]*\)/g) : null;
  if (!stops) return [];
  const ticks = [...bar.nextElementSibling.children].map((tick) => tick.textContent);
  const name = section.querySelector("#bar-text")?.textContent ?? "";
  const long = Math.min(240, width - 20);
  const colours = stops.map((stop, i) => `<stop offset="${i / (stops.length - 1)}" stop-color="${readColour(stop)[0]}"/>`).join("");
  const labels = ticks.map((tick, i) => {
    const part = ticks.length > 1 ? i / (ticks.length - 1) : 0;
    return `<text x="${round(margin + part * long)}" y="2" font-size="11" text-anchor="${["start", "middle", "end"][Math.round(2 * part)]}" fill="${ink}">${escapeXml(tick)}</text>`;
  });
  const words = name ? [{ height: rowHeight, text: `<text x="${margin}" y="0" font-size="11" fill="${grey}">${escapeXml(name)}</text>` }] : [];
  const gradient = `<linearGradient id="bar">${colours}</linearGradient><rect x="${margin}" y="-18" width="${long}" height="9" fill="url(#bar)"/>`;
  return [...words, { height: rowHeight + 14, text: gradient + labels.join("") }];
}

// A button that saves a chart: `read` gives { canvas, draw, title } or null if nothing is drawn yet.
export function makeSvgKey(section, read) {
  return makeSaveKeys({
    SVG: () => {
      const chart = read();
      if (chart) saveText(`${fileStem(pageStem(), chart.title)}.svg`, "image/svg+xml", writeSvg({ ...chart, section: chart.section ?? section() }));
    },
  }, "the chart");
}

// Of a chart that uPlot draws: `plot` gives it. Put into its section, whose heading and keys go with it; `across` names its horizontal
// axis where the chart does not.
export function addSvgKey(section, plot, { titleOf = () => "", across = "" } = {}) {
  const read = () => {
    const chart = plot();
    if (!chart) return null;
    return { canvas: chart.ctx.canvas, draw: () => chart.batch(() => chart.redraw(true, true)), title: titleOf() || readTitle(section), across };
  };
  section.prepend(makeSvgKey(() => section, read));
}

// One of several figures that share a section and its keys, with a button of its own.
export function withSvgKey(body, plot, keys, title) {
  const read = () => plot.plot && { canvas: plot.plot.ctx.canvas, draw: () => plot.plot.batch(() => plot.plot.redraw(true, true)), title };
  return make("div", {}, makeSvgKey(() => keys.parentElement, read), body);
}

// What the headings of a section and its menus say.
function readTitle(section) {
  const heading = section.querySelector("h2, h3");
  const words = heading ? [...heading.childNodes].map((node) => node.textContent.trim()) : [];
  const chosen = [...section.querySelectorAll(".along-choices select:not([hidden])")].map((menu) => menu.selectedOptions[0]?.textContent ?? "");
  const notes = [...section.querySelectorAll(".along-choices small")].map((note) => note.textContent);
  return [words.filter(Boolean).join(", "), section.classList.contains("along") ? [...chosen, ...notes].filter(Boolean).join(", ") : ""].filter(Boolean).join(": ");
}
