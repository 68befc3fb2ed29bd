// SPDX-License-Identifier: BSD-3-Clause
// Shows a report: its summary, filters, findings and picture.
import { byId, counted, element } from "../common/dom.js";
import { kAtOnce, ListPage } from "../common/list.js";
import { Sources } from "./excerpt.js";
import { card } from "./finding.js";
import { Picture } from "./picture.js";
import { showNothingFound, showRobots, showSummary, showTargets } from "./overview.js";

const kOfRule = 3; // findings of one rule in a file that are shown; the others are folded
export const kSeverities = ["error", "warning", "info"];

const rankOf = ({ severity }) => kSeverities.indexOf(severity);

/** [[file, findings]], the worst first. */
function groupsOf(findings) {
  const groups = new Map();
  for (const finding of findings) {
    if (!groups.has(finding.file)) groups.set(finding.file, []);
    groups.get(finding.file).push(finding);
  }
  for (const group of groups.values()) group.sort((a, b) => rankOf(a) - rankOf(b) || a.number - b.number);
  return [...groups].sort(([, [a]], [, [b]]) => rankOf(a) - rankOf(b));
}

function countsOf(findings) {
  return kSeverities
    .map((severity) => [severity, findings.filter((finding) => finding.severity === severity).length])
    .filter(([, count]) => count > 0)
    .map(([severity, count]) => element("span", { class: `count ${severity}` }, counted(count, severity)));
}

function textOf(finding) {
  const { id, name, message, file, pointer, help, caret, notes = [], labels = [] } = finding;
  const told = labels.map((label) => label.message);
  return [id, name, message, file, pointer, help, caret, ...notes, ...told].join("\n");
}

const filtersOf = ({ rules, targets = {} }) => ({
  textOf,
  toggle: {
    host: "severities",
    values: kSeverities,
    valueOf: ({ severity }) => severity,
    label: counted,
  },
  selects: [
    {
      id: "rule",
      all: "All rules",
      valuesOf: ({ id }) => [id],
      nameOf: (id) => `${id} ${rules[id].name}`,
    },
    { id: "file", all: "All files", valuesOf: ({ file }) => [file], nameOf: (file) => file || "no file" },
    {
      id: "target",
      all: "All programs",
      valuesOf: ({ effects = {} }) => Object.keys(effects),
      nameOf: (name) => targets[name].title,
      least: 1,
    },
  ],
});

/** `actions`: further actions of the cards, see finding.js. `signal` removes the page's handlers of keys. */
export class Page extends ListPage {
  constructor(report, { actions = {}, signal } = {}) {
    super(report.diagnostics, "finding", filtersOf(report), signal);
    this.report = report;
    this.actions = actions;
    report.sources = new Sources(report.sources);
    this.picture = new Picture(report.picture);
    byId("picture-key").hidden = !report.picture;
    showSummary(report);
    showTargets(report, (target) => this.filters.choose("target", target));
    showRobots(report, (file) => {
      this.filters.choose("file", file);
      byId("filters").scrollIntoView();
    });
    this.filters.change();
  }

  card(finding) {
    return card(finding, this.report, {
      ...this.actions,
      onRule: (rule) => this.filters.choose("rule", rule),
      onPicture: this.picture.find(finding) && (() => this.showPicture(finding)),
    });
  }

  showNothing() {
    showNothingFound(this.report);
  }

  *addCards(findings) {
    const isUnfolded = byId("rule").value !== "";
    for (const [file, group] of groupsOf(findings)) {
      const body = element("div", {});
      this.addGroup(file || "No file", countsOf(group), body);
      const folded = new Map();
      const shown = new Map();
      for (const finding of group) {
        const count = shown.get(finding.id) ?? 0;
        shown.set(finding.id, count + 1);
        if (count >= kOfRule && !isUnfolded) {
          if (!folded.has(finding.id)) folded.set(finding.id, []);
          folded.get(finding.id).push(finding);
          continue;
        }
        body.append(this.card(finding));
        yield 1;
      }
      for (const rest of folded.values()) {
        body.append(this.fold(rest));
        yield rest.length;
      }
    }
  }

  /** A button that is replaced by the findings when it is pressed. */
  fold(findings) {
    const [{ id, name }] = findings;
    const button = element(
      "button",
      { type: "button", class: "fold" },
      `Show ${findings.length.toLocaleString("en")} more of ${id} ${name} in this file`,
    );
    button.addEventListener("click", () => {
      const cards = findings.slice(0, kAtOnce).map((finding) => this.card(finding));
      const rest = findings.slice(kAtOnce);
      button.replaceWith(...cards, ...(rest.length > 0 ? [this.fold(rest)] : []));
      cards[0].focus();
    });
    return button;
  }
}
