// SPDX-License-Identifier: BSD-3-Clause
// Assembles the playground, a folder for any web server. usage: node assemble.mjs PACKAGE OUTPUT
// PACKAGE is the npm package that scripts/wasm makes. The list of targets comes from its module, and the script that
// the content security policy of the page must allow from its viewer.
import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const [packed, output] = process.argv.slice(2).map((folder) => path.resolve(folder));
const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.resolve(here, "../..");
const { run } = await import(pathToFileURL(path.join(packed, "index.mjs")));

const kTiny = { "a.urdf": '<robot name="a"><link name="b"><visual/></link></robot>' };
const kExamples = [
  {
    title: "An arm in SMURF, with mistakes",
    targets: [],
    from: "fixtures/models/arm",
    mistakes: [
      ["smurf/arm_motors.yml", "joint: joint2_shoulder", "joint: joint2_sholder"],
      ["urdf/arm.urdf", "../meshes/forearm.obj", "../meshes/Forearm.obj"],
      ["urdf/arm.urdf", 'lower="-0.4" upper="1.75"', 'lower="1.75" upper="-0.4"'],
    ],
  },
  {
    title: "A URDF that some programs refuse",
    targets: ["pybullet", "gazebo", "mujoco"],
    from: "tests/docs/arm.urdf",
    mistakes: [],
  },
  {
    title: "A scene in a scene on a robot",
    targets: [],
    from: "fixtures/scenes/nested",
    mistakes: [["base_motors.yml", "joint: j1", "joint: j_1"]],
  },
];

/** In the notation of files.js. */
function contentOf(bytes) {
  try {
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return { base64: bytes.toString("base64") };
  }
}

function filesOf({ from, mistakes }) {
  const place = path.join(root, from);
  const isFolder = fs.statSync(place).isDirectory();
  const names = isFolder
    ? fs
        .readdirSync(place, { recursive: true })
        .filter((name) => fs.statSync(path.join(place, name)).isFile())
    : [path.basename(place)];
  const files = new Map(
    names.sort().map((name) => [name, fs.readFileSync(isFolder ? path.join(place, name) : place)]),
  );
  for (const [name, right, wrong] of mistakes) {
    const text = files.get(name).toString();
    if (!text.includes(right)) throw new Error(`${from}/${name} has no '${right}'`);
    files.set(name, Buffer.from(text.replace(right, wrong)));
  }
  return Object.fromEntries([...files].map(([name, bytes]) => [name, contentOf(bytes)]));
}

async function said(tool, args) {
  const { code, stdout, stderr } = await run(tool, args, kTiny);
  if (code > 1) throw new Error(stderr);
  return stdout;
}

/** The names of the targets come from the help, their titles from a report. */
async function targets() {
  const help = (await said("smurf-lint", ["--help"])).replace(/\s+/g, " ");
  const all = help.match(/whether each loads them: ([^.]*)/)[1].replaceAll(" ", "");
  const page = await said("smurf-lint", [`--target=${all}`, "--format=html", "--exit-zero", "."]);
  const report = JSON.parse(page.match(/id="report" [^>]*>([^<]*)/)[1]);
  return Object.entries(report.targets).map(([name, { title }]) => ({ name, title }));
}

/** The sources that the policy allows for the viewer; none for a module without viewer. */
async function viewerSums() {
  const { stdout } = await run("smurfs-flatten", ["--format=html", "a.urdf"], kTiny);
  const sums = stdout.match(/script-src ('sha256-[^']+'); style-src ('sha256-[^']+')/);
  return sums ? [` ${sums[1]}`, ` ${sums[2]}`] : ["", ""];
}

/** The body of the page of reports, for use in another page. */
function reportPart() {
  const page = fs.readFileSync(path.join(root, "web/report/index.html"), "utf8");
  return page
    .match(/<header>[^]*<\/footer>/)[0]
    .replace(/<(\/?)h1/g, "<$1h2")
    .replace(/<(\/?)(header|main|footer)/g, "<$1div");
}

function copy(from, to, names) {
  fs.mkdirSync(path.join(output, to), { recursive: true });
  for (const name of names) fs.copyFileSync(path.join(from, name), path.join(output, to, name));
}

const written = () =>
  fs
    .readdirSync(output, { recursive: true })
    .filter((name) => fs.statSync(path.join(output, name)).isFile())
    .sort();

function fill(name, parts) {
  let text = fs.readFileSync(path.join(here, name), "utf8");
  for (const [mark, part] of Object.entries(parts)) {
    if (!text.includes(mark)) throw new Error(`${name} has no ${mark}`);
    text = text.replace(mark, () => part);
  }
  fs.writeFileSync(path.join(output, name), text);
}

const named = (folder, end) => fs.readdirSync(folder).filter((name) => end.test(name));

fs.rmSync(output, { recursive: true, force: true });
copy(path.join(root, "web/common"), "common", [
  "style.css",
  "list.css",
  ...["dom.js", "filters.js", "list.js", "viewer.js"],
]);
copy(path.join(root, "web/report"), "report", [
  "style.css",
  ...["excerpt.js", "finding.js", "overview.js", "page.js", "picture.js"],
]);
copy(here, "playground", [
  "style.css",
  "icon.svg",
  ...named(here, /\.js$/).filter((name) => name !== "sw.js"),
]);
copy(packed, "smurf", ["index.mjs", "host.mjs", "memory_files.mjs", "smurf.wasm", "LICENSE"]);
copy(path.join(packed, "licences"), "smurf/licences", fs.readdirSync(path.join(packed, "licences")));
const examples = kExamples.map((example) => ({
  title: example.title,
  targets: example.targets,
  files: filesOf(example),
}));
fs.writeFileSync(path.join(output, "about.json"), JSON.stringify({ targets: await targets(), examples }));
const [script, style] = await viewerSums();
fill("index.html", {
  "@VIEWER_SCRIPT_HASH@": script,
  "@VIEWER_STYLE_HASH@": style,
  "<!-- @REPORT@ -->": reportPart(),
});
const kept = written().filter((name) => !name.includes("LICENSE") && !name.includes("licences"));
const sum = createHash("sha256");
for (const name of kept) sum.update(`${name}\0`).update(fs.readFileSync(path.join(output, name)));
fill("sw.js", {
  "@VERSION@": sum.digest("hex").slice(0, 16),
  '["@FILES@"]': JSON.stringify(["./", ...kept]),
});
