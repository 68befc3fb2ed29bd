// SPDX-License-Identifier: BSD-3-Clause
// The card of a finding.
import { element, prose } from "../common/dom.js";
import { diff, excerpt } from "./excerpt.js";

export const placeOf = ({ file, line, column }) => (file ? `${file}:${line}:${column}` : "");

const severityOf = (severity) => element("span", { class: `badge ${severity}` }, severity);

/** The lines of a place, or the reason why they are missing. */
function linesAt(place, marks, sources) {
  if (!place.file) return undefined;
  const lines = sources.of(place.source);
  if (lines.has(place.line)) return excerpt(lines, marks);
  const why = sources.isLeftOut(place.source)
    ? "The lines of this file are not in the page, which would be too large with them. Open the file at this place."
    : "There are no lines to show: the file is empty or could not be read.";
  return element("p", { class: "soft" }, why);
}

function source(place, pointer, lines) {
  return element(
    "figure",
    {},
    element(
      "figcaption",
      {},
      element("span", { class: "place" }, placeOf(place)),
      pointer ? element("span", { class: "pointer" }, pointer) : undefined,
    ),
    lines,
  );
}

/** The lines of the finding, and those of its labels in other files. */
function figures(finding, sources) {
  if (!finding.file) return [];
  const labels = finding.labels ?? [];
  const hasLines = sources.of(finding.source).has(finding.line);
  const isBeside = (label) => hasLines && label.source === finding.source;
  const marks = [
    { ...finding, text: finding.caret ?? "", kind: finding.severity },
    ...labels.filter(isBeside).map((label) => ({ ...label, text: label.message, kind: "other" })),
  ];
  const elsewhere = labels
    .filter((label) => !isBeside(label))
    .map((label) => [
      element("p", { class: "remark" }, element("b", {}, "note"), " ", ...prose(label.message)),
      label.file
        ? source(label, "", linesAt(label, [{ ...label, text: "", kind: "other" }], sources))
        : undefined,
    ]);
  return [source(finding, finding.pointer, linesAt(finding, marks, sources)), ...elsewhere.flat()];
}

function fixOf({ fix: { is_safe: isSafe, hunks }, file }, onFix) {
  const kind = isSafe ? "Safe fix" : "Unsafe fix";
  const meaning = isSafe
    ? "it keeps the meaning of the file in every program that loads it"
    : "it may change the meaning of the file; read it before you apply it";
  const parts = hunks.flatMap((hunk) => [
    hunk.file === file ? undefined : element("p", { class: "remark" }, `${hunk.file}:`),
    hunk.before === hunk.after
      ? element("p", { class: "soft" }, `Line ${hunk.line}: only characters that are not visible change.`)
      : diff(hunk),
    hunk.is_cut
      ? element("p", { class: "soft" }, "The fix goes on; smurf-lint --diff shows all of it.")
      : undefined,
  ]);
  return element(
    "details",
    { class: "fix", open: true },
    element("summary", {}, element("b", { class: isSafe ? "safe" : "unsafe" }, kind), `: ${meaning}`),
    ...parts.filter((part) => part !== undefined),
    onFix && element("button", { type: "button", class: "apply", onclick: onFix }, "Apply this fix"),
  );
}

function toleranceOf({ value, unit, meaning }, id) {
  const amount = unit ? `${value} ${unit}` : `${value}`;
  return `${amount}: ${meaning}. The configuration can set another: \`tolerances: {${id}: ${value}}\`.`;
}

function explanation(rule) {
  const parts = [element("p", {}, ...prose(rule.summary))];
  const add = (title, ...content) => parts.push(element("h4", {}, title), ...content);
  if (rule.why) add("Why it matters", element("p", {}, ...prose(rule.why)));
  if (rule.facts) {
    const facts = rule.facts.map(({ text, evidence }) =>
      element(
        "li",
        {},
        ...prose(text),
        evidence ? element("span", { class: "soft" }, ` (${evidence})`) : undefined,
      ),
    );
    add("What programs make of it", element("ul", {}, ...facts));
  }
  add("What to do", element("p", {}, ...prose(rule.remedy)));
  if (rule.tolerance) add("Tolerance", element("p", {}, ...prose(toleranceOf(rule.tolerance, rule.id))));
  return parts;
}

/** Its contents are made when it is first opened, because a page may have thousands of cards. */
function explanationOf(rule) {
  const details = element(
    "details",
    { class: "why" },
    element("summary", {}, `About ${rule.id} ${rule.name}`),
  );
  const fill = () => details.append(...explanation(rule));
  details.addEventListener("toggle", fill, { once: true });
  return details;
}

/** The buttons at the right of the title: the rule, the picture if there is one, and the place in an editor. */
function tools(finding, { onRule, onPicture, onEdit }) {
  const attributes = { type: "button", class: "rule", title: "Show the findings of this rule only" };
  const rule = element(
    "button",
    { ...attributes, onclick: () => onRule(finding.id) },
    `${finding.id} ${finding.name}`,
  );
  const picture =
    onPicture && element("button", { type: "button", class: "pictured", onclick: onPicture }, "Show in 3D");
  const edit =
    onEdit &&
    finding.file &&
    element("button", { type: "button", class: "edited", onclick: () => onEdit(finding) }, "Edit");
  return element("div", { class: "tools" }, rule, picture || undefined, edit || undefined);
}

/** A button that copies the command with which a note begins; undefined for other notes. */
function copyButton(note) {
  const [, command] = note.match(/^`(smurf-lint [^`]+)`/) ?? [];
  if (!command) return undefined;
  const button = element("button", { type: "button", class: "copy" }, "Copy the command");
  button.addEventListener("click", async () => {
    const isCopied = await navigator.clipboard?.writeText(command).then(
      () => true,
      () => false,
    );
    button.textContent = isCopied ? "Copied" : "Select and copy it by hand";
  });
  return button;
}

/**
 * `actions`: onRule shows the findings of a rule, onPicture shows the link or joint of the finding. A page that can
 * change the files also has onEdit, which opens the place of a finding, and onFix, which applies its fix.
 */
export function card(finding, report, actions) {
  const title = `title-${finding.number}`;
  const remarks = [
    ...(finding.notes ?? []).map((note) => ["note", note]),
    ...(finding.help ? [["help", finding.help]] : []),
  ].map(([kind, text]) =>
    element("p", { class: "remark" }, element("b", {}, kind), " ", ...prose(text), copyButton(text)),
  );
  return element(
    "article",
    {
      class: `card finding ${finding.severity}`,
      id: `finding-${finding.number}`,
      tabindex: "-1",
      "aria-labelledby": title,
    },
    element(
      "div",
      { class: "head" },
      element("h3", { id: title }, severityOf(finding.severity), " ", ...prose(finding.message)),
      tools(finding, actions),
    ),
    ...figures(finding, report.sources),
    ...remarks,
    finding.fix?.hunks.length > 0
      ? fixOf(finding, actions.onFix && (() => actions.onFix(finding)))
      : undefined,
    explanationOf(report.rules[finding.id]),
  );
}
