// SPDX-License-Identifier: BSD-3-Clause
// Makes elements of the page. Names in models may look like markup, so text is only set as text.

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

export const counted = (number, thing) => `${number.toLocaleString("en")} ${thing}${number === 1 ? "" : "s"}`;

/** The nodes of a text in which names are between backticks. */
export function prose(text) {
  return text.split(/(`[^`]+`)/).map((part) => {
    const isName = part.length > 2 && part.startsWith("`") && part.endsWith("`");
    return isName ? element("code", {}, part.slice(1, -1)) : part;
  });
}
