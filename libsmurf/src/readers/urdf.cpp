// SPDX-License-Identifier: BSD-3-Clause
// The facts about all URDF readers; the table of a reader can override them.
#include <algorithm>

#include "base/findings/file_cases.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"
#include "base/text/utf8.hpp"
#include "readers/circumstances.hpp"

namespace smurf::readers::urdf_file {
namespace {

void see_joint(const LinkedModel& model, Diagnostic& finding) {
  const urdf::Joint* joint = part_at(model.robot->joints, finding.span.begin);
  if (joint == nullptr) return;
  if (joint->type == urdf::JointType::fixed) finding.when(kInFixed);
  if (joint->type == urdf::JointType::floating) finding.when(kInFloating);
  if (joint->type == urdf::JointType::planar) finding.when(kInPlanar);
  if (joint->type == urdf::JointType::continuous) finding.when(kInContinuous);
}

/// Python cannot read names whose bytes are not UTF-8.
bool has_name_in_other_encoding(const LinkedModel& model) {
  const auto is_other = [](const auto& part) {
    return utf8::find_invalid(part.name.value_or("")).has_value();
  };
  const auto has_one = [&](const auto& parts) {
    return std::any_of(parts.begin(), parts.end(), is_other);
  };
  return has_one(model.robot->links) || has_one(model.robot->joints);
}

void see(const LinkedModel& model, std::span<Diagnostic* const> found) {
  for (Diagnostic* finding : found) {
    if (finding->rule == &rules::sml0003_invalid_utf8 && has_name_in_other_encoding(model)) {
      finding->when(cases::kInName);
      finding->when(kUncertain);
    }
    const std::vector<PlaceName> place = place_of(*finding);
    if (contains(place, at("robot/joint"))) see_joint(model, *finding);
    if (!contains(place, at("robot/link/inertial"))) continue;
    const urdf::Link* link = part_at(model.robot->links, finding->span.begin);
    if (link != nullptr && link->name.value_or("") == "world") finding->when(kOfWorld);
  }
}

}  // namespace

extern constinit const Reader urdf{
    .name = "urdf",
    .title = "every URDF reader",
    .basis = "what the readers below have in common, unless their own table says otherwise",
    .is_target = false,
    .see = see};

}  // namespace smurf::readers::urdf_file
