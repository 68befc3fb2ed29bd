// SPDX-License-Identifier: BSD-3-Clause
// Checks the files after each change and shows the report, which is the page of smurf-lint --format html.
import { byId, element } from "../common/dom.js";
import { kSeverities, Page } from "../report/page.js";
import { Picture } from "../report/picture.js";
import { bytesOf, textOf } from "./bytes.js";
import { download } from "./download.js";

const kPause = 400; // ms after the last key

/** The data of a page of smurf-lint. They contain no "<". */
const reportIn = (page) => JSON.parse(page.match(/id="report" [^>]*>([^<]*)/)[1]);

/** Advice that names an option of smurf-lint, in the words of this page. */
export const inOwnWords = (help) =>
  help
    .replace(
      /name (?:its|another) folder(?: with|:) `--package (\S+)=DIR`(?:, or set ROS_PACKAGE_PATH)?/,
      "drop the folder of the package `$1` on this page, too",
    )
    .replace(
      /(?:read it with|add) `--allow-outside`(?: to check (?:it|them))?/,
      "drop its folder on this page, too",
    );

/** The page of a picture, which then says that missing files can be dropped. */
const takingDrops = (page) => page?.replace("<html", "<html data-drops");

export class Checker {
  constructor(playground) {
    this.playground = playground;
    this.byFile = new Map(); // findings
    byId("fix").addEventListener("click", () => this.fixAll());
    byId("show-robot").addEventListener("click", () => this.showRobot());
    byId("shown-robot").addEventListener("change", () => this.page?.picture.isOpen && this.showRobot());
    byId("save-report").addEventListener("click", () =>
      download(new Map([["report.html", bytesOf(this.html)]]), "report"),
    );
  }

  checkSoon() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.check(), kPause);
  }

  /** Checks now, or after the running check has ended. */
  async check() {
    clearTimeout(this.timer);
    const { files } = this.playground;
    if (files.all.size === 0 || this.isChecking) return;
    this.isChecking = true;
    const [checked, targets] = [files.all, this.playground.targets];
    const place = files.freeName("report.html");
    const target = targets.length > 0 ? [`--target=${targets.join(",")}`] : [];
    const args = ["--format=json", `--format=html=${place}`, ...target, "."];
    const result = await this.playground.run("smurf-lint", args, checked);
    this.isChecking = false;
    if (!result) return;
    this.checked = checked;
    this.show(result, result.files.get(place));
    if (files.all !== checked || String(this.playground.targets) !== String(targets)) this.check();
  }

  show({ stdout, stderr }, page) {
    const kept = this.page?.filters.state;
    const hash = this.page?.picture.hash;
    const wasOpen = this.close();
    this.playground.fail(stderr);
    this.html = page && textOf(page);
    byId("save-report").hidden = !this.html;
    if (!this.html) {
      byId("report").replaceChildren();
      this.page = undefined;
      return;
    }
    byId("report").replaceChildren(byId("report-page").content.cloneNode(true));
    const report = reportIn(this.html);
    JSON.parse(stdout).diagnostics.forEach(
      ({ fix }, index) => (report.diagnostics[index].edits = fix?.edits),
    );
    report.remarks = ""; // they name options; the page has buttons
    for (const one of report.diagnostics) if (one.help) one.help = inOwnWords(one.help);
    report.picture = takingDrops(report.picture);
    report.advice =
      'To learn whether a certain program loads the files, choose it under "Judge for programs".';
    this.keys = new AbortController();
    const actions = {
      onEdit: (finding) => {
        this.page?.picture.close(); // it lies over the text
        this.playground.edit(finding);
      },
      onFix: (finding) => this.playground.fix(finding),
    };
    this.page = new Page(report, { actions, signal: this.keys.signal });
    const frame = byId("viewer");
    frame.addEventListener("load", () => this.playground.takeDropsOn(frame.contentDocument));
    this.pictured = undefined;
    // As the command: infos are shown on request.
    const isSevere = report.diagnostics.some(({ severity }) => severity !== "info");
    if (kept) this.page.filters.restore(kept);
    else if (isSevere) this.page.filters.setShown("info", false);
    this.byFile = new Map();
    for (const finding of report.diagnostics)
      if (!this.byFile.get(finding.file)?.push(finding)) this.byFile.set(finding.file, [finding]);
    this.showBar(report);
    const { shown, files, convert } = this.playground;
    const first = report.diagnostics.find(({ file }) => files.all.has(file))?.file ?? convert.source;
    this.playground.showFile(shown ?? (files.all.has(first) ? first : undefined));
    if (wasOpen) this.showRobot(hash);
  }

  showBar({ diagnostics }) {
    const safe = diagnostics.filter(({ fix }) => fix?.is_safe).length;
    byId("fix").hidden = safe === 0;
    if (safe > 0)
      byId("fix").textContent =
        safe === 1 ? "Apply the safe fix" : `Apply all ${safe.toLocaleString("en")} safe fixes`;
    byId("show-robot").hidden = byId("conversion").hidden;
  }

  /** Removes the event handlers of the last report. Returns whether its picture was open. */
  close() {
    this.keys?.abort();
    const isOpen = this.page?.picture.isOpen ?? false;
    document.body.classList.remove("split");
    return isOpen;
  }

  async fixAll() {
    const { files } = this.playground;
    const before = files.all;
    const result = await this.playground.run("smurf-lint", ["--fix", "--fix-only", "."]);
    if (!result || files.all !== before) return;
    this.playground.fail(result.stderr);
    if (result.files.size > 0) files.change(new Map([...before, ...result.files]));
  }

  /**
   * Opens the picture with the view of the previous one. A report without findings, or about several robots, has no
   * picture.
   */
  async showRobot(hash) {
    const { page } = this;
    const source = byId("shown-robot").value;
    if (!page.picture.page || (this.pictured ?? source) !== source) {
      const place = this.playground.files.freeName("robot.html");
      const args = ["--format=html", "--force", "-o", place, "--", source];
      const result = await this.playground.run("smurfs-flatten", args);
      const html = result?.files.get(place);
      if (page !== this.page || !result) return;
      if (!html) return void this.playground.fail(result.stderr);
      page.picture.close();
      page.picture = new Picture(takingDrops(textOf(html)));
    }
    this.pictured = source;
    const viewer = await page.picture.open(source);
    if (hash && page === this.page) viewer?.readHash(hash);
  }

  /** The number of findings in a file, for the list of files. */
  countIn(name) {
    const own = this.byFile.get(name);
    if (!own) return undefined;
    const worst = kSeverities.find((severity) => own.some((one) => one.severity === severity));
    return element(
      "span",
      { class: `badge ${worst}` },
      String(own.length),
      element("span", { class: "unseen" }, own.length === 1 ? " finding" : " findings"),
    );
  }
}
