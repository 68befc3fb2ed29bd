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

/** The day on which the page was written, if it was not made just now: "27 November 2026". */
function dayOf(page) {
  const written = new Date(page.lastModified);
  return location.protocol !== "file:" || Number.isNaN(written.getTime())
    ? ""
    : written.toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" });
}

export function showSummary({ diagnostics, summary, tool, remarks }) {
  const files = [...new Set(diagnostics.map(({ file }) => file))];
  const where = files.length === 1 && files[0] ? files[0].split("/").at(-1) : counted(files.length, "file");
  const found =
    diagnostics.length === 0 ? "No findings" : `${counted(diagnostics.length, "finding")} in ${where}`;
  byId("title").textContent = found;
  document.title = `${found} - ${tool.name}`;
  byId("counts").replaceChildren(line(checked(summary)), ...remarks.split("\n").filter(Boolean).map(line));
  const day = dayOf(document);
  byId("made").textContent = `Report of ${tool.name} ${tool.version}${day && `, written on ${day}`}.`;
}

const kWords = { takes: "loads", loses: "with losses", unknown: "not known", refuses: "fails" };
const kMostRobots = 30; // at first

const failuresOf = ({ answers }) => [
  answers.filter((answer) => answer === "refuses").length,
  answers.filter((answer) => answer === "unknown").length,
  answers.filter((answer) => answer === "loses").length,
];

/** The robots of a folder with the numbers of their findings, and what each program makes of them, the worst first. */
export function showRobots({ robots = [], targets = {}, diagnostics }, onFile) {
  const host = byId("robot-table");
  if (!host) return; // the playground has a list of its own
  byId("robots").hidden = robots.length < 2;
  const numberOf = ({ file }, wanted) =>
    diagnostics.filter((finding) => finding.file === file && finding.severity === wanted).length;
  const rows = robots.map((robot) => ({
    ...robot,
    counts: [...failuresOf(robot), numberOf(robot, "error"), numberOf(robot, "warning")],
  }));
  rows.sort((a, b) => b.counts.map((count, at) => count - a.counts[at]).find((order) => order !== 0) ?? 0);
  const nameOf = ({ file }) =>
    diagnostics.some((finding) => finding.file === file)
      ? element("button", { type: "button", class: "link", onclick: () => onFile(file) }, file)
      : file;
  const line = (row) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, nameOf(row)),
      ...row.counts.slice(-2).map((count) => element("td", { class: "number" }, count || "")),
      ...row.answers.map((answer) => element("td", { class: `verdict ${answer}` }, kWords[answer])),
    );
  const loaded = (at) => robots.filter(({ answers }) => ["takes", "loses"].includes(answers[at])).length;
  const titles = Object.values(targets).map(({ title }) => title);
  const show = (shown) => {
    host.replaceChildren(
      element(
        "thead",
        {},
        element(
          "tr",
          {},
          ...["Robot", "Errors", "Warnings", ...titles].map((title) =>
            element("th", { scope: "col" }, title),
          ),
        ),
      ),
      element("tbody", {}, ...shown.map(line)),
    );
    if (titles.length > 0)
      host.append(
        element(
          "tfoot",
          {},
          element(
            "tr",
            {},
            element("th", { scope: "row", colspan: 3 }, "Robots that load"),
            ...titles.map((_, at) => element("td", {}, `${loaded(at)} of ${robots.length}`)),
          ),
        ),
      );
  };
  const more = byId("all-robots");
  more.hidden = rows.length <= kMostRobots;
  more.textContent = `Show all ${counted(rows.length, "robot")}`;
  more.onclick = () => {
    more.hidden = true;
    show(rows);
  };
  show(rows.slice(0, kMostRobots));
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

/** The text of a page without findings. `advice`: for people without a command line. */
export function showNothingFound({ targets, summary, tool, advice }) {
  const lines = [];
  if (targets) lines.push("Everything that was checked is fine for these programs.");
  else if (advice) lines.push(advice);
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
