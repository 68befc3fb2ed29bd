// SPDX-License-Identifier: BSD-3-Clause
// Runs the tools on files in memory, in node and browsers. See index.d.ts.
import { Host } from "./host.mjs";
import { MemoryFiles } from "./memory_files.mjs";

let loaded;

async function compile(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof Uint8Array || source instanceof ArrayBuffer) return WebAssembly.compile(source);
  // Bundlers find the file by these two words, which must stand together.
  const own = source === undefined ? new URL("smurf.wasm", import.meta.url) : undefined;
  const url = own ?? new URL(source, import.meta.url);
  if (url.protocol === "file:") {
    const node = "node:fs/promises"; // a variable: bundlers for browsers look for no file
    const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ node);
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`cannot load ${url}: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

export function load(source) {
  if (source !== undefined || loaded === undefined) {
    loaded = compile(source);
    loaded.catch(() => { loaded = undefined; });
  }
  return loaded;
}

export async function run(tool, args, files, input) {
  const module = await load();
  const memory = new MemoryFiles(files, input);
  const code = new Host(memory, [tool, ...args], {}).run(module);
  const decoder = new TextDecoder();
  return { code, stdout: decoder.decode(memory.output(1)), stderr: decoder.decode(memory.output(2)), files: memory.changes() };
}

/** The exit codes of a run that failed, or that refused its input. */
export class ToolError extends Error {
  constructor(tool, result) {
    super(result.stderr.trim() || `${tool} ended with code ${result.code}`);
    this.name = "ToolError";
    this.result = result;
  }
}

async function runWell(tool, args, files, isGood) {
  const result = await run(tool, args, files);
  if (!isGood(result)) throw new ToolError(tool, result);
  return result;
}

/** The arguments of a xacro file as the tools take them. */
const words = (xacro) => Object.entries(xacro).map(([name, value]) => `${name}:=${value}`);

export async function lint(files, { paths = ["."], args = [], xacro = {} } = {}) {
  // For callers, a folder without models is not an error.
  const operands = ["--", ...paths, ...words(xacro)];
  const result = await runWell("smurf-lint", ["--format=json", ...args, ...operands], files, (one) => one.code < 2);
  return JSON.parse(result.stdout);
}

export async function flatten(files, scene, { args = [], xacro = {} } = {}) {
  const operands = ["--", scene, ...words(xacro)];
  const result = await runWell("smurfs-flatten", ["--format=json", ...args, ...operands], files, (one) => one.code === 0);
  return JSON.parse(result.stdout);
}

export async function toUrdf(files, model, { args = [], xacro = {} } = {}) {
  return (await runWell("smurf2urdf", [...args, "--", model, ...words(xacro)], files, (one) => one.code === 0)).stdout;
}

export async function toSmurf(files, urdf, { folder = ".", args = [] } = {}) {
  const options = [`--output=${folder}`, ...args, "--", urdf];
  return (await runWell("urdf2smurf", options, files, (one) => one.code === 0)).files;
}
