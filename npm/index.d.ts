/**
 * The tools of SMURF for files in memory, in node and browsers. They read nothing from the machine or the network
 * except `smurf.wasm`, once.
 */

/** The contents of files by path, relative to one folder. Binary files, such as meshes, are bytes. */
export type Files = Record<string, string | Uint8Array | ArrayBuffer>;

export type Tool = "smurf-lint" | "smurf2urdf" | "urdf2smurf" | "smurfs-flatten";

export interface Result {
  /** 0: success; 1: findings, or refused because of findings; 2: failure. */
  code: number;
  stdout: string;
  stderr: string;
  /** The written files. */
  files: Record<string, Uint8Array>;
}

/**
 * Loads `smurf.wasm` in advance, or from another source: a URL, its bytes or a compiled module. Without this call, the
 * file in this package is loaded when it is first needed.
 */
export function load(source?: string | URL | Uint8Array | ArrayBuffer | WebAssembly.Module): Promise<WebAssembly.Module>;

/** Runs a tool with the options of its command. `input` is its standard input. */
export function run(tool: Tool, args: string[], files: Files, input?: string | Uint8Array): Promise<Result>;

export interface Options {
  /** Further options of the command, such as `"--target=gazebo,mujoco"`. */
  args?: string[];
}

export interface XacroOptions extends Options {
  /** The arguments of a xacro file, such as `{ ur_type: "ur5e" }`. */
  xacro?: Record<string, string | number | boolean>;
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

/** Whether a program loads the files (takes), loads them with losses (loses) or fails to load them (refuses). */
export type Verdict = "takes" | "loses" | "unknown" | "refuses";

/** What becomes of the files in one program: the verdict, and the numbers of findings behind it. */
export interface Target {
  verdict: Verdict;
  refusals: number;
  unknown: number;
  losses: number;
  ignored: number;
  in_baseline: number;
  unknown_rules?: string[];
  /** Of the later releases of the program, when a finding depends on the version. */
  later_releases?: Record<string, Verdict>;
  /** The first finding with the worst effect. */
  first?: Place & { id: string; effect: "changes" | "loses" | "breaks" | "refuses" | "crashes"; makes: string; source: string };
}

/** The report that `schemas/lint-report.schema.json` describes. */
export interface LintReport {
  schema_version: string;
  tool: { name: string; version: string };
  summary: { error: number; warning: number; info: number; suppressed: number; files: number; models: number; scenes: number; links?: number; companions?: Record<string, number> };
  diagnostics: Diagnostic[];
  /** With `--target`: what becomes of the files in each program, by its name. */
  targets?: Record<string, Target>;
}

/** The scene that `schemas/flat-scene.schema.json` describes. */
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

/** A tool refused its input or failed. The message is that of the tool. */
export class ToolError extends Error {
  result: Result;
}

/** Checks all models, scenes and URDFs, or only those at `paths`. Without any, the report is empty. */
export function lint(files: Files, options?: XacroOptions & { paths?: string[] }): Promise<LintReport>;

/**
 * The files with the safe fixes of a report on them, or with all fixes. Texts stay texts, and bytes bytes. A fix that
 * overlaps another one is left out: check the result and apply its fixes, until there are none.
 */
export function applyFixes(files: Files, report: LintReport, options?: { unsafe?: boolean }): Files;

/** Expands a scene and its nested scenes into world poses. For other formats, see `run`. */
export function flatten(files: Files, scene: string, options?: XacroOptions): Promise<FlatScene>;

/** The plain URDF of a model or a xacro file. */
export function toUrdf(files: Files, model: string, options?: XacroOptions): Promise<string>;

/** Converts a URDF to a SMURF model in `folder`, and returns its files. */
export function toSmurf(files: Files, urdf: string, options?: Options & { folder?: string }): Promise<Record<string, Uint8Array>>;
