// SPDX-License-Identifier: BSD-3-Clause
// A page with a list of cards, filters and keys. Cards are made when they are first shown.
import { byId, counted, element } from "./dom.js";
import { Filters } from "./filters.js";

export const kAtOnce = 200; // cards that are shown before the user asks for more

/** Derived classes have addCards(items), a generator that adds cards and yields their number, and showNothing(). */
export class ListPage {
  /** `noun`: the word for an item, also the class of its card; `filters`: see Filters; `signal` removes the key handlers. */
  constructor(items, noun, filters, signal) {
    this.items = items;
    this.noun = noun;
    items.forEach((item, number) => (item.number = number));
    this.filters = new Filters({ items, noun, ...filters }, (chosen) => this.show(chosen));
    byId("more").addEventListener("click", () => this.addMore(kAtOnce));
    byId("keys").hidden = items.length === 0;
    document.addEventListener("keydown", (event) => this.onKey(event), { signal });
  }

  show(items) {
    byId("list").replaceChildren();
    this.cards = this.addCards(items);
    this.left = items.length;
    if (this.items.length === 0) this.showNothing();
    else if (items.length === 0) this.showNoMatch();
    this.addMore(kAtOnce);
  }

  showNoMatch() {
    const clear = element(
      "button",
      { type: "button", onclick: () => this.filters.clear() },
      `Show all ${this.noun}s`,
    );
    byId("list").append(
      element(
        "div",
        { class: "nothing" },
        element("h2", {}, `No ${this.noun} is like that`),
        element("p", {}, "Search for fewer words, or choose less."),
        clear,
      ),
    );
  }

  /** A part of the list that can be closed. Its cards belong into `body`. */
  addGroup(title, counts, body) {
    const summary = element("summary", {}, element("h2", {}, title), ...counts);
    byId("list").append(element("details", { class: "group", open: true }, summary, body));
  }

  /** Adds more cards. False when all are shown. */
  addMore(number) {
    let isDone = false;
    for (let added = 0; added < number && !isDone; ++added) {
      const { done, value } = this.cards.next();
      isDone = done;
      this.left -= value ?? 0;
    }
    byId("more").hidden = this.left === 0;
    byId("more").textContent = `Show more (${counted(this.left, this.noun)} left)`;
    return this.left > 0;
  }

  go(step) {
    const all = [...document.querySelectorAll(".card")].filter((each) => each.checkVisibility());
    const here = document.activeElement.closest(".card");
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

  /** The item whose card has the focus. */
  focused() {
    const here = document.activeElement.closest(".card");
    return here && this.items[Number(here.id.split("-").at(-1))];
  }

  async showPicture(item) {
    if (!item) return;
    await this.picture.show(item);
    byId(`${this.noun}-${item.number}`)?.scrollIntoView({ block: "nearest" });
  }

  /** Leaves an empty text field, else closes the picture, else clears the filters. */
  goBack(field) {
    if (field && byId("words").value === "") field.blur();
    else if (!field && this.picture.close?.()) return;
    else this.filters.clear();
  }

  keys() {
    return {
      "/": () => byId("words").focus(),
      j: () => this.go(1),
      k: () => this.go(-1),
      v: () => this.showPicture(this.focused()),
    };
  }

  onKey(event) {
    const isTyping = event.target.matches("input, select, textarea");
    if (event.ctrlKey || event.metaKey || event.altKey || (isTyping && event.key !== "Escape")) return;
    const keys = { ...this.keys(), Escape: () => this.goBack(isTyping && event.target) };
    if (!keys[event.key] || this.items.length === 0) return;
    event.preventDefault();
    keys[event.key]();
  }
}
