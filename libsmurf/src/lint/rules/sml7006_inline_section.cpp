// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || model.files.empty() || !model.files.front().document) return;
  const yaml::View root = model.files.front().document->view();
  if (!root || !root.is_mapping()) return;
  for (const yaml::View value : root) {
    if (!is_section_name(value.key()) || value.is_repeated()) continue;
    findings.report(value.key_span(),
                    "the section " + quoted(value.key()) + " stands in the main file");
  }
}

}  // namespace

extern constinit const Rule sml7006_inline_section{
    .id = "SML7006",
    .name = "inline-section",
    .severity = Severity::warning,
    .summary = "An annotation section stands in the main file.",
    .why = "The MARS generations merge the main file and the files it lists; Phobos reads "
           "sections from the listed files only.",
    .remedy = "Move the section to an annotation file and list it in `files`.",
    .sources = "smurf_parser SMURFParser.cpp:43-69; Phobos io/smurfrobot.py.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
