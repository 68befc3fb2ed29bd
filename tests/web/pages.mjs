// SPDX-License-Identifier: BSD-3-Clause
// Opens pages in Chromium and runs steps in them. usage: node pages.mjs NODE_MODULES CHROMIUM
// Each line of standard input is a list of jobs, and is answered by a line of results.
// Jobs: [{page, hash, width, height, scheme, steps}]. A page is a file, or an address on this machine. It
// finds nothing that other pages stored. A step is a script (a text), {key}, {down: KEY}, {up: KEY}, {drag: [x, y, x, y]}, {type: TEXT}, {click: [x, y]}, {shot: FILE, of: SELECTOR}, {axe: true},
// {until: SCRIPT}, {drop: PATHS}, {choose: SELECTOR, paths}, {downloads: FOLDER}, {file: one that is there soon}, {write: FILE, text} or {load: HASH}.
// Results: [{results: one for each step, errors that the page logged, addresses that it asked for}]
import fs from "node:fs";
import { createRequire } from "node:module";
import readline from "node:readline";
import { pathToFileURL } from "node:url";

const [modules, chromium] = process.argv.slice(2);
const require = createRequire(`${modules}/`);
const kTime = 600_000; // ms; machines of CI are slow and busy

/** Drops files and folders in the middle of the page. */
async function drop(page, files) {
  const { width, height } = page.viewport();
  const client = await page.createCDPSession();
  const data = { items: [], files, dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", "drop"])
    await client.send("Input.dispatchDragEvent", { type, x: width / 2, y: height / 2, data });
}

async function dragAcross(page, fromX, fromY, toX, toY) {
  await page.mouse.move(fromX, fromY);
  await page.mouse.down();
  await page.mouse.move(toX, toY, { steps: 5 });
  await page.mouse.up();
}

/** A download has another name until it is complete. */
async function appears(file) {
  while (!fs.existsSync(file)) await new Promise((done) => setTimeout(done, 50));
}

async function load(page, hash) {
  await page.goto("about:blank");
  await page.goto(page.address + hash, { timeout: kTime });
  await page.waitForSelector("html[data-ready]");
}

async function take(page, step) {
  if (typeof step === "string") return page.evaluate(step);
  if (step.key) return page.keyboard.press(step.key);
  if (step.down) return page.keyboard.down(step.down);
  if (step.up) return page.keyboard.up(step.up);
  if (step.drag) return dragAcross(page, ...step.drag);
  if (step.type) return page.keyboard.type(step.type);
  if (step.until) return void (await page.waitForFunction(step.until, { timeout: kTime }));
  if (step.drop) return drop(page, step.drop);
  if (step.choose) return (await page.$(step.choose)).uploadFile(...step.paths);
  if (step.load !== undefined) return load(page, step.load);
  if (step.file) return appears(step.file);
  if (step.write) return fs.writeFileSync(step.write, step.text);
  if (step.downloads) {
    const client = await page.createCDPSession();
    return void (await client.send("Page.setDownloadBehavior", { behavior: "allow", downloadPath: step.downloads }));
  }
  if (step.click) return page.mouse.click(...step.click);
  if (step.shot) return void (await (step.of ? await page.$(step.of) : page).screenshot({ path: step.shot }));
  await page.evaluate(fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8"));
  const { violations } = await page.evaluate("axe.run({ iframes: false })"); // the pages in frames have tests of their own
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ")}`);
}

async function run(browser, { page: file, hash = "", width = 1280, height = 800, scheme = "light", ready = "html[data-ready]", steps }) {
  const isServed = file.startsWith("http://");
  const context = await browser.createBrowserContext();
  const page = await context.newPage();
  page.address = isServed ? file : pathToFileURL(file).href;
  page.setDefaultTimeout(kTime);
  const errors = [];
  const addresses = [];
  page.on("console", (message) => {
    if (message.type() !== "log") errors.push(`${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("dialog", (dialog) => {
    if (dialog.type() === "beforeunload") return void dialog.accept(); // a page with changes is left
    errors.push(`dialog: ${dialog.message()}`);
  });
  page.on("request", (request) => addresses.push(request.url()));
  await page.setViewport({ width, height });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
  await page.goto(page.address + hash, { timeout: kTime });
  await page.waitForSelector(ready);
  const results = [];
  for (const step of steps) results.push((await take(page, step)) ?? null);
  const isOther = isServed
    ? (address) => !address.startsWith(page.address) && !address.startsWith("data:")
    : (address) => address.split("#")[0] !== page.address;
  await context.close();
  return { results, errors, addresses: addresses.filter(isOther) };
}

const browser = await require("puppeteer-core").launch({
  executablePath: chromium,
  protocolTimeout: kTime,
  timeout: kTime,
  args: ["--no-sandbox", "--enable-unsafe-swiftshader", "--use-angle=swiftshader", "--ignore-gpu-blocklist"],
});
try {
  for await (const line of readline.createInterface({ input: process.stdin })) {
    const results = [];
    for (const job of JSON.parse(line)) results.push(await run(browser, job));
    process.stdout.write(JSON.stringify(results) + "\n");
  }
} finally {
  await browser.close();
}
