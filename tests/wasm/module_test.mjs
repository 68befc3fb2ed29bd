// SPDX-License-Identifier: BSD-3-Clause
// The package as a library, from where it is installed. usage: node module_test.mjs FIXTURES NATIVE_TOOLS
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import test from "node:test";

import { ToolError, applyFixes, flatten, lint, load, run, toSmurf, toUrdf } from "smurf-tools";

const [fixtures, tools] = process.argv.slice(2);

function filesIn(folder) {
  const files = {};
  for (const entry of fs.readdirSync(folder, { withFileTypes: true, recursive: true })) {
    const place = path.join(entry.parentPath ?? entry.path, entry.name);
    if (entry.isFile()) files[path.relative(folder, place)] = new Uint8Array(fs.readFileSync(place));
  }
  return files;
}

function native(tool, args, folder) {
  return spawnSync(path.join(tools, tool), args, { cwd: folder, encoding: "utf8" });
}

const arm = path.join(fixtures, "models/arm");
const nested = path.join(fixtures, "scenes/nested");

test("lint reports what the command reports", async () => {
  const files = filesIn(arm);
  const motors = "smurf/arm_motors.yml";
  const broken = new TextDecoder().decode(files[motors]).replace("joint: joint2_shoulder", "joint: joint2_sholder");
  const report = await lint({ ...files, [motors]: broken });
  assert.deepEqual(report.diagnostics.map((one) => one.id), ["SML3101"]);
  assert.equal(report.diagnostics[0].file, motors);
  const copy = fs.mkdtempSync(path.join(process.cwd(), "arm-"));
  fs.cpSync(arm, copy, { recursive: true });
  fs.writeFileSync(path.join(copy, motors), broken);
  assert.deepEqual(report, JSON.parse(native("smurf-lint", ["--format=json", "."], copy).stdout));
});

test("lint has the options of the command, and says what is wrong with them", async () => {
  const report = await lint(filesIn(arm), { args: ["--target=mujoco"], paths: ["urdf"] });
  assert.equal(report.summary.models, 1);
  await assert.rejects(lint({}, { args: ["--no-such-option"] }), (error) => {
    assert.ok(error instanceof ToolError);
    assert.equal(error.result.code, 2);
    assert.match(error.message, /--no-such-option/);
    return true;
  });
  await assert.rejects(lint({ "a.urdf": 7 }), TypeError);
  await assert.rejects(lint({ a: "", "a/b": "" }), TypeError);
});

test("files without a robot have no findings, and wrong calls say what is wrong", async () => {
  for (const files of [{}, { "a.txt": "x" }]) {
    const report = await lint(files);
    assert.deepEqual(report.diagnostics, []);
    assert.equal(report.summary.models, 0);
  }
  await assert.rejects(lint({}, { paths: ["nothing.urdf"] }), ToolError);
  for (const name of ["/a.urdf", "../a.urdf", "a/../../b.urdf", "."]) {
    await assert.rejects(lint({ [name]: "<robot/>" }), (error) => error instanceof TypeError && error.message.includes(`'${name}'`));
  }
  await assert.rejects(run("smurf-diff", [], {}), /there is no tool 'smurf-diff' in this package; there are smurf-lint/);
});

test("odd arguments are refused, and change nothing elsewhere", async () => {
  const urdf = '<robot name="r"><link name="a"/></robot>';
  const files = { "r.urdf": urdf };
  const wrong = [
    () => lint(new Map([["r.urdf", urdf]])), () => lint([urdf]), () => lint("r.urdf"),
    () => lint(files, { paths: "r.urdf" }), () => lint(files, { args: "--target=mujoco" }),
    () => lint(files, { args: ["--target=mujoco\0"] }), () => lint({ "r.urdf\0": urdf }),
    () => lint({ "r.urdf": urdf, "./r.urdf": urdf }), () => lint({ ["x".repeat(300)]: urdf }),
    () => lint({ ["d/".repeat(3000) + "r.urdf"]: urdf }), () => lint(files, { args: ["--help"] }),
    () => run("smurf-lint", "--version", {}), () => run("constructor", [], {}), () => flatten(files),
  ];
  for (const call of wrong) await assert.rejects(call, TypeError, String(call));
  const edit = (file, begin, end) =>
    ({ diagnostics: [{ fix: { applicability: "safe", edits: [{ file, begin, end, text: "x" }] } }] });
  const misplaced = [["toString", 0, 0], ["__proto__", 0, 0], ["r.urdf", -1, 0], ["r.urdf", 2, 1], ["r.urdf", 0, 99]];
  for (const [file, begin, end] of misplaced) {
    assert.throws(() => applyFixes(files, edit(file, begin, end)), TypeError);
  }
  const own = applyFixes(JSON.parse('{"__proto__": "hello"}'), edit("__proto__", 0, 1));
  assert.deepEqual(Object.entries(own), [["__proto__", "xello"]]);
  assert.deepEqual(Object.keys(Object.prototype), []);
});

test("nothing is written outside of the files, where it would be lost", async () => {
  const files = { "r.urdf": '<robot name="r"><link name="a"/></robot>' };
  for (const folder of ["..", "../x", "/x"]) await assert.rejects(toSmurf(files, "r.urdf", { folder }), ToolError);
  const written = await toSmurf(files, "r.urdf", { folder: "a/../b" });
  assert.deepEqual(Object.keys(written).sort(), ["b/smurf/r.smurf", "b/urdf/r.urdf"]);
});

test("a module that cannot be loaded does not replace a later one", async () => {
  const good = await load();
  const bad = assert.rejects(load(new Uint8Array([1])));
  const later = load(good);
  await bad;
  assert.equal(await load(), await later);
});

test("fixes are those of smurf-lint --fix", async () => {
  const urdf = '<robot name="räder">\n<link name="a"/><link name="b"/>\n<joint name="j" type="fixed"><axis xyz="0 0 1"/>' +
    '<parent link="a"/><child link="b"/></joint></robot>\n';
  const files = { "r.urdf": urdf, "s.urdf": new TextEncoder().encode(urdf), "t.txt": "t" };
  const all = { unsafe: true };
  const fixed = applyFixes(files, await lint(files), all);
  assert.equal(fixed["r.urdf"], urdf.replace('<axis xyz="0 0 1"/>', ""));
  assert.deepEqual(fixed["s.urdf"], new TextEncoder().encode(fixed["r.urdf"]));
  assert.equal(files["r.urdf"], urdf);
  assert.deepEqual(applyFixes(fixed, await lint(fixed), all), fixed);
  assert.throws(() => applyFixes({}, { diagnostics: [{ fix: { applicability: "safe", edits: [{ file: "x", begin: 0, end: 0, text: "" }] } }] }), TypeError);
});

test("flatten gives the poses of the command", async () => {
  const scene = await flatten(filesIn(nested), "outer.smurfs");
  assert.deepEqual(scene, JSON.parse(native("smurfs-flatten", ["outer.smurfs"], nested).stdout));
});

test("all formats can be written", async () => {
  const listed = native("smurfs-flatten", ["--format", "help"], nested).stdout.toString();
  const formats = [...listed.matchAll(/^ {2}([\w.]+) /gm)].map(([, name]) => name).filter((name) => name !== "html");
  assert.ok(formats.length > 6, listed);  // without pages, which some builds only make
  for (const format of formats) {
    const args = [`--format=${format}`, "outer.smurfs"];
    const result = await run("smurfs-flatten", args, filesIn(nested));
    assert.equal(result.code, 0, result.stderr);
    assert.equal(result.stdout, native("smurfs-flatten", args, nested).stdout);
  }
});

test("a model and its URDF are made of each other", async () => {
  const urdf = await toUrdf(filesIn(arm), "smurf/arm.smurf");
  assert.equal(urdf, native("smurf2urdf", ["smurf/arm.smurf"], arm).stdout);
  const made = await toSmurf(filesIn(arm), "urdf/arm.urdf", { folder: "new" });
  assert.ok(Object.keys(made).includes("new/smurf/arm.smurf"), Object.keys(made).join(" "));
  await assert.rejects(toUrdf({ "a.urdf": "<robot" }, "a.urdf"), ToolError);
});

test("xacro files take arguments", async () => {
  const files = { "a.urdf.xacro": `<robot name="r" xmlns:xacro="x"><xacro:arg name="link" default="a"/><link name="$(arg link)"/>
<link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>` };
  assert.match(await toUrdf(files, "a.urdf.xacro", { xacro: { link: "a" } }), /<link name="a"/);
  const report = await lint(files, { paths: ["a.urdf.xacro"], xacro: { link: 7 } });
  assert.ok(report.diagnostics.some((one) => one.severity === "error"), JSON.stringify(report));
});

test("files are written, and standard input is read", async () => {
  const text = fs.readFileSync(path.join(arm, "urdf/arm.urdf"), "utf8");
  const result = await run("smurf-lint", ["-", "--format=json=report.json"], {}, text);
  assert.deepEqual(Object.keys(result.files), ["report.json"]);
  assert.equal(JSON.parse(new TextDecoder().decode(result.files["report.json"])).summary.models, 1);
});

test("the module can come from elsewhere, and what is none is refused", async () => {
  const place = import.meta.resolve("smurf-tools/smurf.wasm");
  const module = await load(fs.readFileSync(new URL(place)));
  assert.equal(await load(module), module);
  await assert.rejects(load(new Uint8Array(4)), WebAssembly.CompileError);
  assert.ok((await load()) instanceof WebAssembly.Module);
});

test("the module asks for calls of a system only", async () => {
  // The linker makes an import of each function that nothing defines, and says nothing.
  const asked = WebAssembly.Module.imports(await load()).map((one) => one.name);
  assert.deepEqual(asked.filter((name) => name.startsWith("_Z")), []);
});
