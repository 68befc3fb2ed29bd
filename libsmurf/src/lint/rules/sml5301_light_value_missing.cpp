// SPDX-License-Identifier: BSD-3-Clause
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

}  // namespace

extern constinit const Rule sml5301_light_value_missing{
    .id = "SML5301",
    .name = "light-value-missing",
    .severity = Severity::warning,
    .summary = "A light leaves out a value that has no default.",
    .why = "MARS keeps lights in a structure without default values: a number, flag or vector "
           "that the scene leaves out is whatever was in memory. Colours default to black.",
    .remedy = "Write all keys of the light; attenuations of 1, 0, 0 do not dim it.",
    .sources = "MARS LightData.h:40-65, LightData.cpp:45-71.",
    .check_scene = check};

}  // namespace smurf::rules
