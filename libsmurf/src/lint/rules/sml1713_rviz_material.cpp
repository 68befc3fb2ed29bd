// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1713_rviz_material_file {
namespace {

std::string name_of(const urdf::Visual& visual) {
  return visual.material ? visual.material->name.value_or("") : std::string();
}

/// Whether a reader would draw the two in different colours.
bool is_different(const urdf::Visual& first, const urdf::Visual& other) {
  if (!other.material) return false;  // without a material, any colour is right
  if (!first.material) return true;
  const urdf::Material &a = *first.material, &b = *other.material;
  if (name_of(first) != name_of(other)) return true;
  return a.rgba.value_or({}) != b.rgba.value_or({});
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    for (const urdf::Visual& visual : link.visuals) {
      if (!is_different(link.visuals.front(), visual)) continue;
      const std::string first = name_of(link.visuals.front());
      findings
          .report_habit(tag_name(model, visual.material->element),
                        "RViz 2 shows this visual of " + title(link) +
                            (link.visuals.front().material
                                 ? " in the material of the first one" +
                                       (first.empty() ? std::string() : ", " + quoted(first))
                                 : std::string(" in red: the first one has no material")),
                        "such links")
          .help("split the link, or use one mesh with its own colours");
      return;
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::changes, "RViz 2 paints all visuals of a link like the first",
     "rviz2 f7112b1 robot_link.cpp"},
};

}  // namespace

extern constinit const Rule sml1713_rviz_material{
    .id = "SML1713",
    .name = "rviz-material",
    .severity = Severity::warning,
    .summary = "The visuals of a link have different materials, of which RViz 2 shows the first.",
    .remedy = "Split the link, or give it one mesh with its own colours.",
    .sources = "rviz issues 843, 1293 (ros2).",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1713_rviz_material_file
