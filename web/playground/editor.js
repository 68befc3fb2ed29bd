// SPDX-License-Identifier: BSD-3-Clause
// The text of one file in a plain text field.
import { byId } from "../common/dom.js";
import { indexOf } from "../report/excerpt.js";
import { bytesOf, sizeOf, textOf } from "./bytes.js";

const kMostText = 2e6; // bytes; browsers are slow with more

/** Text fields remove carriage returns, so a file with mixed line ends would be changed. */
function lineEndOf(text) {
  if (!text.includes("\r")) return "\n";
  return /\r(?!\n)|(?<!\r)\n/.test(text) ? undefined : "\r\n";
}

/** The reason why a file cannot be edited; "" if it can. */
function obstacleOf(bytes, text) {
  if (text === undefined) return `This file is no text (${sizeOf(bytes.length)}).`;
  if (bytes.length > kMostText) return `This file is too large to be edited here (${sizeOf(bytes.length)}).`;
  return lineEndOf(text) === undefined ? "This file mixes line ends, so it cannot be edited here." : "";
}

export class Editor {
  /** `onEdit(name, bytes)` is called at each change. */
  constructor(onEdit) {
    this.field = byId("text");
    this.field.addEventListener("input", () => {
      this.bytes = bytesOf(this.field.value.replaceAll("\n", this.lineEnd));
      onEdit(this.name, this.bytes);
    });
  }

  /** Shows a file; without bytes, clears the editor. */
  show(name, bytes) {
    byId("editor").hidden = bytes === undefined;
    if (bytes === this.bytes && name === this.name) return;
    this.name = name;
    this.bytes = bytes;
    if (bytes === undefined) return;
    byId("edited-name").textContent = name;
    const text = textOf(bytes);
    const obstacle = obstacleOf(bytes, text);
    this.lineEnd = lineEndOf(text ?? "") ?? "\n";
    byId("obstacle").textContent = obstacle;
    this.field.readOnly = obstacle !== "";
    this.field.value = text === undefined || bytes.length > kMostText ? "" : text;
  }

  /** Selects the marked text of a finding. */
  select({ line, column, end_line: endLine, end_column: endColumn }) {
    const lines = this.field.value.split("\n");
    const at = (number, column) => {
      const before = lines.slice(0, number - 1).reduce((sum, text) => sum + text.length + 1, 0);
      return before + indexOf(lines[number - 1] ?? "", column);
    };
    const height = parseFloat(getComputedStyle(this.field).lineHeight);
    this.field.focus({ preventScroll: true });
    this.field.setSelectionRange(at(line, column), at(endLine, endColumn));
    this.field.scrollTop = (line - 1) * height - this.field.clientHeight / 3;
    this.field.scrollIntoView({ block: "nearest" });
  }
}
