// SPDX-License-Identifier: BSD-3-Clause
// Shows a report: its summary, filters, findings and picture.
import { byId, counted, element } from "../common/dom.js";
import { Sources } from "./excerpt.js";
import { Filters, kSeverities } from "./filters.js";
import { card } from "./finding.js";
import { Picture } from "./picture.js";
import { showNothingFound, showSummary, showTargets } from "./overview.js";

const kAtOnce = 200; // findings shown before one asks for more
const kOfRule = 3; // findings of a rule in a file before the others are folded

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

/** `actions`: what else the cards of findings offer, see finding.js. `signal` ends the keys of the page. */
export class Page {
  constructor(report, { actions = {}, signal } = {}) {
    this.report = report;
    this.actions = actions;
    report.diagnostics.forEach((finding, number) => (finding.number = number));
    report.sources = new Sources(report.sources);
    this.picture = new Picture(report.picture);
    byId("picture-key").hidden = !report.picture;
    this.filters = new Filters(report, (findings) => this.show(findings));
    showSummary(report);
    showTargets(report, (target) => this.filters.choose("target", target));
    byId("more").addEventListener("click", () => this.addMore(kAtOnce));
    byId("keys").hidden = report.diagnostics.length === 0;
    document.addEventListener("keydown", (event) => this.onKey(event), { signal });
    this.filters.change();
  }

  card(finding) {
    return card(finding, this.report, {
      ...this.actions,
      onRule: (rule) => this.filters.choose("rule", rule),
      onPicture: this.picture.find(finding) && (() => this.showPicture(finding)),
    });
  }

  show(findings) {
    byId("list").replaceChildren();
    this.cards = this.addCards(groupsOf(findings), byId("rule").value !== "");
    this.left = findings.length;
    if (this.report.diagnostics.length === 0) showNothingFound(this.report);
    else if (findings.length === 0) this.showNoMatch();
    this.addMore(kAtOnce);
  }

  showNoMatch() {
    const clear = element(
      "button",
      { type: "button", onclick: () => this.filters.clear() },
      "Show all findings",
    );
    byId("list").append(
      element(
        "div",
        { class: "nothing" },
        element("h2", {}, "No finding is like that"),
        element("p", {}, "Search for fewer words, or choose less."),
        clear,
      ),
    );
  }

  /** Adds a card at each step. */
  *addCards(groups, isUnfolded) {
    for (const [file, findings] of groups) {
      const body = element("div", {});
      const title = element("h2", {}, file || "No file");
      byId("list").append(
        element(
          "details",
          { class: "file", open: true },
          element("summary", {}, title, ...countsOf(findings)),
          body,
        ),
      );
      const folded = new Map();
      const shown = new Map();
      for (const finding of findings) {
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

  /** A button that becomes the findings. */
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

  /** False when there are no more. */
  addMore(number) {
    let isDone = false;
    for (let added = 0; added < number && !isDone; ++added) {
      const { done, value } = this.cards.next();
      isDone = done;
      this.left -= value ?? 0;
    }
    byId("more").hidden = this.left === 0;
    byId("more").textContent = `Show more (${counted(this.left, "finding")} left)`;
    return this.left > 0;
  }

  go(step) {
    const all = [...document.querySelectorAll(".finding")].filter((each) => each.checkVisibility());
    const here = document.activeElement.closest(".finding");
    const at = here
      ? all.indexOf(here) + step
      : all.findIndex((each) => each.getBoundingClientRect().bottom > 60);
    if (at >= all.length && !byId("more").hidden) {
      this.addMore(kAtOnce);
      this.go(step);
      return;
    }
    all[Math.min(Math.max(at, 0), all.length - 1)]?.focus();
    if (this.picture.isOpen) this.showPicture(this.focused());
  }

  /** The finding with the focus. */
  focused() {
    const here = document.activeElement.closest(".finding");
    return here && this.report.diagnostics[Number(here.id.split("-").at(-1))];
  }

  async showPicture(finding) {
    if (!finding) return;
    await this.picture.show(finding);
    byId(`finding-${finding.number}`)?.scrollIntoView({ block: "nearest" });
  }

  /** From what one types in, else from the picture, else from the filters. */
  goBack(field) {
    if (field && byId("words").value === "") field.blur();
    else if (this.picture.isOpen && !field) this.picture.close();
    else this.filters.clear();
  }

  onKey(event) {
    const isTyping = event.target.matches("input, select, textarea");
    if (event.ctrlKey || event.metaKey || event.altKey || (isTyping && event.key !== "Escape")) return;
    const keys = {
      "/": () => byId("words").focus(),
      j: () => this.go(1),
      k: () => this.go(-1),
      v: () => this.showPicture(this.focused()),
      Escape: () => this.goBack(isTyping && event.target),
    };
    if (!keys[event.key] || this.report.diagnostics.length === 0) return;
    event.preventDefault();
    keys[event.key]();
  }
}
