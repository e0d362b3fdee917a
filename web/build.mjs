// Bundles the page into a folder, by default the committed one: the same sources and lock file give the same bytes.
import { copyFile, mkdir, readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const [, , folder = new URL("../crates/studio/dist/", import.meta.url).pathname] = process.argv;
const dist = folder.endsWith("/") ? folder : `${folder}/`;
await mkdir(dist, { recursive: true });
await build({
  absWorkingDir: new URL(".", import.meta.url).pathname,
  entryPoints: { studio: "src/main.tsx" },
  outdir: dist,
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  jsx: "automatic",
  jsxImportSource: "preact",
  charset: "utf8",
  legalComments: "eof",
  logLevel: "warning",
});
await copyFile(new URL("src/index.html", import.meta.url), `${dist}index.html`);

// What the licences of the bundled packages require to be passed on.
const here = (path) => new URL(path, import.meta.url);
const { dependencies } = JSON.parse(await readFile(here("package.json"), "utf8"));
const licenses = Object.entries(dependencies).map(async ([name, version]) => {
  const text = await readFile(here(`node_modules/${name}/LICENSE`), "utf8");
  return `${name} ${version}\n\n${text.trim()}\n`;
});
await writeFile(`${dist}licenses.txt`, (await Promise.all(licenses)).join("\n----\n\n"));
