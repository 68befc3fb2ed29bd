// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1707_rgba_range_file {
namespace {

constexpr Circumstance kNegativeOpacity{"opacity below 0"};

void check(const LinkedModel& model, Findings& findings) {
  for_each_material(model, [&](const urdf::Material& material) {
    if (!material.rgba) return;
    for (const double component : *material.rgba) {
      if (component >= 0 && component <= 1) continue;
      Diagnostic& diagnostic =
          findings.report(material.rgba.span, "the colour component " + format_number(component) +
                                                  " is not between 0 and 1");
      if (component > 1) diagnostic.help("divide 0-255 values by 255");
      if (material.rgba->back() < 0) diagnostic.when(kNegativeOpacity);
      return;
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "keeps the number", kRun},
    {&readers::urdfdom, Effect::loses, "drops the material with a message",
     "urdfdom link.cpp:86-94, run"},
    {&readers::gazebo, Effect::loses, "drops the material", kRun},
    {&readers::mujoco, Effect::changes, "clips it", kRun},
    {&readers::drake, Effect::refuses, "refuses a visual of such a colour", kRun},
    {&readers::phobos, Effect::takes, "keeps the number", kRun},
    {&readers::isaac, Effect::refuses, "refuses an opacity below 0", kRun, when(kNegativeOpacity)},
};

}  // namespace

extern constinit const Rule sml1707_rgba_range{
    .id = "SML1707",
    .name = "rgba-range",
    .severity = Severity::error,
    .summary = "A colour component lies outside 0 to 1.",
    .why = "The components of a colour go from 0 to 1, not to 255.",
    .remedy = "Divide 0-255 values by 255.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1707_rgba_range_file
