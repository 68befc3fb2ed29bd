// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5209_assembly_world_ignored_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!file.document || path::extension(file.path) != ".smurfa") continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping()) continue;
    for (const std::string_view key : {"physics", "environment", "lights"}) {
      const yaml::View value = root.find(key);
      if (!value || value.is_null()) continue;
      findings.report(value.key_span(), "MARS does not read " + quoted(key) + " in an assembly");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::ignores, "reads it in a .smurfs only", "MARS SMURFLoader.cpp:452"},
};

}  // namespace

extern constinit const Rule sml5209_assembly_world_ignored{
    .id = "SML5209",
    .name = "assembly-world-ignored",
    .severity = Severity::warning,
    .summary = "An assembly (.smurfa) sets physics, environment or lights.",
    .remedy = "Set them in the scene that includes the assembly.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5209_assembly_world_ignored_file
