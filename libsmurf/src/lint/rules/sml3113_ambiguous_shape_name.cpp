// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <unordered_map>
#include <vector>

#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

using Places = std::unordered_map<std::string_view, std::vector<Span>>;

struct Shapes {
  Places visuals, collisions;

  explicit Shapes(const LinkedModel& model) {
    for_each_link(model, [&](const urdf::Link& link) {
      for (const urdf::Visual& visual : link.visuals) {
        if (visual.name) visuals[*visual.name].push_back(visual.name.span);
      }
      for (const urdf::Collision& collision : link.collisions) {
        if (collision.name) collisions[*collision.name].push_back(collision.name.span);
      }
    });
  }
};

void check_name(const Places& places, std::string_view kind, std::string_view name, Span place,
                Findings& findings) {
  const auto found = places.find(name);
  if (found == places.end() || found->second.size() < 2) return;
  constexpr std::size_t kShown = 3;
  Diagnostic& diagnostic = findings.report(
      place, "there are " + std::to_string(found->second.size()) + " " + std::string(kind) + "s " +
                 quoted(name) + "; MARS takes one of them");
  for (std::size_t i = 0; i < std::min(found->second.size(), kShown); ++i) {
    diagnostic.labels.push_back({found->second[i], "one of them"});
  }
}

void check(const LinkedModel& model, Findings& findings) {
  const Annotations& all = model.annotations;
  if (all.collisions.empty() && all.visuals.empty() && all.sensors.empty()) return;
  const Shapes shapes(model);
  for (const CollisionAnnotation& entry : all.collisions) {
    if (!entry.name) continue;
    check_name(shapes.collisions, "collision", *entry.name, entry.name.span, findings);
  }
  for (const VisualAnnotation& entry : all.visuals) {
    if (!entry.name) continue;
    check_name(shapes.visuals, "visual", *entry.name, entry.name.span, findings);
  }
  const NameList none;
  for (const Sensor& sensor : all.sensors) {
    const bool is_contact = sensor.type && sensor_target(*sensor.type) == NameKind::collision;
    for (const auto& list : {sensor.collisions, is_contact ? sensor.id : Field<NameList>{}}) {
      for (const Spanned<std::string>& name : list ? *list : none) {
        check_name(shapes.collisions, "collision", name.value, name.span, findings);
      }
    }
  }
}

}  // namespace

extern constinit const Rule sml3113_ambiguous_shape_name{
    .id = "SML3113",
    .name = "ambiguous-shape-name",
    .severity = Severity::warning,
    .summary = "An annotation names a visual or collision of which there are several.",
    .why = "Names of visuals and collisions need not differ in a URDF; MARS keeps one "
           "entry a name, so the annotation or the sensor gets only one of them.",
    .remedy = "Give each its own name in the URDF.",
    .sources = "MARS smurf.cpp:706-716, 779-789.",
    .check_model = check};

}  // namespace smurf::rules
