// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/scene_keys.hpp"
#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "lint/misspelt_key.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5033_scene_without_entities_file {
namespace {

/// The probable misspelling of the list: the first key that no reader of scenes knows.
yaml::View unknown_key(yaml::View root) {
  for (const yaml::View value : root) {
    if (find_key({scene_keys()}, value.key()) == nullptr) return value;
  }
  return {};
}

/// Whether another rule reports the list: SML4001 if it is not a list or has entries that are no
/// entities, SML4005 if its key is misspelt.
bool is_reported(yaml::View root) {
  KeyRenames renames(root);
  return std::any_of(root.begin(), root.end(), [&](const yaml::View value) {
    const KeySpec* meant = find_key({scene_keys()}, value.key());
    const bool is_known = meant != nullptr;
    if (!is_known) meant = misspelt_key(value, renames, scene_keys());
    const bool is_list = meant != nullptr && ranges::contains(kEntityLists, meant->name);
    return is_list && !(is_known && value.is_sequence() && value.size() == 0);
  });
}

/// Other scenes may include one that has only lights, physics or an environment.
bool is_world(yaml::View root) {
  return std::any_of(root.begin(), root.end(), [](const yaml::View value) {
    return !ranges::contains(kEntityLists, value.key());
  });
}

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!file.document || file.drawing || !file.scene.entities.empty()) continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping() || root.size() == 0 || is_reported(root)) continue;
    const yaml::View other = unknown_key(root);
    if (!other && is_world(root)) continue;
    Diagnostic& diagnostic = findings.report((other ? other : *root.begin()).key_span(),
                                             "the scene has no entities, so it is empty");
    if (other) diagnostic.caret = "no reader of scenes knows this key";
    diagnostic.help("list robots and objects under `entities`");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "loads an empty world", "MARS SMURFLoader.cpp:418-450"},
};

}  // namespace

extern constinit const Rule sml5033_scene_without_entities{
    .id = "SML5033",
    .name = "scene-without-entities",
    .severity = Severity::warning,
    .summary = "A scene has no entities.",
    .why =
        "Readers silently ignore unknown keys: robots under any key but `entities` are not loaded.",
    .remedy = "List the entities under `entities`: `- {name: arm, type: smurf, file: arm.smurf}`.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5033_scene_without_entities_file
