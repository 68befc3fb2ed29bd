// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4124_object_cannot_be_made_file {
namespace {

/// The number of components of `extend` that MARS reads for the size of a shape; 0 for other
/// shapes.
std::size_t size_components(std::string_view shape) {
  if (shape == "box") return 3;
  if (shape == "capsule" || shape == "cylinder") return 2;
  return shape == "sphere" || shape.empty() ? 1 : 0;
}

template <class Entries>
void check_sizes(const LinkedModel& model, const Entries& entries, std::string_view what,
                 Findings& findings) {
  for (const auto& entry : entries) {
    const yaml::View mapping = mapping_of(model, entry);
    const yaml::View extend = mapping ? mapping.find("extend") : yaml::View();
    if (!extend || !extend.is_mapping()) continue;
    const auto shape = text_at(mapping, "physicmode");
    std::size_t needed = size_components(shape ? shape->value : std::string_view());
    for (const std::string_view key : {"x", "y", "z"}) {
      const auto size = number_at(extend, key);
      const bool is_needed = needed > 0;
      if (is_needed) --needed;
      if (!size || *size > 0 || (*size == 0 && !is_needed)) continue;
      findings.report(extend.find(key).span(), "`extend` of " + subject(what, entry) + " has " +
                                                   std::string(key) + " = " + format_number(*size));
      break;
    }
  }
}

void check_joint(const LinkedModel& model, const JointAnnotation& joint, Findings& findings) {
  const yaml::View mapping = mapping_of(model, joint);
  const auto place = mapping ? text_at(mapping, "anchorpos") : std::nullopt;
  if (place && place->value == "custom" && !mapping.find("anchor")) {
    Diagnostic& diagnostic =
        findings.report(place->span, subject("joint", joint) +
                                         " has the anchor position `custom`, but no `anchor`");
    diagnostic.severity = Severity::warning;
  }
  if (!joint.axis || !mapping) return;
  const auto& [x, y, z] = *joint.axis;
  const yaml::View components = mapping.find("axis1");
  if (x != 0 || y != 0 || z != 0 || components.size() == 0) return;
  findings.report(components.span(), "the axis of " + subject("joint", joint) + " has length 0");
}

void check(const LinkedModel& model, Findings& findings) {
  const Annotations& all = model.annotations;
  check_sizes(model, all.nodes, "node", findings);
  check_sizes(model, all.collisions, "collision entry", findings);
  for (const JointAnnotation& joint : all.joints) check_joint(model, joint, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::breaks,
     "stops loading at the first object that it cannot build, such as a shape without size or a joint without axis: everything after it is missing, and the pose and the anchor of the robot are skipped",
     "MARS smurf.cpp:1014-1058, JointManager.cpp:82-85, NodePhysics.cpp:626-634"},
};

}  // namespace

extern constinit const Rule sml4124_object_cannot_be_made{
    .id = "SML4124",
    .name = "object-cannot-be-made",
    .severity = Severity::error,
    .summary = "An entry describes a shape or joint that the physics engine cannot build.",
    .remedy = "Write sizes above 0 and an axis with a direction.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4124_object_cannot_be_made_file
