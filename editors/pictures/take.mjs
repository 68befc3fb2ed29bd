// SPDX-License-Identifier: BSD-3-Clause
// Takes the pictures of docs/editors.md in a build of VS Code that runs in a browser.
//
//   editors/vscode/build
//   editors/pictures/install build/pictures
//   node editors/pictures/take.mjs build/pictures [PICTURE...]
//
// PICTURE: names of pictures; without any, all are taken.
import { execFileSync, spawn } from "node:child_process";
import fs from "node:fs";
import { createRequire } from "node:module";
import os from "node:os";
import path from "node:path";

const root = path.resolve(import.meta.dirname ?? path.dirname(process.argv[1]), "../..");
const programs = path.resolve(process.argv[2] ?? "");
const wanted = process.argv.slice(3);
const puppeteer = createRequire(path.join(programs, "x.js"))("puppeteer-core").default;
const address = "http://127.0.0.1:18765";
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

const kSettings = {
  "breadcrumbs.enabled": false,
  "editor.fontSize": 13,
  "editor.minimap.enabled": false,
  "editor.scrollbar.vertical": "hidden",
  "extensions.ignoreRecommendations": true,
  "security.workspace.trust.enabled": false,
  "telemetry.telemetryLevel": "off",
  "window.commandCenter": false,
  "window.menuBarVisibility": "hidden",
  "workbench.activityBar.location": "hidden",
  "workbench.colorTheme": "Default Light Modern",
  "workbench.editor.editorActionsLocation": "hidden",
  "workbench.layoutControl.enabled": false,
  "workbench.startupEditor": "none",
  "workbench.statusBar.visible": false,
  "workbench.tips.enabled": false,
};

const work = fs.mkdtempSync(path.join(os.tmpdir(), "robots-"));
const model = path.join(work, "arm");
fs.cpSync(path.join(root, "fixtures/models/arm"), model, { recursive: true });
const motors = path.join(model, "smurf/arm_motors.yml");
const sound = fs.readFileSync(motors, "utf8");
const broken = sound.replace("joint: joint1_waist", "joint: joynt1_waist");
const data = path.join(work, "data");
fs.mkdirSync(path.join(data, "User"), { recursive: true });
fs.writeFileSync(path.join(data, "User/settings.json"), JSON.stringify(kSettings));

const entry = path.join(programs, "node_modules/code-server/lib/vscode/out/server-main.js");
const common = ["--accept-server-license-terms", "--user-data-dir", data, "--server-data-dir", data,
  "--extensions-dir", path.join(work, "extensions")];
execFileSync("node", [entry, ...common, "--install-extension", path.join(root, "build/smurf.vsix")],
  { stdio: ["ignore", "ignore", "inherit"] });
const [host, port] = address.slice("http://".length).split(":");
const server = spawn("node", [entry, ...common, "--without-connection-token", "--telemetry-level", "off",
  "--host", host, "--port", port], { stdio: "ignore" });
const browser = await puppeteer.launch({
  executablePath: "/usr/bin/chromium", args: ["--no-sandbox"], defaultViewport: { width: 720, height: 400 } });
const page = await browser.newPage();

async function press(keys) {
  const all = keys.split("+");
  for (const key of all.slice(0, -1)) await page.keyboard.down(key);
  await page.keyboard.press(all.at(-1));
  for (const key of all.slice(0, -1).reverse()) await page.keyboard.up(key);
  await pause(600);
}

/// Opens a file and waits until the editor shows `sign`, which is what the server has answered.
async function open(file, sign) {
  const payload = [["openFile", "vscode-remote://" + address.slice("http://".length) + path.join(model, file)]];
  const query = "?folder=" + model + "&payload=" + encodeURIComponent(JSON.stringify(payload));
  for (let tries = 60; ; --tries) {
    try {
      await page.goto(address + "/" + query, { timeout: 120000 });
      break;
    } catch (problem) {
      if (tries === 0) throw problem;
      await pause(1000);
    }
  }
  await page.waitForSelector(".monaco-editor .view-line", { timeout: 120000 });
  await pause(1500);
  await hide("sidebar", "Control+KeyB");
  await hide("auxiliarybar", "Control+Alt+KeyB");
  await hide("panel", "Control+KeyJ");
  if (sign) await page.waitForSelector(sign, { timeout: 60000 });
  await pause(1500);
}

/// Hides a part of the window that the picture before may have shown.
async function hide(part, keys) {
  const isShown = await page.evaluate((name) => document.querySelector(".part." + name)?.offsetWidth > 0, part);
  if (isShown) await press(keys);
}

async function run(command) {
  await press("F1");
  await page.keyboard.type(command);
  await pause(700);
  await press("Enter");
}

/// Shows what the server says about the end of a text.
async function describe(file, text) {
  await open(file);
  await go(...place(file, text));
  await press("Control+KeyK");
  await press("Control+KeyI");
  await pause(2500);
}

async function go(line, column) {
  await press("Control+KeyG");
  await page.keyboard.type(`${line}:${column}`);
  await press("Enter");
}

/// Line and column of a text in a file, with the cursor in the middle of its last word.
function place(file, text) {
  const before = fs.readFileSync(path.join(model, file), "utf8").split(text)[0] + text;
  const lines = before.split("\n");
  return [lines.length, lines.at(-1).length - 3];
}

/// The frame with the page in 3D, when it shows a robot.
async function viewer() {
  for (let tries = 120; tries > 0; --tries) {
    for (const frame of page.frames()) {
      if (await frame.evaluate(() => Boolean(window.smurfViewer)).catch(() => false)) return frame;
    }
    await pause(500);
  }
  throw new Error("the robot is not shown");
}

/// A chain of links, each with a box.
function chain(links) {
  const link = (i) => `  <link name="l${i}"><visual><geometry><box size="0.04 0.04 0.09"/></geometry></visual></link>\n`;
  const joint = (i) => `  <joint name="j${i}" type="revolute">\n    <origin xyz="0 0 0.1"/>\n    <parent link="l${i}"/>\n` +
    `    <child link="l${i + 1}"/>\n    <axis xyz="0 1 0"/>\n    <limit lower="-1" upper="1" effort="1" velocity="1"/>\n  </joint>\n`;
  const all = [...Array(links).keys()];
  return `<robot name="chain">\n${all.map(link).join("")}${all.slice(1).map((i) => joint(i - 1)).join("")}</robot>\n`;
}

/// Opens the robot beside its text, and prints how long it takes until a key stroke has moved it.
async function show(file) {
  await page.setViewport({ width: 1280, height: 720 });
  await open(file);
  await run("SMURF: Show the robot in 3D");
  const frame = await viewer();
  await pause(3000);
  return frame;
}

async function measureTyping() {
  fs.writeFileSync(path.join(model, "urdf/chain.urdf"), chain(40));
  const frame = await show("urdf/chain.urdf");
  const [line, column] = place("urdf/chain.urdf", '<origin xyz="0 0 0.1');
  await page.click(".monaco-editor .view-lines");
  await go(line, column + 4);
  const times = [];
  for (const key of ["5", "7", "3"]) {
    const changed = frame.evaluate(() => new Promise((done) => {
      const { scene } = window.smurfViewer;
      const end = Date.now() + 10000;
      const look = () => (window.smurfViewer.scene === scene && Date.now() < end ? setTimeout(look, 5) : done(Date.now()));
      look();
    }));
    const start = Date.now();
    await page.keyboard.press(key);
    times.push((await changed) - start);
    await pause(1000);
  }
  console.log(`40 links: the picture follows a key after ${times.join(", ")} ms`);
  const before = await activeLine();
  await (await frame.$("canvas")).click();
  await pause(1500);
  console.log(`a click in the picture: the cursor moves from line ${before} to line ${await activeLine()}`);
}

/// The line of the cursor.
const activeLine = () => page.evaluate(() => document.querySelector(".line-numbers.active-line-number")?.textContent);

const kPictures = {
  async preview() {
    await measureTyping();
    await show("urdf/arm.urdf");
    await page.click(".monaco-editor .view-lines");
    await go(...place("urdf/arm.urdf", '<link name="forearm"'));
    await pause(3000);
  },
  async broken() {
    await show("urdf/arm.urdf");
    await page.click(".monaco-editor .view-lines");
    const [line, column] = place("urdf/arm.urdf", '<mass value="1.');
    await go(line, column + 3);
    await page.keyboard.type(",");
    await pause(3000);
  },
  async findings() {
    fs.writeFileSync(motors, broken);
    await open("smurf/arm_motors.yml", ".squiggly-error");
    await run("Problems: Focus on Problems View");
    await pause(1500);
  },
  async fix() {
    fs.writeFileSync(motors, broken);
    await open("smurf/arm_motors.yml", ".squiggly-error");
    await go(...place("smurf/arm_motors.yml", "joint: joynt1_waist"));
    await press("Control+Period");
    await pause(2000);
  },
  async hover() {
    await describe("smurf/arm_motors.yml", "joint: joint2_shoulder");
  },
  async mesh() {
    await describe("urdf/arm.urdf", 'filename="../meshes/forearm.obj');
  },
  async pose() {
    await describe("urdf/arm.urdf", '<origin xyz="0.03 0 0.06');
  },
  async colors() {
    await open("smurf/arm_materials.yml", ".colorpicker-color-decoration");
  },
  async completion() {
    await open("smurf/arm_motors.yml");
    const [line, column] = place("smurf/arm_motors.yml", "joint: joint2_shoulder");
    await go(line, column);
    await press("End");
    for (let i = 0; i < "2_shoulder".length; ++i) await page.keyboard.press("Backspace");
    await press("Control+Space");
    await pause(2500);
  },
  async references() {
    await open("smurf/arm_motors.yml");
    await go(...place("smurf/arm_motors.yml", "joint: joint1_waist"));
    await press("Shift+F12");
    await pause(3000);
  },
  async rename() {
    await open("smurf/arm_motors.yml");
    await go(...place("smurf/arm_motors.yml", "joint: joint1_waist"));
    await press("F2");
    await pause(1500);
    await page.keyboard.type("waist");
    await press("Control+Enter");  // shows the changes first
    await pause(2000);
    await run("View: Toggle Maximized Panel");
    await pause(1500);
  },
  async hints() {
    await open("urdf/arm.urdf");
    await go(...place("urdf/arm.urdf", '<joint name="joint2_shoulder"'));
    await pause(2500);
  },
  async symbols() {
    await open("urdf/arm.urdf");
    await go(...place("urdf/arm.urdf", '<link name="turret"'));
    await press("Control+Shift+KeyO");
    await pause(2500);
  },
  async outline() {
    await open("urdf/arm.urdf");
    await go(...place("urdf/arm.urdf", '<joint name="joint2_shoulder"'));
    await run("Outline: Focus on Outline View");
    await pause(2500);
  },
};

try {
  for (const [name, take] of Object.entries(kPictures)) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    fs.writeFileSync(motors, sound);
    await page.setViewport({ width: 720, height: 400 });
    await take();
    const file = path.join(root, "docs/editors", name + ".png");
    await page.screenshot({ path: file });
    execFileSync("pngquant", ["--force", "--ext", ".png", "--strip", "48", file]);
    console.log(`${name}: ${fs.statSync(file).size} bytes`);
  }
} finally {
  await browser.close();
  server.kill();
  fs.rmSync(work, { recursive: true, force: true });
}
