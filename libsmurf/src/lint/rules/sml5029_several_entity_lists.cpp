// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5029_several_entity_lists_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!file.document) continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping()) continue;
    yaml::View first;  // in the order of Phobos
    for (const std::string_view key : {"entities", "smurfa", "smurfs"}) {
      const yaml::View list = root.find(key);
      if (!list || !list.is_sequence() || list.size() == 0) continue;
      if (!first) {
        first = list;
        continue;
      }
      Diagnostic& diagnostic = findings.report(
          list.key_span(), "only MARS reads " + quoted(key) + " beside " + quoted(first.key()));
      diagnostic.label(first.key_span(), "Phobos reads this list only");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "reads all three", "MARS SMURFLoader.cpp:431-450"},
    {&readers::mars2, Effect::loses, "reads `entities` only", "MarsSceneLoader.cpp"},
    {&readers::phobos, Effect::loses, "reads `entities`, else `smurfa`, else `smurfs`",
     "Phobos core/multiple.py"},
    {&readers::pybullet, Effect::loses, "reads `smurfs`, else `entities`",
     "Phobos scripts/smurfs_in_pybullet.py, run"},
};

}  // namespace

extern constinit const Rule sml5029_several_entity_lists{
    .id = "SML5029",
    .name = "several-entity-lists",
    .severity = Severity::warning,
    .summary = "A scene has more than one of the lists `entities`, `smurfa` and `smurfs`.",
    .remedy = "Put all entities into one list; nest a .smurfa for an assembly.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5029_several_entity_lists_file
