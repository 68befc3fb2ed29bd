// SPDX-License-Identifier: BSD-3-Clause
// Makes one page of the modules here and three.js. usage: node bundle.mjs NODE_MODULES OUTPUT_FOLDER
import { createHash } from "node:crypto";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";

const [modules, output] = process.argv.slice(2).map((argument) => path.resolve(argument));
const here = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
const { buildSync } = createRequire(`${modules}/`)("esbuild");

function bundle(name, result) {
  buildSync({
    entryPoints: [path.join(here, name)],
    outfile: path.join(output, result),
    nodePaths: [modules],
    bundle: true,
    minify: true,
    charset: "ascii",
    format: "iife",
    target: ["chrome110", "firefox115", "safari16"],
    legalComments: "none", // the licence stands in the page as a whole
  });
  return fs.readFileSync(path.join(output, result), "utf8").trimEnd();
}

/** The page allows these two texts by their sums, and nothing else. */
const sumOf = (text) => `sha256-${createHash("sha256").update(text).digest("base64")}`;

const script = bundle("main.js", "viewer.js");
const style = bundle("style.css", "viewer.css");
const licence = fs.readFileSync(path.join(modules, "three/LICENSE"), "utf8").trim().replace("\u00a9", "(c)");
const data = '<script id="scene" type="application/json">@SCENE@</script>';
const parts = {
  "<!-- @LICENCE@ -->": `<!--\nthree.js, which is part of this page:\n\n${licence}\n-->`,
  "@SCRIPT_HASH@": sumOf(script),
  "@STYLE_HASH@": sumOf(style),
  "<!-- @STYLE@ -->": `<style>${style}</style>`,
  "<!-- @SCRIPT@ -->": `${data}\n<script>${script}</script>`,
};
let page = fs.readFileSync(path.join(here, "index.html"), "utf8");
for (const [name, text] of Object.entries(parts)) page = page.replace(name, () => text);

if (/<\/script|<!--/i.test(script) || /<\/style/i.test(style))
  throw new Error("the script or style ends its own element");
if (/[^\x20-\x7e\n\t]/.test(page))
  throw new Error("the page is not ASCII, as cmake/EmbedPage.cmake wants it");
if (page.split("@SCENE@").length !== 2) throw new Error("the page has not one place for the scene");
fs.writeFileSync(path.join(output, "viewer.html"), page);
