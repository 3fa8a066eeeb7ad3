// Bundles the page of `gxrod report` into dist/page.html, which is committed and put into the program: npm ci && npm run build.
//
// The page carries the digest of what it was built from; tests/house/report_page_test.py compares it, without Node.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";

const here = (name) => new URL(name, import.meta.url);
const read = (name) => readFileSync(here(name), "utf8");

// SHA-256 over the name and the content of each source, in the order of their names.
function digestSources() {
  const sources = ["build.js", "package-lock.json", "package.json", ...readdirSync(here("src")).map((name) => `src/${name}`)];
  const hash = createHash("sha256");
  for (const name of sources.sort()) hash.update(`${name}\n${read(name)}\n`);
  return hash.digest("hex");
}

async function bundle() {
  const result = await build({
    entryPoints: [here("src/main.js").pathname],
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

async function minifyStyle() {
  const style = read("node_modules/uplot/dist/uPlot.min.css") + read("src/style.css");
  const result = await build({ stdin: { contents: style, loader: "css" }, minify: true, write: false });
  return result.outputFiles[0].text.trim();
}

function licences() {
  const of = (name) => {
    const { version } = JSON.parse(read(`node_modules/${name}/package.json`));
    return `${name} ${version}\n\n${read(`node_modules/${name}/LICENSE`).trim()}`;
  };
  return `${of("three")}\n\n\n${of("uplot")}`;
}

const hashOf = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

const script = await bundle();
const style = await minifyStyle();
const policy = `default-src 'none'; script-src ${hashOf(script)}; style-src ${hashOf(style)}; img-src data:; base-uri 'none'; form-action 'none'`;
const page = `<!doctype html>
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
${read("src/page.html").trim()}
<script type="text/plain" id="licences">${licences()}</script>
<!-- data -->
<script>${script}</script>
</body>
</html>
`;
mkdirSync(here("dist"), { recursive: true });
writeFileSync(here("dist/page.html"), page);
console.log(`dist/page.html: ${page.length} characters`);
