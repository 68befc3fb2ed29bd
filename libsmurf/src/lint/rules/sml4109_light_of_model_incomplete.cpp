// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/annotation_queries.hpp"
#include "lint/light_values.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Light& light : model.annotations.lights) {
    report_incomplete_light(light, mapping_of(model, light), findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "keeps lights in a structure without default values: a number, flag or vector that is left out is whatever was in memory",
     "MARS LightData.h:40-65, LightData.cpp:45-71"},
};

}  // namespace

extern constinit const Rule sml4109_light_of_model_incomplete{
    .id = "SML4109",
    .name = "light-of-model-incomplete",
    .severity = Severity::warning,
    .summary = "A light of a model leaves out a value that has no default.",
    .why = "Colours default to black.",
    .remedy = "Write all keys of the light; attenuations of 1, 0, 0 do not dim it.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
