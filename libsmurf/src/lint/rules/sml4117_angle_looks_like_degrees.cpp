// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "base/numbers/numbers.hpp"
#include "lint/angle_queries.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4117_angle_looks_like_degrees_file {
namespace {

/// Null when there is nothing to report.
Diagnostic* check_angle(std::optional<double> angle, Span place, std::string_view what,
                        const Subject& whose, Findings& findings) {
  if (!angle || !looks_like_degrees(*angle)) return nullptr;
  Diagnostic& diagnostic = findings.report(
      place, std::string(what) + " of " + whose + " is " + format_number(*angle) + " rad, " +
                 format_rounded(std::fabs(*angle) / (2 * std::numbers::pi), 3) +
                 " turns; is it in degrees?");
  diagnostic.help(format_number(*angle) + " degrees are " +
                  format_rounded(*angle * std::numbers::pi / 180, 6) + " rad");
  return &diagnostic;
}

/// One finding for all angles of one thing, which are in one unit.
void check_angles(std::initializer_list<const Field<double>*> angles, std::string_view what,
                  const Subject& whose, Findings& findings) {
  Diagnostic* found = nullptr;
  for (const Field<double>* angle : angles) {
    if (found == nullptr) {
      found = check_angle(angle->value(), angle->span, what, whose, findings);
    } else if (*angle && looks_like_degrees(**angle)) {
      found->label(angle->span, "this too");
    }
  }
}

void check_motor(const LinkedModel& model, const Motor& motor, Findings& findings) {
  const urdf::Joint* joint = joint_of(model, motor);
  if (joint == nullptr || joint->type != urdf::JointType::revolute) return;
  check_angles({&motor.min_value, &motor.max_value, &motor.min_position, &motor.max_position},
               "a bound", subject("motor", motor), findings);
}

void check_stops(const LinkedModel& model, const JointAnnotation& entry, Findings& findings) {
  const urdf::Joint* joint = entry.name ? model.find_joint(*entry.name) : nullptr;
  if (joint == nullptr || joint->type != urdf::JointType::revolute) return;
  check_angles({&entry.low_stop, &entry.high_stop}, "a stop", subject("joint", entry), findings);
}

void check_pose(const LinkedModel& model, const JointPoseSet& pose, Findings& findings) {
  for (const JointPoseSet::Entry& entry : pose.joints) {
    const urdf::Joint* joint = joint_of(model, entry);
    const bool is_angle = joint != nullptr && joint->type == urdf::JointType::revolute;
    if (is_angle) {
      check_angle(entry.position.value(), entry.position.span, "the position",
                  quoted(entry.name.value).c_str(), findings);
    }
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) check_motor(model, motor, findings);
  for (const JointAnnotation& entry : model.annotations.joints) check_stops(model, entry, findings);
  for (const JointPoseSet& pose : model.annotations.poses) check_pose(model, pose, findings);
  for (const Interface& entry : model.annotations.interfaces) {
    if (!entry.rotation) continue;
    for (const double angle : *entry.rotation) {
      check_angle(angle, entry.rotation.span, "a rotation", subject("interface", entry), findings);
    }
  }
}

}  // namespace

extern constinit const Rule sml4117_angle_looks_like_degrees{
    .id = "SML4117",
    .name = "angle-looks-like-degrees",
    .severity = Severity::warning,
    .summary = "An angle of a motor, joint, joint pose or interface looks like degrees.",
    .why = "Angles of motors, stops, joint poses and interfaces are radians in all readers: 90 "
           "is more than 14 turns.",
    .remedy = "Multiply by pi/180.",
    .sources = "MARS MotorData.cpp, SimEntity.cpp:503-513; Phobos representation.py:2289-2326.",
    .check_model = check};

}  // namespace smurf::rules::sml4117_angle_looks_like_degrees_file
