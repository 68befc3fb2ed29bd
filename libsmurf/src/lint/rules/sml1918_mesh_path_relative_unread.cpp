// SPDX-License-Identifier: BSD-3-Clause
#include "lint/ros_paths.hpp"

namespace smurf::rules::sml1918_mesh_path_relative_unread_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_lost_to_ros(model, false, findings);
}

}  // namespace

extern constinit const Rule sml1918_mesh_path_relative_unread{
    .id = "SML1918",
    .name = "mesh-path-relative-unread",
    .severity = Severity::warning,
    .summary = "A mesh is named by a path relative to the URDF, which a target does not resolve.",
    .why = "ROS hands a robot around as a text, which has no folder.",
    .remedy = "Put the files into a package, and write `package://NAME/PATH`.",
    .sources = "resource_retriever, which RViz and MoveIt use.",
    .check_model = check,
    .needs_target = true,
    .facts = kLostToRos};

}  // namespace smurf::rules::sml1918_mesh_path_relative_unread_file
