// SPDX-License-Identifier: BSD-3-Clause
// The search and the filters above a list.
import { byId, counted, element } from "./dom.js";

/** The number of items for each value that `valuesOf` returns, the largest first. */
function tally(items, valuesOf) {
  const counts = new Map();
  for (const item of items)
    for (const value of valuesOf(item)) counts.set(value, (counts.get(value) ?? 0) + 1);
  return counts;
}

export class Filters {
  /**
   * items: the filtered items, each with its `number` in the list; noun: the word for an item
   * textOf: returns the text of an item that is searched
   * toggle: {host, values, valueOf, label}: one button for each value of the items; label(count, value) is its text
   * selects: [{id, all, valuesOf, nameOf, least}]: drop-down lists, hidden if there are fewer than `least` values
   */
  constructor({ items, noun, textOf, toggle, selects }, onChange) {
    Object.assign(this, { items, noun, textOf, toggle, selects, onChange });
    this.texts = [];
    this.hidden = new Set(); // values that the toggle switches off
    this.addButtons();
    for (const select of selects) this.addSelect(select);
    byId("words").addEventListener("input", () => this.change());
    byId("clear").addEventListener("click", () => this.clear());
    byId("filters").addEventListener("submit", (event) => event.preventDefault());
    byId("filters").hidden = items.length === 0;
  }

  addButtons() {
    const { host, values, valueOf } = this.toggle;
    const counts = tally(this.items, (item) => [valueOf(item)]);
    this.shown = values.filter((value) => counts.has(value));
    this.buttons = this.shown.map((value) => {
      const button = element(
        "button",
        {
          type: "button",
          class: `toggle ${value}`,
          "aria-pressed": "true",
          title: `Show or hide: ${value}`,
        },
        this.toggle.label(counts.get(value), value),
      );
      button.addEventListener("click", () => this.setShown(value, this.hidden.has(value)));
      return button;
    });
    byId(host).append(...this.buttons);
  }

  setShown(value, isShown) {
    if (isShown) this.hidden.delete(value);
    else this.hidden.add(value);
    this.change();
  }

  addSelect({ id, all, valuesOf, nameOf, least = 2 }) {
    const sorted = [...tally(this.items, valuesOf)].sort((a, b) => b[1] - a[1]);
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

  fields() {
    return ["words", ...this.selects.map(({ id }) => id)].map(byId);
  }

  clear() {
    this.hidden.clear();
    for (const field of this.fields()) field.value = "";
    this.change();
  }

  /** The current choices, for restore() of the filters of another list. */
  get state() {
    return { hidden: [...this.hidden], values: this.fields().map(({ id, value }) => [id, value]) };
  }

  /** Restores the choices that exist in this list. */
  restore({ hidden, values }) {
    this.hidden = new Set(hidden.filter((value) => this.shown.includes(value)));
    for (const [id, value] of values) {
      byId(id).value = value;
      if (byId(id).value !== value) byId(id).value = "";
    }
    this.change();
  }

  isNarrowed() {
    return this.hidden.size > 0 || this.fields().some((field) => field.value !== "");
  }

  /** The items that match all filters. */
  chosen() {
    const words = byId("words").value.toLowerCase().split(/\s+/).filter(Boolean);
    const wanted = this.selects
      .map(({ id, valuesOf }) => ({ value: byId(id).value, valuesOf }))
      .filter(({ value }) => value !== "");
    const hasWords = (item) => {
      this.texts[item.number] ??= this.textOf(item).toLowerCase();
      return words.every((word) => this.texts[item.number].includes(word));
    };
    return this.items.filter(
      (item) =>
        !this.hidden.has(this.toggle.valueOf(item)) &&
        wanted.every(({ value, valuesOf }) => valuesOf(item).includes(value)) &&
        (words.length === 0 || hasWords(item)),
    );
  }

  change() {
    this.buttons.forEach((button, index) => {
      button.setAttribute("aria-pressed", String(!this.hidden.has(this.shown[index])));
    });
    byId("clear").hidden = !this.isNarrowed();
    const chosen = this.chosen();
    const all = this.items.length;
    byId("status").textContent =
      chosen.length === all ? "" : `${chosen.length.toLocaleString("en")} of ${counted(all, this.noun)}`;
    this.onChange(chosen);
  }
}
