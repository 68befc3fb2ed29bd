// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5302_world_of_included_scene_file {
namespace {

/// The nearest enclosing scene of `use` that also sets the key.
yaml::View set_around(const LinkedScene& scene, const SceneUse& use, std::string_view key) {
  for (auto outer = use.outer; outer;) {
    const SceneUse& around = scene.uses[to_size(*outer)];
    if (const yaml::View value = world_value(scene.file(around), key)) return value;
    outer = around.outer;
  }
  return {};
}

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneUse& use : scene.uses) {
    if (!use.outer) continue;
    for (const std::string_view key : {"physics", "environment"}) {
      const yaml::View inner = world_value(scene.file(use), key);
      if (!inner) continue;
      const yaml::View outer = set_around(scene, use, key);
      if (!outer) continue;
      Diagnostic& diagnostic = findings.report(
          inner.key_span(),
          quoted(key) + " of an included scene is overridden by the enclosing scene");
      diagnostic.label(outer.key_span(), "this one is set afterwards");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "applies it to the whole world",
     "MARS SMURFLoader.cpp:451-548"},
    {&readers::mars2, Effect::changes, "applies it to the whole world, without its entities",
     "MarsSceneLoader.cpp"},
    {&readers::phobos, Effect::ignores, "reads no world", "Phobos core/multiple.py"},
};

}  // namespace

extern constinit const Rule sml5302_world_of_included_scene{
    .id = "SML5302",
    .name = "world-of-included-scene",
    .severity = Severity::warning,
    .summary = "An included scene sets physics or environment, and so does an enclosing scene.",
    .why = "All scenes share one world.",
    .remedy = "Set `physics` and `environment` in one scene, preferably the outermost.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5302_world_of_included_scene_file
