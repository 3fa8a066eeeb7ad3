// Bundles the pages of `gxrod report` into dist, which is committed and put into the program: npm ci && npm run build.
//
// Each page carries the digest of what it was built from; tests/house/report_page_test.py compares it, without Node.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";

const here = (name) => new URL(name, import.meta.url);
const read = (name) => readFileSync(here(name), "utf8");

// The page of a run, that of a batch, and that of `gxrod verify DECK`.
const pages = [
  { name: "page", script: "src/main.js", styles: ["src/style.css"], body: "src/page.html", libraries: ["three", "uplot"] },
  { name: "batch", script: "src/batch/main.js", styles: ["src/style.css", "src/batch/style.css"], body: "src/batch/page.html", libraries: ["uplot"] },
  { name: "study", script: "src/study/main.js", styles: ["src/style.css", "src/study/style.css"], body: "src/study/page.html", libraries: ["uplot"] },
];

function listFiles(folder) {
  const below = (entry) => `${folder}/${entry.name}`;
  return readdirSync(here(folder), { withFileTypes: true }).flatMap((entry) => (entry.isDirectory() ? listFiles(below(entry)) : [below(entry)]));
}

// SHA-256 over the name and the content of each source, in the order of their names.
function digestSources() {
  const sources = ["build.js", "package-lock.json", "package.json", ...listFiles("src")];
  const hash = createHash("sha256");
  for (const name of sources.sort()) hash.update(`${name}\n${read(name)}\n`);
  return hash.digest("hex");
}

async function bundle(script) {
  const result = await build({
    entryPoints: [here(script).pathname],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["chrome111", "firefox113", "safari16.4"],
    charset: "ascii",
    legalComments: "none",
  });
  // Nothing in a script may look like its end.
  return result.outputFiles[0].text.trim().replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
}

async function minifyStyles(styles) {
  const style = read("node_modules/uplot/dist/uPlot.min.css") + styles.map(read).join("");
  const result = await build({ stdin: { contents: style, loader: "css" }, minify: true, write: false });
  return result.outputFiles[0].text.trim();
}

function licences(libraries) {
  const of = (name) => {
    const { version } = JSON.parse(read(`node_modules/${name}/package.json`));
    return `${name} ${version}\n\n${read(`node_modules/${name}/LICENSE`).trim()}`;
  };
  return libraries.map(of).join("\n\n\n");
}

const hashOf = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

async function write(page) {
  const script = await bundle(page.script);
  const style = await minifyStyles(page.styles);
  const policy = `default-src 'none'; script-src ${hashOf(script)}; style-src ${hashOf(style)}; img-src data:; base-uri 'none'; form-action 'none'`;
  const text = `<!doctype html>
<!-- Written by gxrod report. Built from apps/report, sources sha256:${digestSources()} -->
<html lang="en" data-theme="auto">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>gxrod report</title>
<style>${style}</style>
</head>
<body>
<noscript>This page needs JavaScript; it loads nothing from elsewhere.</noscript>
${read(page.body).trim()}
<script type="text/plain" id="licences">${licences(page.libraries)}</script>
<!-- data -->
<script>${script}</script>
</body>
</html>
`;
  writeFileSync(here(`dist/${page.name}.html`), text);
  console.log(`dist/${page.name}.html: ${text.length} characters`);
}

mkdirSync(here("dist"), { recursive: true });
for (const page of pages) await write(page);
