// SPDX-License-Identifier: BSD-3-Clause
// Above the list: the counts of findings, and whether each reader loads the files.
import { byId, counted, element, prose } from "../common/dom.js";
import { placeOf } from "./finding.js";

const line = (text) => element("p", {}, ...prose(text));

function checked({ files, models, scenes, suppressed, links }) {
  const parts = [models > 0 && counted(models, "model"), scenes > 0 && counted(scenes, "scene")].filter(
    Boolean,
  );
  const lines = [`${counted(files, "file")} checked${parts.length > 0 ? ` (${parts.join(", ")})` : ""}.`];
  if (suppressed > 0)
    lines.push(`${counted(suppressed, "finding")} suppressed by comments, the configuration or a baseline.`);
  if (links > 0)
    lines.push(
      `${counted(links, "symbolic link")} that ${links === 1 ? "leads out of the folder was" : "lead out of the folder were"} not followed.`,
    );
  return lines.join(" ");
}

export function showSummary({ diagnostics, summary, tool, remarks }) {
  const files = new Set(diagnostics.map(({ file }) => file)).size;
  const found =
    diagnostics.length === 0
      ? "No findings"
      : `${counted(diagnostics.length, "finding")} in ${counted(files, "file")}`;
  byId("title").textContent = found;
  document.title = `${found} - ${tool.name}`;
  byId("counts").replaceChildren(line(checked(summary)), ...remarks.split("\n").filter(Boolean).map(line));
  byId("made").textContent = `Report of ${tool.name} ${tool.version}.`;
}

export function showTargets({ targets = {}, diagnostics }, onTarget) {
  const rows = Object.entries(targets).map(([name, { title, verdict, answer, first }]) => {
    const count = diagnostics.filter(({ effects = {} }) => effects[name]).length;
    const why = first && [
      element("span", { class: "place" }, placeOf(first)),
      ...prose(` ${first.makes} (${first.id})`),
    ];
    return element(
      "li",
      {},
      element("b", {}, title),
      element("span", { class: `verdict ${verdict}` }, answer),
      why ? element("span", { class: "reason" }, ...why) : undefined,
      count > 0
        ? element(
            "button",
            { type: "button", onclick: () => onTarget(name) },
            `Show ${counted(count, "finding")}`,
            element("span", { class: "unseen" }, ` for ${title}`),
          )
        : undefined,
    );
  });
  byId("target-list").replaceChildren(...rows);
  byId("targets").hidden = rows.length === 0;
}

/** The text of a page without findings. */
export function showNothingFound({ targets, summary, tool }) {
  const lines = [];
  if (targets) lines.push("Everything that was checked is fine for these programs.");
  else if (tool.name === "smurf-lint")
    lines.push(
      "To learn whether a certain program loads the files, check again with `--target`:",
      "`smurf-lint --target mujoco,gazebo --format html=report.html .`",
    );
  if (summary.suppressed > 0)
    lines.push(
      "Some findings are suppressed; `--no-ignores` shows those that comments or the baseline suppress.",
    );
  byId("list").replaceChildren(
    element("div", { class: "nothing" }, element("h2", {}, "There is nothing to repair"), ...lines.map(line)),
  );
}
