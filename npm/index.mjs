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
    const mine = compile(source);
    loaded = mine;
    mine.catch(() => { if (loaded === mine) loaded = undefined; });  // a later call may have loaded another
  }
  return loaded;
}

const kTools = ["smurf-lint", "smurf2urdf", "urdf2smurf", "smurfs-flatten"];

/** A text would be taken for the list of its characters. */
function checkTexts(what, list) {
  if (!Array.isArray(list)) throw new TypeError(`${what} is not an array of texts`);
  for (const one of list) {
    if (typeof one === "string" && !one.includes("\0")) continue;
    throw new TypeError(`${what} has ${JSON.stringify(one)}, which is not a text without NUL`);
  }
}

export async function run(tool, args, files, input) {
  checkTexts("args", args);
  if (!kTools.includes(tool)) throw new TypeError(`there is no tool '${tool}' in this package; there are ${kTools.join(", ")}`);
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

/** Options such as --help write something else. */
function parsed(tool, result) {
  try {
    return JSON.parse(result.stdout);
  } catch {
    throw new TypeError(`with these args, ${tool} writes no JSON to standard output; call run() for them`);
  }
}

/** The arguments of a xacro file as the tools take them. */
const words = (xacro) => Object.entries(xacro).map(([name, value]) => `${name}:=${value}`);

export async function lint(files, { paths = ["."], args = [], xacro = {} } = {}) {
  checkTexts("paths", paths);
  checkTexts("args", args);
  const operands = ["--", ...paths, ...words(xacro)];
  // For callers, files without a robot are not an error.
  const isEmpty = ({ stderr, stdout }) => /^smurf-lint: no \.smurf/.test(stderr) && stdout !== "" && stderr.trim().split("\n").length === 1;
  const result = await runWell("smurf-lint", ["--format=json", ...args, ...operands], files, (one) => one.code < 2 || isEmpty(one));
  return parsed("smurf-lint", result);
}

const kEncoder = new TextEncoder();
const bytesOf = (content) => (typeof content === "string" ? kEncoder.encode(content) : new Uint8Array(content));

/** The edits of the findings that are applied, by file; a fix that overlaps an earlier one waits for another round. */
function chosenEdits(report, unsafe) {
  const byFile = new Map();
  const overlaps = (edit) =>
    (byFile.get(edit.file) ?? []).some((other) =>
      edit.begin === other.begin || (edit.begin < other.end && other.begin < edit.end));
  for (const { fix } of report.diagnostics) {
    if (!fix || (fix.applicability !== "safe" && !unsafe) || fix.edits.some(overlaps)) continue;
    for (const edit of fix.edits) {
      if (!byFile.has(edit.file)) byFile.set(edit.file, []);
      byFile.get(edit.file).push(edit);
    }
  }
  return byFile;
}

export function applyFixes(files, report, { unsafe = false } = {}) {
  const fixed = new Map(Object.entries(files));
  for (const [file, edits] of chosenEdits(report, unsafe)) {
    if (!fixed.has(file)) throw new TypeError(`the report is about '${file}', which is not among the files`);
    let bytes = bytesOf(files[file]);
    const length = bytes.length;
    const isInside = ({ begin, end }) =>
      Number.isInteger(begin) && Number.isInteger(end) && 0 <= begin && begin <= end && end <= length;
    if (!edits.every(isInside)) throw new TypeError(`the report is about another text of '${file}'`);
    for (const { begin, end, text } of edits.sort((a, b) => b.begin - a.begin)) {
      const written = kEncoder.encode(text);
      const next = new Uint8Array(begin + written.length + bytes.length - end);
      next.set(bytes.subarray(0, begin));
      next.set(written, begin);
      next.set(bytes.subarray(end), begin + written.length);
      bytes = next;
    }
    const isText = typeof files[file] === "string";
    fixed.set(file, isText ? new TextDecoder("utf-8", { ignoreBOM: true }).decode(bytes) : bytes);
  }
  return Object.fromEntries(fixed);
}

export async function flatten(files, scene, { args = [], xacro = {} } = {}) {
  checkTexts("args", args);
  const operands = ["--", scene, ...words(xacro)];
  const result = await runWell("smurfs-flatten", ["--format=json", ...args, ...operands], files, (one) => one.code === 0);
  return parsed("smurfs-flatten", result);
}

export async function toUrdf(files, model, { args = [], xacro = {} } = {}) {
  checkTexts("args", args);
  return (await runWell("smurf2urdf", [...args, "--", model, ...words(xacro)], files, (one) => one.code === 0)).stdout;
}

export async function toSmurf(files, urdf, { folder = ".", args = [] } = {}) {
  checkTexts("args", args);
  const options = [`--output=${folder}`, ...args, "--", urdf];
  return (await runWell("urdf2smurf", options, files, (one) => one.code === 0)).files;
}
