// SPDX-License-Identifier: BSD-3-Clause
// The page of differences: the JSON report with these members added (libsmurf/src/diff/report_json.cpp):
// picture: the page of smurfs-flatten --format html with both versions; absent when there is none
// old_title, new_title: `old` and `new` for people
// differences: with `group`, `subject`, `label`, `old_text`, `new_text`, `percentage`, `old_place` and `new_place` for
//   people, and `old_model` and `new_model`: the compared models, by their index in the picture among those of a version
import { byId, counted, element } from "../common/dom.js";
import { ListPage } from "../common/list.js";
import { card } from "./difference.js";
import { OldNames } from "./pairs.js";
import { Picture } from "./picture.js";

const kChanges = ["added", "removed", "renamed", "changed"];
const kFile = "the file";

const groupOf = ({ group }) => group || kFile;

function textOf({ change, subject, label, effect, ...rest }) {
  const { old_text: oldText, new_text: newText, old_place: oldPlace, new_place: newPlace } = rest;
  return [change, subject, label, oldText, newText, oldPlace, newPlace, effect].join("\n");
}

const kFilters = {
  textOf,
  toggle: {
    host: "changes",
    values: kChanges,
    valueOf: ({ change }) => change,
    label: (count, change) => `${count.toLocaleString("en")} ${change}`,
  },
  selects: [{ id: "kind", all: "All kinds", valuesOf: (one) => [groupOf(one)], nameOf: (kind) => kind }],
};

class Page extends ListPage {
  constructor(report) {
    super(report.differences, "difference", kFilters);
    this.report = report;
    this.picture = new Picture(report.picture, new OldNames(report.differences));
    byId("picture-key").hidden = !report.picture;
    this.showSummary();
    this.filters.change();
  }

  showSummary() {
    const { differences, tool } = this.report;
    const found = differences.length === 0 ? "No differences" : counted(differences.length, "difference");
    byId("title").textContent = found;
    document.title = `${found} - ${tool.name}`;
    byId("old-name").textContent = this.report.old_title;
    byId("new-name").textContent = this.report.new_title;
    byId("made").textContent = `Report of ${tool.name} ${tool.version}.`;
  }

  showNothing() {
    byId("list").append(
      element(
        "div",
        { class: "nothing" },
        element("h2", {}, "Nothing differs for the robot"),
        element("p", {}, "Formatting, comments, order, and values that equal the default are not compared."),
      ),
    );
  }

  keys() {
    return { ...super.keys(), ...this.picture.keys() };
  }

  async showPicture(difference) {
    if (!difference) return;
    document.querySelector("[aria-current]")?.removeAttribute("aria-current");
    byId(`difference-${difference.number}`)?.setAttribute("aria-current", "true");
    await super.showPicture(difference);
  }

  *addCards(differences) {
    const groups = new Map();
    for (const one of differences) {
      if (!groups.has(groupOf(one))) groups.set(groupOf(one), []);
      groups.get(groupOf(one)).push(one);
    }
    for (const [kind, group] of groups) {
      const body = element("div", {});
      const count = element("span", { class: "count" }, counted(group.length, "difference"));
      this.addGroup(kind, [count], body);
      for (const one of group) {
        body.append(card(one, this.picture.isShown(one) ? () => this.showPicture(one) : undefined));
        yield 1;
      }
    }
  }
}

window.smurfDiff = new Page(JSON.parse(byId("report").textContent));
document.documentElement.dataset.ready = "true";
