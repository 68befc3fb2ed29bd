// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/words.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1315_empty_shape_name_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (!use.name.written || !trimmed(*use.name).empty()) return;
    findings.report(use.name.span, "a " + std::string(to_string(use.role)) + " has an empty name")
        .help("name it, or delete the attribute");
  });
  if (!model.robot) return;
  for (const urdf::Material& material : model.robot->materials) {
    if (!material.name.written || !material.name->empty()) continue;
    findings.report(material.name.span, "a material of the robot has an empty name")
        .help("name it: visuals refer to it by its name");
  }
}

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::refuses, "refuses an empty name; accepts a shape without one", kRun},
    {&readers::isaac, Effect::refuses, "refuses a material without a name", kRun,
     at("robot/material")},
    {&readers::pybullet, Effect::changes, "paints with it visuals that have no material", kRun,
     at("robot/material")},
};

}  // namespace

extern constinit const Rule sml1315_empty_shape_name{
    .id = "SML1315",
    .name = "empty-shape-name",
    .severity = Severity::error,
    .summary = "The name of a visual, a collision or a material of the robot is empty.",
    .why = "Without the attribute, readers make a name of their own for a shape.",
    .remedy = "Name it, or delete the attribute of a shape.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1315_empty_shape_name_file
