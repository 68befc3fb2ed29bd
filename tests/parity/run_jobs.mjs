// SPDX-License-Identifier: BSD-3-Clause
// usage: run_jobs.mjs PACKAGE <JOBS >RESULTS
// A job is a line of JSON, {"tool", "args", "folder"}; so is its result: exit code and sums of both outputs.
import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import readline from "node:readline";

const folder = path.resolve(process.argv[2]);
const { Host } = await import(path.join(folder, "host.mjs"));
const { NodeFiles, ownBytes } = await import(path.join(folder, "node_files.mjs"));
const module = new WebAssembly.Module(fs.readFileSync(path.join(folder, "smurf.wasm")));

class Recorded extends NodeFiles {
  outputs = { 1: createHash("sha256"), 2: createHash("sha256") };
  write(fd, bytes, position) {
    if (fd > 2) return super.write(fd, bytes, position);
    this.outputs[fd].update(bytes);
    return bytes.length;
  }
  isTerminal() { return false; }
}

for await (const line of readline.createInterface({ input: process.stdin })) {
  const job = JSON.parse(line);
  process.chdir(job.folder);
  const files = new Recorded();
  const host = new Host(files, [job.tool, ...job.args].map(ownBytes), { NO_COLOR: "1" });
  const code = host.run(module);
  console.log(JSON.stringify([code, files.outputs[1].digest("hex"), files.outputs[2].digest("hex")]));
}
