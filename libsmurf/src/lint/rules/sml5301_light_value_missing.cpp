// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/light_values.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!world_value(file, "lights")) continue;
    for (const Light& light : file.scene.lights) {
      report_incomplete_light(light, yaml::View(*file.document, light.node), findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "reads uninitialised memory", "MARS LightData.h:40-65"},
};

}  // namespace

extern constinit const Rule sml5301_light_value_missing{
    .id = "SML5301",
    .name = "light-value-missing",
    .severity = Severity::warning,
    .summary = "A light leaves out a value that has no default.",
    .why = "Colours default to black.",
    .remedy = "Write all keys of the light; attenuations of 1, 0, 0 do not dim it.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules
