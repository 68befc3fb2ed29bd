// SPDX-License-Identifier: BSD-3-Clause
// The page of a report: the JSON report with these members added (libsmurf/src/render/html.cpp):
// picture: the page of smurfs-flatten --format html for the files; absent when there is none
// rules: by id, the rule list of --list-rules=json with `facts` about readers as text
// sources: by number, [{first, lines}] around the marks; "" for an omitted source
// remarks: lines for people; targets: with `title` and `answer` for people
// robots: when there are several, the files and the answers of the targets, in their order
// diagnostics: with `source`, also of labels; `caret`: the text of the mark; `names`: the place by names; `effects` on targets; `fix`: {is_safe, hunks}
import { byId } from "../common/dom.js";
import { Page } from "./page.js";

window.smurfReport = new Page(JSON.parse(byId("report").textContent));
document.documentElement.dataset.ready = "true";
