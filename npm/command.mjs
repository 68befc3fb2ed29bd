// SPDX-License-Identifier: BSD-3-Clause
// Runs a tool as a command, on the files of the machine.
import { readFileSync } from "node:fs";

import { Host } from "./host.mjs";
import { NodeFiles, ownBytes } from "./node_files.mjs";

export function main(tool) {
  const module = new WebAssembly.Module(readFileSync(new URL("smurf.wasm", import.meta.url)));
  const environment = Object.fromEntries(Object.entries(process.env).map(([name, value]) => [name, ownBytes(value)]));
  const host = new Host(new NodeFiles(), [tool, ...process.argv.slice(2).map(ownBytes)], environment);
  process.exitCode = host.run(module);
}
