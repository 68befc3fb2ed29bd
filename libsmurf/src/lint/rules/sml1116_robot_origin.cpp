// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1116_robot_origin_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const xml::View origin = model.robot->document.view().child("origin");
  if (!origin) return;
  findings.report(origin.name_span(), "the `origin` of a robot is read by sdformat (Gazebo) only");
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::ignores, "ignores it", "urdfdom, MuJoCo and Bullet, run"},
    {&readers::gazebo, Effect::changes, "uses it as the pose of the model",
     "sdformat parser_urdf.cc:1227-1270"},
};

}  // namespace

extern constinit const Rule sml1116_robot_origin{
    .id = "SML1116",
    .name = "robot-origin",
    .severity = Severity::warning,
    .summary = "The robot element has an origin.",
    .why = "URDF defines no origin there: readers place the robot differently.",
    .remedy = "Set the pose in the scene, or with a fixed joint below a new root link.",
    .check_model = check,
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1116_robot_origin_file
