// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml2007_section_shape_clash_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  std::map<std::string_view, yaml::View> first;
  for (const TopLevelKey& key : top_level_keys(model)) {
    // Sections of the format have one shape, which is checked where they are read.
    if (!(key.value.is_sequence() || key.value.is_mapping())) continue;
    if (is_section_name(key.value.key())) continue;
    const auto [found, is_new] = first.emplace(key.value.key(), key.value);
    if (is_new || found->second.kind() == key.value.kind()) continue;
    const bool is_list = key.value.is_sequence();
    Diagnostic& diagnostic =
        findings.report(key.value.key_span(),
                        quoted(key.value.key()) + " is " +
                            (is_list ? "a list here and a mapping" : "a mapping here and a list") +
                            " in an earlier file");
    diagnostic.label(found->second.key_span(), is_list ? "a mapping here" : "a list here");
    diagnostic.note(is_list ? "MARS makes the mapping the first item of the list"
                            : "MARS ends with an exception");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "ends with an uncaught exception when a mapping follows a list; when a list follows a "
     "mapping, makes the mapping the first item of the list",
     "smurf_parser SMURFParser.cpp:57-65, run"},
};

}  // namespace

extern constinit const Rule sml2007_section_shape_clash{
    .id = "SML2007",
    .name = "section-shape-clash",
    .severity = Severity::error,
    .summary = "A section is a list in one file and a mapping in another.",
    .remedy = "Give the section the same shape in all files.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml2007_section_shape_clash_file
