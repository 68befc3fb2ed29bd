// SPDX-License-Identifier: BSD-3-Clause
// Reads OpenUSD files with tinyusdz, which checks the types of all attributes that it knows:
// usd_parse.mjs NODE_MODULES FILE... Ends with 1, and says why, when one is not read.
import fs from "node:fs";

const [modules, ...files] = process.argv.slice(2);
const folder = `${modules}/tinyusdz`;

// The package was built for browsers only.
globalThis.window = globalThis;
const script = fs.readFileSync(`${folder}/tinyusdz.js`, "utf8")
  .replace(/var ENVIRONMENT_IS_NODE=[^;]*;/, "var ENVIRONMENT_IS_NODE=false;");
const { default: load } = await import(`data:text/javascript;base64,${btoa(unescape(encodeURIComponent(script)))}`);
const usd = await load({
  locateFile: (name) => name,
  wasmBinary: fs.readFileSync(`${folder}/tinyusdz.wasm`),
});
for (const file of files) {
  const loader = new usd.TinyUSDZLoaderNative();
  if (!loader.loadFromBinary(new Uint8Array(fs.readFileSync(file)), file)) {
    console.error(`${file}: ${loader.error()}`);
    process.exitCode = 1;
  }
}
