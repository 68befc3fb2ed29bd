// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const Field<std::string>& name = model.robot->name;
  if (name.written && !name->empty()) return;
  findings.report(tag_name(model, model.robot->document.root),
                  name.written ? "the robot has an empty name" : "the robot has no name");
}

}  // namespace

extern constinit const Rule sml1102_robot_name_missing{
    .id = "SML1102",
    .name = "robot-name-missing",
    .severity = Severity::error,
    .summary = "The robot has no name, or an empty one.",
    .why = "urdfdom, sdformat and Bullet refuse a robot without name, sdformat an empty one as "
           "well.",
    .remedy = "Give the robot element a name.",
    .sources = "urdfdom 3.0.1 model.cpp:115, sdformat 12.3 and Bullet, executed.",
    .check_model = check};

}  // namespace smurf::rules
