// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5303_fog_switched_off_file {
namespace {

bool has_fog(yaml::View environment) {
  const yaml::View fog =
      environment && environment.is_mapping() ? environment.find("fog") : yaml::View();
  return fog && !fog.is_null();
}

/// A place in the scene or its models that switches fog on.
std::optional<Span> fog_of(const LinkedScene& scene) {
  for (const SceneFile& file : scene.scenes) {
    const yaml::View environment = world_value(file, "environment");
    if (has_fog(environment)) return environment.find("fog").key_span();
  }
  for (const LinkedModel& model : scene.models) {
    for (const Graphics& graphics : model.annotations.graphics) {
      if (graphics.fog_enabled.value_or(false)) return graphics.fog_enabled.span;
    }
  }
  return std::nullopt;
}

void check(const LinkedScene& scene, Findings& findings) {
  const std::optional<Span> fog = fog_of(scene);
  if (!fog) return;
  for (const SceneFile& file : scene.scenes) {
    const yaml::View environment = world_value(file, "environment");
    if (!environment || has_fog(environment)) continue;
    // SML5302 reports an environment that the enclosing scene overrides.
    if (&file != &scene.scenes.front() && world_value(scene.scenes.front(), "environment"))
      continue;
    Diagnostic& diagnostic = findings.report(
        environment.key_span(), "this environment has no `fog` and so switches fog off in MARS");
    diagnostic.label(*fog, "fog is set here");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "switches fog off", "MARS SMURFLoader.cpp:516-535"},
};

}  // namespace

extern constinit const Rule sml5303_fog_switched_off{
    .id = "SML5303",
    .name = "fog-switched-off",
    .severity = Severity::warning,
    .summary = "An environment without `fog` switches off the fog that another file sets.",
    .remedy = "Repeat `fog` in this environment, or delete it from the other file.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5303_fog_switched_off_file
