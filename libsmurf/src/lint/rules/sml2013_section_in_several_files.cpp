// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml2013_section_in_several_files_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main) return;
  std::map<std::string_view, TopLevelKey> first;
  for (const TopLevelKey& key : top_level_keys(model)) {
    if (!is_section_name(key.value.key()) || key.value.is_null()) continue;
    const auto [found, is_new] = first.emplace(key.value.key(), key);
    const SourceId before = found->second.file.source;
    if (is_new || before == key.file.source) continue;
    Diagnostic& diagnostic =
        findings.report(key.value.key_span(), quoted(key.value.key()) + " is in another file, too");
    diagnostic.label(found->second.value.key_span(), "the first part");
    diagnostic.note("MARS joins the parts, Phobos reads the last one only");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "joins the parts", "smurf_parser SMURFParser.cpp:57-62, run"},
    {&readers::phobos, Effect::loses, "keeps the last part only, and ignores the main file",
     "Phobos io/smurfrobot.py:196, run"},
};

}  // namespace

extern constinit const Rule sml2013_section_in_several_files{
    .id = "SML2013",
    .name = "section-in-several-files",
    .severity = Severity::warning,
    .summary = "Several files have the same section.",
    .remedy = "Keep each section in one annotation file.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml2013_section_in_several_files_file
