// SPDX-License-Identifier: BSD-3-Clause
// Downloads files to the computer of the user.
import { element } from "../common/dom.js";
import { zip } from "./zip.js";

/** Saves a file, or several as NAME.zip. */
export function download(files, name) {
  const [[path, bytes]] = files;
  const isOne = files.size === 1;
  const address = URL.createObjectURL(new Blob([isOne ? bytes : zip(files)]));
  element("a", { href: address, download: isOne ? path.replace(/.*\//, "") : `${name}.zip` }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
