// SPDX-License-Identifier: BSD-3-Clause
// The files of a robot, with their earlier versions.
import { fromBase64, bytesOf, textOf, toBase64 } from "./bytes.js";

/** Of a robot, whether it comes from a folder, a zip file or an address. */
export const kMostFiles = 5000;
const kMostSteps = 200; // most steps that can be undone

export const kindOf = (name) => name.match(/\.(smurfs?|smurfa|zsmurfs?|urdf|xacro)$/i)?.[1].toLowerCase();

/** The path of a file relative to the folder of the robot. Throws if it leads out of the folder. */
export function cleaned(path) {
  const parts = path.split("/").filter((part) => part !== "" && part !== ".");
  if (parts.includes("..") || path.includes("\0")) throw new Error(`'${path}' is outside of the folder`);
  return parts.join("/");
}

/** Files for JSON: texts as strings, other files as {base64}. */
export const toJson = (files) =>
  Object.fromEntries([...files].map(([name, bytes]) => [name, textOf(bytes) ?? { base64: toBase64(bytes) }]));

export function fromJson(json) {
  const files = Object.entries(json).map(([name, content]) => {
    const bytes = typeof content === "string" ? bytesOf(content) : fromBase64(content.base64);
    return [cleaned(name), bytes];
  });
  return new Map(files);
}

/** `edits`: [{file, begin, end, text}], where `begin` and `end` count bytes. */
export function edited(files, edits) {
  const result = new Map(files);
  for (const { file, begin, end, text } of [...edits].sort((a, b) => b.begin - a.begin)) {
    const bytes = result.get(file);
    const fresh = bytesOf(text);
    const all = new Uint8Array(begin + fresh.length + bytes.length - end);
    all.set(bytes.subarray(0, begin));
    all.set(fresh, begin);
    all.set(bytes.subarray(end), begin + fresh.length);
    result.set(file, all);
  }
  return result;
}

export class Files {
  #steps = [];
  #last;

  constructor(onChange) {
    this.onChange = onChange;
    this.all = new Map();
  }

  get canUndo() {
    return this.#steps.length > 0;
  }

  /** Changes with the same `step`, such as letters typed into one file, are undone together. */
  change(all, step = {}) {
    if (step !== this.#last) this.#steps.push(this.all);
    if (this.#steps.length > kMostSteps) this.#steps.shift();
    this.#last = step;
    this.all = all;
    this.onChange();
  }

  set(name, bytes, step) {
    this.change(new Map(this.all).set(name, bytes), step);
  }

  undo() {
    this.all = this.#steps.pop() ?? this.all;
    this.#last = undefined;
    this.onChange();
  }

  /** `name`, or a similar name that no file and no folder has. */
  freeName(name) {
    const dot = name.lastIndexOf(".");
    const [stem, end] = dot > 0 ? [name.slice(0, dot), name.slice(dot)] : [name, ""];
    const isTaken = (one) => [...this.all.keys()].some((path) => path === one || path.startsWith(`${one}/`));
    for (let number = 2; isTaken(name); ++number) name = `${stem}_${number}${end}`;
    return name;
  }
}
