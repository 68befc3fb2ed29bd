// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const xml::View origin = model.robot->document.view().child("origin");
  if (!origin) return;
  findings.report(origin.name_span(), "the `origin` of a robot is read by sdformat (Gazebo) only");
}

}  // namespace

extern constinit const Rule sml1116_robot_origin{
    .id = "SML1116",
    .name = "robot-origin",
    .severity = Severity::warning,
    .summary = "The robot element has an origin.",
    .why = "URDF has none there. sdformat (Gazebo) places the model by it, every other reader "
           "ignores it: the robot stands elsewhere in Gazebo than in RViz.",
    .remedy = "Place the robot where it is used: in the scene, or by a fixed joint below a new "
              "root link.",
    .sources = "sdformat parser_urdf.cc:1227-1270; urdfdom 3.0.1, MuJoCo 3.14 and Bullet, "
               "executed.",
    .check_model = check};

}  // namespace smurf::rules
