// SPDX-License-Identifier: BSD-3-Clause
// Shows lines of a source with their marks, and the lines that a fix changes.
import { element, prose } from "../common/dom.js";

const kContext = 2; // lines before and after a mark
const kLongest = 400; // characters shown of a line
const kBefore = 120; // of these, before the first mark
const kBeside = 96; // characters; if mark and text together are shorter, the text begins below the mark

/** The lines of the sources, by their numbers. */
export class Sources {
  constructor(sources) {
    this.sources = sources;
    this.lines = new Map();
  }

  /** Whether the page omits the lines of a source because the limit of the page was reached. */
  isLeftOut(source) {
    return this.sources[source] === "";
  }

  of(source) {
    if (!this.lines.has(source)) {
      const lines = new Map();
      for (const { first, lines: text } of this.sources[source] || [])
        text.split("\n").forEach((line, index) => lines.set(first + index, line));
      this.lines.set(source, lines);
    }
    return this.lines.get(source);
  }
}

/** Columns count characters; indices count UTF-16 units. */
export function indexOf(line, column) {
  if (!/[\ud800-\udbff]/.test(line)) return Math.min(column - 1, line.length);
  let index = 0;
  for (let at = 1; at < column && index < line.length; ++at)
    index += line.codePointAt(index) > 0xffff ? 2 : 1;
  return index;
}

/** The part of a line that a mark covers: {begin, end, text, kind}. */
function rangeOf(mark, number, line) {
  const begin = number === mark.line ? indexOf(line, mark.column) : line.search(/\S|$/);
  const end = number === mark.end_line ? indexOf(line, mark.end_column) : line.length;
  const atLeast = begin < line.length ? begin + String.fromCodePoint(line.codePointAt(begin)).length : begin;
  return { begin, end: Math.max(end, Math.min(atLeast, line.length)), text: mark.text, kind: mark.kind };
}

/** The last line of a mark. A mark that ends with a line end belongs to the line before it. */
const lastLine = ({ line, end_line, end_column }) =>
  end_column === 1 && end_line > line ? end_line - 1 : end_line;

function linesOf(marks, lines) {
  const numbers = new Set();
  const add = (first, last) => {
    for (let number = first; number <= last; ++number) if (lines.has(number)) numbers.add(number);
  };
  for (const mark of marks) {
    const last = mark.kind === "other" ? mark.line : lastLine(mark);
    const context = mark.kind === "other" ? 0 : kContext;
    if (last - mark.line < 12) add(mark.line - context, last + context);
    else {
      add(mark.line - context, mark.line + 5);
      add(last - 2, last + context);
    }
  }
  return [...numbers].sort((a, b) => a - b);
}

/** The part of a long line that is shown. */
function partOf(line, ranges) {
  const first = Math.min(...ranges.map(({ begin }) => begin), line.length);
  const begin = line.length <= kLongest ? 0 : Math.max(0, Math.min(first - kBefore, line.length - kLongest));
  return { begin: Number.isFinite(begin) ? begin : 0, end: Math.min(line.length, begin + kLongest) };
}

function markedText(line, part, ranges) {
  const ends = new Set([part.begin, part.end]);
  for (const { begin, end } of ranges)
    for (const at of [begin, end]) if (at > part.begin && at < part.end) ends.add(at);
  const sorted = [...ends].sort((a, b) => a - b);
  const pieces = sorted.slice(0, -1).map((begin, index) => {
    const text = line.slice(begin, sorted[index + 1]);
    const over = ranges.filter((range) => range.begin <= begin && range.end > begin);
    const kind = over.find((range) => range.kind !== "other")?.kind ?? over[0]?.kind;
    return kind ? element("mark", { class: kind }, text) : text;
  });
  if (part.begin > 0) pieces.unshift("\u2026");
  if (part.end < line.length) pieces.push("\u2026");
  // The mark is behind the last character, for example in a file that ends too early.
  for (const { begin, kind } of ranges)
    if (begin >= line.length) pieces.push(element("mark", { class: kind }, " "));
  return pieces;
}

/** The text of a mark, below its beginning if there is room. */
function textRow({ begin, text, kind }, line, part) {
  const lead = `${part.begin > 0 ? "\u2026" : ""}${line.slice(part.begin, begin)}`;
  const fits = lead.length < kBeside && lead.length + text.length < kBeside + 24;
  return element(
    "div",
    { class: "row" },
    element("span", { class: "number" }),
    element(
      "span",
      { class: "text" },
      fits ? element("span", { class: "lead", "aria-hidden": "true" }, lead) : undefined,
      element("span", { class: `label ${kind}` }, "\u2514 ", ...prose(text)),
    ),
  );
}

function lineRows(number, line, ranges) {
  const part = partOf(line, ranges);
  const row = element(
    "div",
    { class: ranges.some(({ kind }) => kind !== "other") ? "row marked" : "row" },
    element("span", { class: "number", "aria-hidden": "true" }, String(number)),
    element("code", { class: "text" }, ...markedText(line, part, ranges)),
  );
  const told = ranges.filter(({ text }) => text).sort((a, b) => b.begin - a.begin);
  return [row, ...told.map((range) => textRow(range, line, part))];
}

/** `marks`: [{line, column, end_line, end_column, text, kind}], the main one first. */
export function excerpt(lines, marks) {
  const rows = [];
  let before;
  for (const number of linesOf(marks, lines)) {
    if (before !== undefined && number > before + 1)
      rows.push(element("div", { class: "row gap" }, element("span", { class: "number" }, "\u22ee")));
    before = number;
    const line = lines.get(number);
    const ranges = marks
      .filter((mark) => number >= mark.line && number <= (mark.kind === "other" ? mark.line : lastLine(mark)))
      .map((mark) => ({ ...rangeOf(mark, number, line), text: number === mark.line ? mark.text : "" }));
    rows.push(...lineRows(number, line, ranges));
  }
  return element("div", { class: "lines" }, ...rows);
}

/** The numbers of characters that two texts share at their beginning and at their end. */
function shared(a, b) {
  const most = Math.min(a.length, b.length);
  let front = 0;
  while (front < most && a[front] === b[front]) ++front;
  let back = 0;
  while (back < most - front && a[a.length - 1 - back] === b[b.length - 1 - back]) ++back;
  return [front, back];
}

function diffRow(kind, number, line, other) {
  const [front, back] = other === undefined ? [0, line.length] : shared(line, other);
  const changed = element("mark", { class: kind }, line.slice(front, line.length - back));
  const name = kind === "del" ? "del" : "ins";
  return element(
    "div",
    { class: `row ${kind}` },
    element("span", { class: "number", "aria-hidden": "true" }, String(number)),
    element("span", { class: "sign", "aria-hidden": "true" }, kind === "del" ? "\u2212" : "+"),
    element(
      name,
      { class: "text" },
      line.slice(0, front),
      changed.textContent ? changed : undefined,
      line.slice(line.length - back),
    ),
  );
}

function sameRow(number, line) {
  return element(
    "div",
    { class: "row" },
    element("span", { class: "number", "aria-hidden": "true" }, String(number)),
    element("span", { class: "sign" }),
    element("code", { class: "text" }, line),
  );
}

/** {line, before, after} of a fix as removed and added lines. */
export function diff({ line, before, after }) {
  const old = before.split("\n");
  const fresh = after.split("\n");
  const [front, back] = shared(old, fresh);
  const gone = old.slice(front, old.length - back);
  const come = fresh.slice(front, fresh.length - back);
  const isPaired = gone.length === come.length;
  return element(
    "div",
    { class: "lines" },
    ...old
      .slice(Math.max(0, front - kContext), front)
      .map((text, index, all) => sameRow(line + front - all.length + index, text)),
    ...gone.map((text, index) =>
      diffRow("del", line + front + index, text, isPaired ? come[index] : undefined),
    ),
    ...come.map((text, index) =>
      diffRow("ins", line + front + index, text, isPaired ? gone[index] : undefined),
    ),
    ...old
      .slice(old.length - back, old.length - back + kContext)
      .map((text, index) => sameRow(line + fresh.length - back + index, text)),
  );
}
