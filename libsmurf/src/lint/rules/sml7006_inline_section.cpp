// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml7006_inline_section_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || model.files.empty() || !model.files.front().document) return;
  const yaml::View root = model.files.front().document->view();
  if (!root || !root.is_mapping()) return;
  for (const yaml::View value : root) {
    if (!is_section_name(value.key()) || value.is_repeated()) continue;
    findings.report(value.key_span(),
                    "the section " + quoted(value.key()) + " is in the main file");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "merges the main file and the files it lists",
     "smurf_parser SMURFParser.cpp:43-69"},
    {&readers::mars2, Effect::takes, "merges the main file and the files it lists",
     "smurf_parser SMURFParser.cpp:43-69"},
    {&readers::envire, Effect::takes, "merges the main file and the files it lists",
     "smurf_parser SMURFParser.cpp:43-69"},
    {&readers::phobos, Effect::loses, "ignores the section", "Phobos io/smurfrobot.py"},
};

}  // namespace

extern constinit const Rule sml7006_inline_section{
    .id = "SML7006",
    .name = "inline-section",
    .severity = Severity::warning,
    .summary = "The main file has an annotation section.",
    .remedy = "Move the section to an annotation file and list it in `files`.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7006_inline_section_file
