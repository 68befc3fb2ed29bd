// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml0017_merge_key_file {
namespace {

void check_document(const yaml::Document& document, Findings& findings) {
  for (const yaml::Node& node : document.nodes) {
    const bool is_quoted = node.key_span().end - node.key_span().begin != node.key().size();
    if (node.key() != "<<" || is_quoted) continue;
    findings.report(node.key_span(), "MARS does not merge `<<` into this mapping, but Phobos does")
        .help("write the keys here");
  }
}

void check_model_files(const LinkedModel& model, Findings& findings) {
  for (const ModelFile& file : model.files) {
    if (file.document) check_document(*file.document, findings);
  }
}

void check_scene_files(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (file.document) check_document(*file.document, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "sees an unknown key `<<` and none of the merged ones",
     "yaml-cpp 0.7 and configmaps, run"},
    {&readers::mars2, Effect::loses, "sees an unknown key `<<` and none of the merged ones",
     "yaml-cpp 0.7 and configmaps, run"},
    {&readers::envire, Effect::loses, "sees an unknown key `<<` and none of the merged ones",
     "yaml-cpp 0.7 and configmaps, run"},
    {&readers::phobos, Effect::takes, "merges it", "PyYAML 6.0 constructor.py, run"},
};

}  // namespace

extern constinit const Rule sml0017_merge_key{
    .id = "SML0017",
    .name = "merge-key",
    .severity = Severity::warning,
    .summary = "A mapping uses the YAML merge key `<<`.",
    .why = "Readers build different models from the same file.",
    .remedy = "Write the keys in each mapping.",
    .check_model = check_model_files,
    .check_scene = check_scene_files,
    .facts = kFacts};

}  // namespace smurf::rules::sml0017_merge_key_file
