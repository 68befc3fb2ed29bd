// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"
#include "lint/light_values.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml4109_light_incomplete_file {
namespace {

void check_model(const LinkedModel& model, Findings& findings) {
  for (const Light& light : model.annotations.lights) {
    report_incomplete_light(light, mapping_of(model, light), findings);
  }
}

void check_scene(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!world_value(file, "lights")) continue;
    for (const Light& light : file.scene.lights) {
      report_incomplete_light(light, yaml::View(*file.document, light.node), findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "keeps lights in a structure without default values: a number, flag or vector that is left "
     "out is whatever was in memory",
     "MARS LightData.h:40-65, LightData.cpp:45-71"},
};

}  // namespace

extern constinit const Rule sml4109_light_incomplete{
    .id = "SML4109",
    .name = "light-incomplete",
    .severity = Severity::warning,
    .summary = "A light of a model or scene leaves out a value that has no default.",
    .why = "Colours default to black.",
    .remedy = "Write all keys of the light; attenuations of 1, 0, 0 do not dim it.",
    .check_model = check_model,
    .check_scene = check_scene,
    .facts = kFacts};

}  // namespace smurf::rules::sml4109_light_incomplete_file
