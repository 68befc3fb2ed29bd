// SPDX-License-Identifier: BSD-3-Clause
// A bar above the tables of a page with many rows: a field that leaves the rows with all of its words, and lists for columns
// with few values, such as the severity.
const MOST_ROWS = 40;
const MOST_VALUES = 8;
const CHOSEN = ["severity", "effect"];

const text = (cell) => cell?.textContent.trim() ?? "";

/** {row, table, values: {column: text}} of all rows of a table. */
function rows_of(table) {
  const heads = [...table.tHead.rows[0].cells].map((head) => text(head).toLowerCase());
  return [...table.tBodies[0].rows].map((row) => ({
    row,
    table,
    words: row.textContent.toLowerCase(),
    values: Object.fromEntries(heads.map((head, at) => [head, text(row.cells[at])])),
  }));
}

/** A list of the values of a column; none if it has one value, or many. */
function list_of(column, rows) {
  const values = [...new Set(rows.map(({ values }) => values[column]))].filter(Boolean).sort();
  if (values.length < 2 || values.length > MOST_VALUES) return [];
  const list = document.createElement("select");
  list.name = column;
  list.setAttribute("aria-label", column);
  list.append(new Option(`any ${column}`, ""), ...values.map((value) => new Option(value, value)));
  return [list];
}

/** A table, with the frame that Material gives it, and what is above it up to its heading. */
function part_of(table) {
  const part = [table.closest(".md-typeset__scrollwrap") ?? table];
  let above = part[0].previousElementSibling;
  while (above && /^(H[2-6]|P)$/.test(above.tagName)) {
    part.push(above);
    if (above.tagName !== "P") break;
    above = above.previousElementSibling;
  }
  return part;
}

function add_bar(tables) {
  const rows = tables.flatMap(rows_of);
  if (rows.length < MOST_ROWS) return;
  const field = Object.assign(document.createElement("input"), {
    type: "search",
    placeholder: "Filter the rows of this page",
  });
  field.setAttribute("aria-label", field.placeholder);
  const lists = CHOSEN.flatMap((column) => list_of(column, rows));
  const count = document.createElement("span");
  count.setAttribute("role", "status");
  const bar = Object.assign(document.createElement("form"), { className: "table-filter" });
  bar.append(field, ...lists, count);
  bar.addEventListener("submit", (event) => event.preventDefault());
  bar.addEventListener("input", () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const shown = new Map(tables.map((table) => [table, 0]));
    for (const { row, table, words: known, values } of rows) {
      const is_chosen = lists.every((list) => list.value === "" || values[list.name] === list.value);
      row.hidden = !is_chosen || !words.every((word) => known.includes(word));
      if (!row.hidden) shown.set(table, shown.get(table) + 1);
    }
    for (const [table, left] of shown) {
      for (const one of part_of(table)) one.hidden = left === 0;
    }
    const all = [...shown.values()].reduce((sum, one) => sum + one, 0);
    count.textContent = all === rows.length ? "" : `${all} of ${rows.length}`;
  });
  document.querySelector("article h1").after(bar);
}

add_bar([...document.querySelectorAll("article table")].filter((table) => table.tHead && table.tBodies[0]));
