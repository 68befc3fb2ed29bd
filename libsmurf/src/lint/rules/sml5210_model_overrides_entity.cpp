// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5210_model_overrides_entity_file {
namespace {

constexpr std::string_view kKeys[] = {"name",     "type",   "file",   "position",
                                      "rotation", "parent", "anchor", "pose"};

void check(const LinkedScene& scene, Findings& findings) {
  for (const LinkedModel& model : scene.models) {
    for (const CustomSection& key : model.main.extra) {
      if (std::find(std::begin(kKeys), std::end(kKeys), key.name.value) == std::end(kKeys))
        continue;
      findings.report(key.name.span, quoted(key.name.value) +
                                         " in a model replaces that of the scene entity in MARS");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "uses the value of the model in every scene",
     "smurf_parser SMURFParser.cpp:43, run"},
};

}  // namespace

extern constinit const Rule sml5210_model_overrides_entity{
    .id = "SML5210",
    .name = "model-overrides-entity",
    .severity = Severity::warning,
    .summary = "A model's main file contains a key that belongs to the scene.",
    .why = "The main file sets the pose of the model. Other readers and this tool ignore the keys.",
    .remedy = "Move the key into the scene.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5210_model_overrides_entity_file
