/**
 * The tools of SMURF on files in memory, in node and in browsers. Nothing is read from the machine or the network but
 * `smurf.wasm`, once.
 */

/** Paths, relative to one folder, and what the files contain. Binary files, such as meshes, are bytes. */
export type Files = Record<string, string | Uint8Array | ArrayBuffer>;

export type Tool = "smurf-lint" | "smurf2urdf" | "urdf2smurf" | "smurfs-flatten";

export interface Result {
  /** 0: done; 1: findings, or refused because of them; 2: could not do the job. */
  code: number;
  stdout: string;
  stderr: string;
  /** Files that were written. */
  files: Record<string, Uint8Array>;
}

/**
 * Loads `smurf.wasm` before it is needed, or from another place: an URL, its bytes or a module that is compiled already.
 * Without a call of it, it is loaded from beside this package when it is first needed.
 */
export function load(source?: string | URL | Uint8Array | ArrayBuffer | WebAssembly.Module): Promise<WebAssembly.Module>;

/** Runs a tool as its command does, with all of its options. `input` is its standard input. */
export function run(tool: Tool, args: string[], files: Files, input?: string | Uint8Array): Promise<Result>;

export interface Options {
  /** Further options of the command, such as `"--target=gazebo,mujoco"`. */
  args?: string[];
}

export type Severity = "error" | "warning" | "info";

/** A place in a file. Lines and columns count from 1, columns in characters. */
export interface Place {
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
}

export interface Edit {
  file: string;
  /** Bytes of the file, from 0. */
  begin: number;
  end: number;
  text: string;
}

export interface Diagnostic extends Partial<Place> {
  /** Such as `SML3101`. */
  id: string;
  /** Such as `unknown-joint`. */
  name: string;
  severity: Severity;
  message: string;
  file: string;
  /** A YAML pointer or XPath. */
  pointer?: string;
  help?: string;
  notes?: string[];
  labels?: (Place & { message: string })[];
  fix?: { applicability: "safe" | "unsafe"; edits: Edit[] };
}

/** What `schemas/lint-report.schema.json` describes. */
export interface LintReport {
  schema_version: string;
  tool: { name: string; version: string };
  summary: { error: number; warning: number; info: number; suppressed: number; files: number; models: number; scenes: number };
  diagnostics: Diagnostic[];
}

/** What `schemas/flat-scene.schema.json` describes. */
export interface FlatScene {
  schema_version: string;
  scene: string;
  frame: "world";
  models: { id: string; type: string; file: string; urdf?: string }[];
  instances: {
    name: string;
    path: string;
    type: string;
    model?: string;
    position: [number, number, number];
    orientation: { w: number; x: number; y: number; z: number };
    parent: string;
    [key: string]: unknown;
  }[];
  [key: string]: unknown;
}

/** A tool refused its input, or could not do the job. The message is what it said. */
export class ToolError extends Error {
  result: Result;
}

/** Checks all models, scenes and URDFs, or those at `paths`. */
export function lint(files: Files, options?: Options & { paths?: string[] }): Promise<LintReport>;

/** Expands a scene with all nested scenes into world poses. For other formats see `run`. */
export function flatten(files: Files, scene: string, options?: Options): Promise<FlatScene>;

/** The plain URDF of a model. */
export function toUrdf(files: Files, model: string, options?: Options): Promise<string>;

/** The files of a SMURF model made from a URDF, in `folder`. */
export function toSmurf(files: Files, urdf: string, options?: Options & { folder?: string }): Promise<Record<string, Uint8Array>>;
