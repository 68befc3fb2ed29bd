// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <set>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1703_material_used_before_defined_file {
namespace {

bool defines(const LinkedModel& model, const urdf::Material& material) {
  const xml::View element(model.robot->document, material.element);
  return element.child("color") || element.child("texture");
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  std::set<std::string_view> global;
  for (const urdf::Material& material : model.robot->materials) {
    if (material.name) global.insert(*material.name);
  }
  std::map<std::string_view, const urdf::Material*> waiting;
  std::set<std::string_view> defined;
  for_each_material(model, [&](const urdf::Material& material) {
    if (!material.name || material.name->empty() || global.contains(*material.name)) return;
    const std::string_view name = *material.name;
    if (!defines(model, material)) {
      if (!defined.contains(name)) waiting.emplace(name, &material);
      return;
    }
    if (!defined.insert(name).second) return;
    const auto early = waiting.find(name);
    if (early == waiting.end()) return;
    Diagnostic& diagnostic = findings.report(
        early->second->name.span, "the material " + quoted(name) + " is used before it is defined");
    diagnostic.label(material.name.span, "it is defined here");
    diagnostic.help("define it at the top of the robot");
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes, "leaves the first visual without colour", kRun},
    {&readers::mujoco, Effect::takes, "finds the definition", kRun},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1703_material_used_before_defined{
    .id = "SML1703",
    .name = "material-used-before-defined",
    .severity = Severity::warning,
    .summary = "A visual uses a material that a later visual defines.",
    .remedy = "Define the material as a child of `robot`.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1703_material_used_before_defined_file
