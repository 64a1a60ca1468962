// SPDX-License-Identifier: MIT
// Makes pycnc/report/page.js, page.css and page.sha256 of the sources here and of three and uPlot.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const here = new URL("./", import.meta.url);
const there = new URL("../pycnc/report/", here);
const read = (name) => readFileSync(new URL(name, here), "utf8");
const sha256 = (text) => createHash("sha256").update(text).digest("hex");

// Everything that the bundle is made of, in the order of the names.
const sources = ["../pycnc/report/palette.json", "bundle.mjs", "package-lock.json", "package.json",
  ...readdirSync(new URL("src/", here)).sort().map((name) => `src/${name}`)];

function licence(name) {
  const { version } = JSON.parse(read(`node_modules/${name}/package.json`));
  return `${name} ${version}\n\n${read(`node_modules/${name}/LICENSE`).trim()}`;
}

const head = [
  "pycnc report page. SPDX-License-Identifier: MIT. Made by page/bundle.mjs; do not edit.",
  "In it:", licence("three"), licence("uplot"),
].join("\n\n");
const made = await build({
  entryPoints: [new URL("src/main.js", here).pathname],
  bundle: true, minify: true, format: "iife", target: "es2022", charset: "ascii",
  legalComments: "none", write: false, outdir: "out",
});
const script = `/*!\n${head.replaceAll("*/", "* /")}\n*/\n`
  + made.outputFiles.find((file) => file.path.endsWith(".js")).text;
const style = made.outputFiles.find((file) => file.path.endsWith(".css")).text;
if (/<\/?script|<!--/i.test(script) || /<\/?style/i.test(style)) {
  throw new Error("the bundle would end its own element");
}
writeFileSync(new URL("page.js", there), script);
writeFileSync(new URL("page.css", there), style);
const hashes = {
  "page.js": sha256(script), "page.css": sha256(style),
  sources: sha256(sources.map((name) => `${name} ${sha256(read(name))}\n`).join("")),
};
writeFileSync(new URL("page.sha256", there),
  Object.entries(hashes).map(([name, hash]) => `${hash}  ${name}\n`).join(""));
console.log(`page.js ${script.length} bytes, page.css ${style.length} bytes`);
