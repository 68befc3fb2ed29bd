// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5018_uri_in_scene_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!file.document) continue;
    std::set<yaml::NodeId> without_file;  // entity-uri reports these
    for (const Entity& entity : file.scene.entities) {
      if (!entity.file || entity.file->empty()) without_file.insert(entity.node);
    }
    for (const yaml::Node& node : file.document->nodes) {
      if (node.key() != "URI" || without_file.contains(node.parent)) continue;
      Diagnostic& diagnostic = findings.report(
          node.key_span(),
          "MARS replaces `URI` by the keys of this file, which override those written here");
      diagnostic.help("write the keys of that file here");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "overwrites the keys beside it with those of the file",
     "MARS SMURFLoader.cpp:420; configmaps ConfigMap.cpp:615-624, run"},
    {&readers::mars2, Effect::ignores, "ignores the key", "read"},
    {&readers::phobos, Effect::ignores, "ignores the key", "read"},
};

}  // namespace

extern constinit const Rule sml5018_uri_in_scene{
    .id = "SML5018",
    .name = "uri-in-scene",
    .severity = Severity::warning,
    .summary = "A mapping of a scene has the key `URI`, which only MARS expands.",
    .why = "The documentation of configmaps states the opposite. Absolute paths do not work, and a "
           "cycle overflows the stack.",
    .remedy = "Write the keys here, or include a scene with `file`.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5018_uri_in_scene_file
