// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml0018_null_in_list_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main) return;
  for (const ModelFile& file : model.files) {
    if (!file.document) continue;
    std::vector<bool> is_known(file.document->nodes.size(), false);
    for (std::size_t i = 0; i < file.document->nodes.size(); ++i) {
      const yaml::Node& node = file.document->nodes[i];
      if (node.parent == yaml::kNoNode) continue;
      const auto parent = static_cast<std::size_t>(node.parent);
      // Sections of the format are checked by their readers.
      is_known[i] =
          is_known[parent] || (node.parent == file.document->root && is_section_name(node.key()));
      const bool is_item = file.document->nodes[parent].kind() == yaml::Kind::sequence;
      if (is_known[i] || !is_item || node.kind() != yaml::Kind::null) continue;
      if (node.is_alias() || file.document->nodes[parent].key() == "files") continue;
      const Span place = node.span.empty() ? file.document->nodes[parent].key_span() : node.span;
      findings.report(place, "a list must not contain an empty item: MARS ends with an exception");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception",
     "configmaps ConfigItem.cpp, run"},
    {&readers::mars2, Effect::crashes, "ends with an uncaught exception",
     "configmaps ConfigItem.cpp, run"},
    {&readers::envire, Effect::crashes, "ends with an uncaught exception",
     "configmaps ConfigItem.cpp, run"},
    {&readers::phobos, Effect::takes, "keeps the empty item", kRun},
};

}  // namespace

extern constinit const Rule sml0018_null_in_list{
    .id = "SML0018",
    .name = "null-in-list",
    .severity = Severity::error,
    .summary = "A list of a custom section has an empty item.",
    .remedy = "Fill the item, or delete it.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml0018_null_in_list_file
