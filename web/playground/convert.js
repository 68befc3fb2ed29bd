// SPDX-License-Identifier: BSD-3-Clause
// Converts the robot for other programs, and offers the result.
import { byId, element } from "../common/dom.js";
import { sizeOf, textOf } from "./bytes.js";
import { download } from "./download.js";
import { kindOf } from "./files.js";

const kMostShown = 20000; // characters of a result

const flattened = (format) => (file, output) => [
  "smurfs-flatten",
  ["--format", format, "-o", output, "--", file],
];
/** With the meshes and textures that the result names, so that a download is complete. */
const withAssets = (format) => (file, output) => [
  "smurfs-flatten",
  ["--format", format, "--copy-assets", `${output.replace(/\.[^.]*$/, "")}_assets`, "-o", output, "--", file],
];
const exported = (file, output) => ["smurf2urdf", ["-o", output, "--", file]];
const imported = (file, output) => ["urdf2smurf", ["--copy-meshes", "-o", output, "--", file]];

const kScene = ["xacro", "urdf", "smurf", "smurfs", "smurfa", "zsmurf", "zsmurfs"];
/** [title of the result, end of its file name, extensions of the input, command] */
const kForms = [
  ["URDF", ".urdf", ["xacro", "smurf"], exported],
  ["SMURF", "_smurf", ["xacro", "urdf"], imported],
  ["SDF (Gazebo)", ".sdf", kScene, withAssets("sdf")],
  ["MJCF (MuJoCo)", ".xml", kScene, flattened("mjcf")],
  ["one merged URDF", ".urdf", ["smurfs", "smurfa", "zsmurfs"], withAssets("urdf")],
  ["OpenUSD (Isaac Sim)", ".usda", kScene, withAssets("usda")],
  ["glTF (viewers)", ".gltf", kScene, flattened("gltf")],
  ["JSON", ".json", kScene, flattened("json")],
  ["a page in 3D", ".html", kScene, flattened("html")],
];

const formsOf = (file) => kForms.filter(([, , kinds]) => kinds.includes(kindOf(file)));

function setOptions(select, values, nameOf = (value) => value) {
  const before = select.value;
  select.replaceChildren(
    ...values.map((value) => element("option", { value: nameOf(value) }, nameOf(value))),
  );
  if (values.some((value) => nameOf(value) === before)) select.value = before;
}

/**
 * Scenes before models before URDFs, because the former contain the latter; of each kind, outer folders first. Xacro files
 * come last, because most are parts of robots; those of whole robots are often called NAME.urdf.xacro.
 */
function byImportance(a, b) {
  const rank = (name) =>
    kScene.indexOf(kindOf(name).replace("z", "")) + Number(/\.urdf\.xacro$/i.test(name)) / 2;
  const depth = (name) => name.split("/").length;
  return rank(b) - rank(a) || depth(a) - depth(b);
}

export class Convert {
  /** `run` runs a tool; `files` are the Files. */
  constructor(files, run) {
    this.files = files;
    this.run = run;
    byId("source").addEventListener("change", () => this.showForms());
    byId("convert").addEventListener("click", () => this.convert());
    byId("save-result").addEventListener("click", () => download(this.result, this.name));
    byId("keep-result").addEventListener("click", () => {
      this.files.change(new Map([...this.files.all, ...this.result]));
      byId("result").hidden = true;
    });
  }

  /** The path of the file to convert and show. */
  get source() {
    return byId("source").value;
  }

  update() {
    const names = [...this.files.all.keys()].filter(kindOf).sort(byImportance);
    for (const id of ["source", "shown-robot"]) setOptions(byId(id), names);
    byId("conversion").hidden = names.length === 0;
    byId("shown-robot").hidden = names.length < 2;
    this.showForms();
  }

  showForms() {
    setOptions(byId("form"), formsOf(this.source), ([name]) => name);
  }

  async convert() {
    const [, end, , command] = formsOf(this.source).find(([name]) => name === byId("form").value);
    const stem = this.source.replace(/.*\//, "").replace(/(\.urdf)?\.[^.]*$/i, "");
    this.name = this.files.freeName(stem + end);
    const [tool, args] = command(this.source, this.name);
    const result = await this.run(tool, byId("despite").checked ? ["--force", ...args] : args);
    if (result) this.show(result);
  }

  show({ stderr, files }) {
    this.result = files;
    byId("result").hidden = false;
    byId("result-title").textContent = files.size > 0 ? `Written: ${this.name}` : "Nothing was written";
    byId("said").textContent = stderr;
    byId("said").hidden = stderr === "";
    for (const id of ["save-result", "keep-result"]) byId(id).hidden = files.size === 0;
    byId("result-files").replaceChildren(
      ...[...files].map(([name, bytes]) => {
        const text = textOf(bytes) ?? "This file is no text.";
        const shown = text.length > kMostShown ? `${text.slice(0, kMostShown)}\n\u2026` : text;
        return element(
          "details",
          {},
          element("summary", {}, `${name} (${sizeOf(bytes.length)})`),
          element("pre", { tabindex: "0", "aria-label": name }, shown),
        );
      }),
    );
  }
}
