// SPDX-License-Identifier: BSD-3-Clause
// The search and the filters above the list.
import { byId, counted, element } from "../common/dom.js";

export const kSeverities = ["error", "warning", "info"];

/** How many findings have each value of what `valuesOf` gives, most first. */
function tally(findings, valuesOf) {
  const counts = new Map();
  for (const finding of findings)
    for (const value of valuesOf(finding)) counts.set(value, (counts.get(value) ?? 0) + 1);
  return counts;
}

function textOf(finding) {
  const { id, name, message, file, pointer, help, caret, notes = [], labels = [] } = finding;
  const parts = [
    id,
    name,
    message,
    file,
    pointer,
    help,
    caret,
    ...notes,
    ...labels.map((label) => label.message),
  ];
  return parts.join("\n").toLowerCase();
}

export class Filters {
  constructor(report, onChange) {
    this.report = report;
    this.onChange = onChange;
    this.texts = [];
    this.hidden = new Set(); // severities
    this.addSeverities();
    const { rules, targets = {} } = report;
    this.addSelect(
      "rule",
      "All rules",
      tally(report.diagnostics, ({ id }) => [id]),
      (id) => `${id} ${rules[id].name}`,
    );
    this.addSelect(
      "file",
      "All files",
      tally(report.diagnostics, ({ file }) => [file]),
      (file) => file || "no file",
    );
    const byTarget = tally(report.diagnostics, ({ effects = {} }) => Object.keys(effects));
    this.addSelect("target", "All programs", byTarget, (name) => targets[name].title, 1);
    byId("words").addEventListener("input", () => this.change());
    byId("clear").addEventListener("click", () => this.clear());
    byId("filters").addEventListener("submit", (event) => event.preventDefault());
    byId("filters").hidden = report.diagnostics.length === 0;
  }

  addSeverities() {
    const counts = tally(this.report.diagnostics, ({ severity }) => [severity]);
    this.severities = kSeverities.filter((severity) => counts.has(severity));
    this.buttons = this.severities.map((severity) => {
      const button = element(
        "button",
        {
          type: "button",
          class: `toggle ${severity}`,
          "aria-pressed": "true",
          title: `Show or hide: ${severity}`,
        },
        counted(counts.get(severity), severity),
      );
      button.addEventListener("click", () => this.setSeverity(severity, this.hidden.has(severity)));
      return button;
    });
    byId("severities").append(...this.buttons);
  }

  setSeverity(severity, isShown) {
    if (isShown) this.hidden.delete(severity);
    else this.hidden.add(severity);
    this.change();
  }

  /** A list to choose from; hidden where there is no choice. */
  addSelect(id, all, counts, nameOf, least = 2) {
    const sorted = [...counts].sort((a, b) => b[1] - a[1]);
    const options = sorted.map(([value, count]) =>
      element("option", { value }, `${nameOf(value)} (${count.toLocaleString("en")})`),
    );
    byId(id).append(element("option", { value: "" }, all), ...options);
    byId(id).hidden = sorted.length < least;
    byId(id).addEventListener("change", () => this.change());
  }

  choose(id, value) {
    byId(id).value = value;
    this.change();
  }

  clear() {
    this.hidden.clear();
    for (const id of ["words", "rule", "file", "target"]) byId(id).value = "";
    this.change();
  }

  isNarrowed() {
    return this.hidden.size > 0 || ["words", "rule", "file", "target"].some((id) => byId(id).value !== "");
  }

  /** The findings that all filters let through. */
  chosen() {
    const words = byId("words").value.toLowerCase().split(/\s+/).filter(Boolean);
    const [rule, file, target] = ["rule", "file", "target"].map((id) => byId(id).value);
    const hasWords = (finding) => {
      this.texts[finding.number] ??= textOf(finding);
      return words.every((word) => this.texts[finding.number].includes(word));
    };
    return this.report.diagnostics.filter(
      (finding) =>
        !this.hidden.has(finding.severity) &&
        (!rule || finding.id === rule) &&
        (!file || finding.file === file) &&
        (!target || finding.effects?.[target]) &&
        (words.length === 0 || hasWords(finding)),
    );
  }

  change() {
    this.buttons.forEach((button, index) => {
      button.setAttribute("aria-pressed", String(!this.hidden.has(this.severities[index])));
    });
    byId("clear").hidden = !this.isNarrowed();
    const chosen = this.chosen();
    const all = this.report.diagnostics.length;
    byId("status").textContent =
      chosen.length === all ? "" : `${chosen.length.toLocaleString("en")} of ${counted(all, "finding")}`;
    this.onChange(chosen);
  }
}
