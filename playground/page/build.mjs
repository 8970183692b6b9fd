// Bundles the page into one HTML file: `node build.mjs OUT [--check]`.

import { build } from "esbuild";
import { readFile, writeFile } from "node:fs/promises";
import { gzipSync } from "node:zlib";
import { slimThree } from "./slim.mjs";

const out = process.argv[2] ?? "dist/page.html";

const options = {
  bundle: true,
  minify: true,
  write: false,
  format: "iife",
  target: "es2022",
  legalComments: "none",
  logLevel: "warning",
  define: { "import.meta.url": '""' },
};

/** The worker as text in the page's bundle. */
const worker = {
  name: "worker",
  setup(of) {
    of.onResolve({ filter: /^worker:code$/ }, () => ({ path: "worker", namespace: "worker" }));
    of.onLoad({ filter: /.*/, namespace: "worker" }, async () => {
      const made = await build({ ...options, entryPoints: ["src/worker.ts"] });
      return { contents: made.outputFiles[0].text, loader: "text" };
    });
  },
};

const [made, style, template, packed] = await Promise.all([
  build({ ...options, entryPoints: ["src/main.ts"], plugins: [worker, slimThree] }),
  build({ ...options, format: undefined, entryPoints: ["style.css"] }),
  readFile("index.html", "utf8"),
  readFile("pkg/denhart_page.wasm.gz"),
]);
const parts = {
  "/*STYLE*/": style.outputFiles[0].text.trim(),
  "/*WASM*/": packed.toString("base64"),
  "/*SCRIPT*/": made.outputFiles[0].text.trim(),
};
let html = template.replaceAll(/^ +/gm, "");
for (const [mark, text] of Object.entries(parts)) html = html.replace(mark, () => text);
await writeFile(out, html);
const kB = (bytes) => `${Math.ceil(bytes / 1000)} kB`;
console.log(`script ${kB(gzipSync(parts["/*SCRIPT*/"]).length)} gzip, wasm ${kB(packed.length)} gzip, page ${kB(gzipSync(html, { level: 9 }).length)} gzip (${kB(html.length)})`);
