// SPDX-License-Identifier: BSD-3-Clause
// The playground: opens files, runs the tools on them in a worker, and shows the results.
// Nothing leaves the browser: the only requests are for the files of this page.
import { byId, element } from "../common/dom.js";
import { chosen, contentsOf, dropped } from "./intake.js";
import { Checker } from "./checker.js";
import { Convert } from "./convert.js";
import { download } from "./download.js";
import { Editor } from "./editor.js";
import { Files, edited, fromJson, kindOf } from "./files.js";
import { fromHash, kMostShared, toHash } from "./share.js";
import { Stopped, Tools } from "./tools.js";

/** Whether a file is a robot, or may be made one. */
const isRobot = (name) => kindOf(name) !== undefined || /\.svg$/i.test(name);
const kPatience = 1.5; // s before a message that the tools are working

class Playground {
  /** `about`: {targets: [{name, title}], examples: [{title, targets, files}]} */
  constructor({ targets, examples }) {
    this.files = new Files(() => this.update());
    this.tools = new Tools((seconds) => this.showWork(seconds));
    this.editor = new Editor((name, bytes) => this.files.set(name, bytes, name));
    this.convert = new Convert(this.files, (...job) => this.run(...job));
    this.checker = new Checker(this);
    this.addTargets(targets);
    this.addExamples(examples);
    this.listen();
    this.readAddress();
  }

  listen() {
    const onClick = (id, action) => byId(id).addEventListener("click", action);
    for (const [button, input] of [
      ["open-folder", "folder"],
      ["open-files", "files"],
    ]) {
      onClick(button, () => byId(input).click());
      byId(input).addEventListener("change", ({ target }) => {
        this.take(Promise.resolve(chosen(target.files)));
        target.value = "";
      });
    }
    onClick("undo", () => this.files.undo());
    onClick("save", () => {
      this.kept = this.files.all;
      download(this.files.all, "robot");
    });
    onClick("share", () => this.share());
    onClick("stop", () => this.tools.stop());
    this.takeDropsOn(document);
    window.addEventListener("hashchange", () => this.readAddress());
    window.addEventListener("beforeunload", (event) => {
      if (this.files.canUndo && this.files.all !== this.kept) event.preventDefault();
    });
  }

  /** Files may be dropped on this page, and on the picture in its frame. */
  takeDropsOn(page) {
    if (!page || page.smurfTakesDrops) return;
    page.smurfTakesDrops = true;
    const hasFiles = (event) => event.dataTransfer.types.includes("Files");
    const mark = (event, isOver) => {
      if (!hasFiles(event)) return; // text that is dragged in the text field
      event.preventDefault();
      document.body.classList.toggle("dropping", isOver);
    };
    page.addEventListener("dragover", (event) => mark(event, true));
    page.addEventListener("dragleave", (event) => mark(event, false));
    page.addEventListener("drop", (event) => {
      mark(event, false);
      if (hasFiles(event)) this.take(dropped(event.dataTransfer));
    });
  }

  addTargets(targets) {
    byId("programs").append(
      ...targets.map(({ name, title }) =>
        element("label", {}, element("input", { type: "checkbox", value: name }), ` ${title}`),
      ),
    );
    byId("programs").addEventListener("change", () => this.chooseTargets(this.targets));
  }

  addExamples(examples) {
    byId("examples").append(
      ...examples.map(({ title, files, targets }) =>
        element("button", { type: "button", onclick: () => this.open(fromJson(files), targets) }, title),
      ),
    );
  }

  get targets() {
    return [...byId("programs").querySelectorAll(":checked")].map(({ value }) => value);
  }

  chooseTargets(targets) {
    const boxes = [...byId("programs").querySelectorAll("input")];
    for (const box of boxes) box.checked = targets.includes(box.value);
    byId("chosen").textContent = this.targets.join(", ") || "none";
    this.checker.check();
  }

  tell(text) {
    byId("message").textContent = text;
  }

  /** Opens [[path, File]]. */
  async take(found) {
    try {
      const files = await contentsOf(await found);
      if (files.size === 0) throw new Error("there are no files in it");
      if (this.files.all.size > 0 && ![...files.keys()].some(isRobot)) this.add(files);
      else this.open(files, this.targets);
    } catch (error) {
      this.tell(`This cannot be opened: ${error.message}.`);
    }
  }

  /** Adds files that are no robot, such as the meshes of the one that is open. */
  add(files) {
    this.files.change(new Map([...this.files.all, ...files]));
    this.tell(
      files.size === 1 ? "1 file was added." : `${files.size.toLocaleString("en")} files were added.`,
    );
  }

  /** Replaces all files. */
  open(files, targets) {
    this.tell("");
    this.kept = files;
    byId("result").hidden = true;
    this.shown = undefined;
    this.files.change(files);
    this.chooseTargets(targets);
  }

  async readAddress() {
    try {
      const shared = await fromHash(location.hash);
      if (!shared) return;
      this.shared = shared.files; // a reload opens them again
      this.open(shared.files, shared.targets);
    } catch (error) {
      this.tell(`This link cannot be opened: ${error.message}.`);
    }
  }

  async share() {
    const hash = await toHash(this.files.all, this.targets);
    if (hash.length > kMostShared) {
      const [length, most] = [hash.length, kMostShared].map((count) => count.toLocaleString("en"));
      byId("shared").textContent =
        `These files are too large for a link: it would have ${length} characters, and many programs cut links of more than ${most}. Download them instead.`;
      return;
    }
    this.kept = this.shared = this.files.all;
    history.replaceState(null, "", hash);
    const isCopied = await navigator.clipboard?.writeText(location.href).then(
      () => true,
      () => false,
    );
    byId("shared").textContent =
      `The files are in the address of this page${isCopied ? ", which was copied" : ""}. Whoever has the link can read them.`;
  }

  /** Shows the files as they are now. */
  update() {
    const { all } = this.files;
    if (location.hash && all !== this.shared)
      history.replaceState(null, "", location.pathname + location.search);
    document.body.classList.toggle("empty", all.size === 0);
    byId("robot").hidden = all.size === 0;
    byId("findings").hidden = all.size === 0;
    byId("undo").disabled = !this.files.canUndo;
    byId("shared").textContent = "";
    this.convert.update();
    this.showFile(all.has(this.shown) ? this.shown : undefined);
    this.checker.checkSoon();
  }

  showFile(name) {
    this.shown = name;
    this.editor.show(name, this.files.all.get(name));
    this.showNames();
  }

  showNames() {
    const { all } = this.files;
    const names = [...all.keys()].sort();
    // Drawing a list of thousands for each key stroke would be too slow.
    const listed = JSON.stringify([this.shown, names]);
    if (listed === this.listed && this.checker.byFile === this.counted) return;
    this.listed = listed;
    this.counted = this.checker.byFile;
    byId("robot-title").textContent = all.size === 1 ? "1 file" : `${all.size.toLocaleString("en")} files`;
    const hadFocus = byId("names").contains(document.activeElement);
    byId("names").replaceChildren(
      ...names.map((name) => {
        const count = this.checker.countIn(name);
        return element(
          "li",
          {},
          element(
            "button",
            {
              type: "button",
              "aria-current": name === this.shown && "true",
              onclick: () => this.showFile(name),
            },
            element("span", {}, name),
            count,
          ),
        );
      }),
    );
    const current = byId("names").querySelector("[aria-current]");
    if (hadFocus) current?.focus();
    if (current) byId("names").scrollTop = current.offsetTop - byId("names").clientHeight / 2;
  }

  /** The result of a tool. If it cannot be run, shows the reason and returns undefined. */
  async run(tool, args, files = this.files.all) {
    try {
      byId("failure").hidden = true;
      return await this.tools.run(tool, args, files);
    } catch (error) {
      this.fail(
        error instanceof Stopped ? "Stopped. Change a file to check again." : `${tool}: ${error.message}`,
      );
      return undefined;
    }
  }

  fail(text) {
    byId("failure").textContent = text;
    byId("failure").hidden = text === "";
  }

  /** Applies the fix of a finding. */
  fix(finding) {
    if (this.checker.checked !== this.files.all) return; // a check of the changed files is running
    if (!finding.edits.every(({ file }) => this.has(file))) return;
    this.shown = finding.edits[0].file;
    this.files.change(edited(this.files.all, finding.edits));
  }

  /** Whether a file can be changed; if not, shows the reason. */
  has(file) {
    const isThere = this.files.all.has(file);
    this.tell(isThere ? "" : `${file} is in an archive: unpack it to change it.`);
    return isThere;
  }

  edit(finding) {
    if (!this.has(finding.file)) return;
    this.showFile(finding.file);
    this.editor.select(finding);
  }

  showWork(seconds = 0) {
    const isLong = seconds >= kPatience;
    const count = Math.floor(seconds / 10) * 10;
    const text = count === 0 ? "Working\u2026" : `Working for ${count} seconds. Large robots take long.`;
    byId("work-status").textContent = isLong ? text : "";
    byId("stop").hidden = !isLong;
  }
}

async function workOffline() {
  if (!navigator.serviceWorker) return; // browsers have none for pages without https
  await navigator.serviceWorker.register("sw.js");
  await navigator.serviceWorker.ready;
  byId("offline").hidden = false;
}

const about = await (await fetch("about.json")).json();
window.smurfPlayground = new Playground(about);
document.documentElement.dataset.ready = "true";
workOffline().catch(() => {}); // the page also works without it
