// SPDX-License-Identifier: BSD-3-Clause
// Elements of the page. Text is only ever set as text: names in models may look like markup.

export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (value === true) made.setAttribute(key, "");
    else if (value !== false && value !== undefined) made.setAttribute(key, value);
  }
  made.append(...children.filter((child) => child !== undefined));
  return made;
}

export const byId = (id) => document.getElementById(id);

/** 1234.5678 as "1234.57": as many digits as people read. */
export function short(value) {
  if (value === 0 || !Number.isFinite(value)) return String(value ?? "unknown");
  if (Math.abs(value) < 5e-7) return "0";
  return String(Number(value.toPrecision(Math.abs(value) < 1e4 ? 5 : 7)));
}

export const counted = (number, thing) => `${number.toLocaleString("en")} ${thing}${number === 1 ? "" : "s"}`;
