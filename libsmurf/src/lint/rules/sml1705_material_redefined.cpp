// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <set>

#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  std::map<std::string_view, const urdf::Material*> first_by_name;
  std::set<std::string_view> reported;
  for_each_material(model, [&](const urdf::Material& material) {
    if (!material.name || material.name->empty()) return;
    if (!material.rgba && !material.texture) return;
    const auto [known, is_new] = first_by_name.emplace(*material.name, &material);
    const urdf::Material& first = *known->second;
    if (is_new) return;
    const bool is_other =
        (material.rgba && first.rgba && *material.rgba != *first.rgba) ||
        (material.texture && first.texture && *material.texture != *first.texture);
    // Two of the robot are a fault of their own.
    const bool is_global =
        xml::View(model.robot->document, material.element).parent().name() == "robot";
    if (!is_other || is_global || !reported.insert(*material.name).second) return;
    const bool is_color = material.rgba && first.rgba && *material.rgba != *first.rgba;
    Diagnostic& diagnostic =
        findings.report(is_color ? material.rgba.span : material.texture.span,
                        "the material " + quoted(*material.name) + " has another " +
                            (is_color ? "colour" : "texture") + " here");
    diagnostic.labels.push_back({is_color ? first.rgba.span : first.texture.span, "the first one"});
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes, "takes the first for both", kRun},
    {&readers::pybullet, Effect::takes, "gives each its own", kRun},
    {&readers::mujoco, Effect::takes, "gives each its own", kRun},
    {&readers::drake, Effect::refuses, "refuses the file", "Drake detail_urdf_geometry.cc"},
};

}  // namespace

extern constinit const Rule sml1705_material_redefined{
    .id = "SML1705",
    .name = "material-redefined",
    .severity = Severity::warning,
    .summary = "A material has one colour or texture here and another one there.",
    .remedy = "Name the second material differently, or write the colour once.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
