// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1704_material_duplicate_global_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const std::vector<urdf::Material>& materials = model.robot->materials;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (!materials[i].name) continue;
    const auto first = model.material_names.find(*materials[i].name);
    if (!first || *first == i) continue;
    Diagnostic& diagnostic =
        findings.report(materials[i].name.span,
                        "a second material of the robot is named " + quoted(*materials[i].name));
    diagnostic.label(materials[*first].name.span, "the first one");
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::refuses, "refuses the file", "urdfdom model.cpp:147, run"},
    {&readers::pybullet, Effect::changes, "uses the first", "Bullet UrdfParser.cpp:2278, run"},
    {&readers::drake, Effect::refuses, "refuses the file, even when both are equal", kRun},
    {&readers::mujoco, Effect::takes, "uses the first", kRun},
};

}  // namespace

extern constinit const Rule sml1704_material_duplicate_global{
    .id = "SML1704",
    .name = "material-duplicate-global",
    .severity = Severity::error,
    .summary = "Two materials of the robot have the same name.",
    .why = "urdf-loader uses the last.",
    .remedy = "Delete or rename one.",
    .sources = "urdf-loader 0.13, executed.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1704_material_duplicate_global_file
