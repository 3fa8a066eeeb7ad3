// Makes libraries/ from npm: npm ci && npm run libraries. Needed only where a script uses a new name of three, or for a new version.
//
// three.js is what src/ imports of three, as a variable `three`; its first line lists the names. uplot.js is as it is published.
import { build } from "esbuild";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";

const here = (name) => new URL(name, import.meta.url);
const read = (name) => readFileSync(here(name), "utf8");
const addons = { OrbitControls: "three/addons/controls/OrbitControls.js" };

function listNames() {
  const scripts = readdirSync(here("src"), { recursive: true }).filter((name) => name.endsWith(".js"));
  const imports = scripts.flatMap((name) => [...read(`src/${name}`).matchAll(/import \{([^}]*)\} from "three"/g)]);
  return [...new Set(imports.flatMap(([, names]) => names.split(",").map((name) => name.trim())))].filter(Boolean).sort();
}

async function bundle(names) {
  const lines = names.map((name) => `export { ${name} } from "${addons[name] ?? "three"}";`);
  const result = await build({
    stdin: { contents: lines.join("\n"), resolveDir: here(".").pathname },
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    globalName: "three",
    target: ["chrome111", "firefox113", "safari16.4"],
    charset: "ascii",
    legalComments: "none",
  });
  return `// ${names.join(", ")}\n${result.outputFiles[0].text}`;
}

// Nothing in a script may look like its end.
const save = (name, text) => writeFileSync(here(`libraries/${name}`), text.trim().replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--") + "\n");

function saveLicence(library) {
  const { version } = JSON.parse(read(`node_modules/${library}/package.json`));
  save(`${library}.txt`, `${library} ${version}\n\n${read(`node_modules/${library}/LICENSE`)}`);
}

mkdirSync(here("libraries"), { recursive: true });
save("three.js", await bundle(listNames()));
save("uplot.js", read("node_modules/uplot/dist/uPlot.iife.min.js"));
save("uplot.css", read("node_modules/uplot/dist/uPlot.min.css"));
for (const library of ["three", "uplot"]) saveLicence(library);
