// SPDX-License-Identifier: BSD-3-Clause
// The card of a difference: its subject, both values and both places.
import { element } from "../common/dom.js";

function row(version, text, place) {
  if (text === undefined && place === undefined) return undefined;
  return element(
    "div",
    { class: "version" },
    element("span", { class: `swatch ${version}`, "aria-hidden": "true" }),
    element("b", {}, version),
    element("span", { class: "value" }, text ?? ""),
    element("span", { class: "place" }, place ?? ""),
  );
}

/** Chooses the difference on a click, except when the click selects text or presses a button. */
function onClick(event, choose) {
  const isElsewhere = event.target.closest("button") || String(window.getSelection()) !== "";
  if (!isElsewhere) choose();
}

export function card(difference, onPicture) {
  const { number, change, subject, label, effect, percentage } = difference;
  const title = `title-${number}`;
  const picture =
    onPicture && element("button", { type: "button", class: "pictured", onclick: onPicture }, "Show in 3D");
  const made = element(
    "article",
    {
      class: `card difference ${change}`,
      id: `difference-${number}`,
      tabindex: "-1",
      "aria-labelledby": title,
      ...(onPicture ? { onclick: (event) => onClick(event, onPicture) } : {}),
    },
    element(
      "div",
      { class: "head" },
      element(
        "h3",
        { id: title },
        element("span", { class: `badge ${change}` }, change),
        " ",
        label === undefined ? subject : `${subject}: ${label}`,
      ),
      picture && element("div", { class: "tools" }, picture),
    ),
    row("old", difference.old_text, difference.old_place),
    row("new", difference.new_text, difference.new_place),
  );
  const remarks = [percentage, effect].filter(Boolean).join(", ");
  if (remarks) made.append(element("p", { class: "remark" }, remarks));
  return made;
}
