// SPDX-License-Identifier: BSD-3-Clause
#include "lint/ros_paths.hpp"

namespace smurf::rules::sml1660_mesh_path_without_package_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (model.has_main) return;  // MARS reads relative paths only: SML1608
  report_lost_to_ros(model, true, findings);
}

}  // namespace

extern constinit const Rule sml1660_mesh_path_without_package{
    .id = "SML1660",
    .name = "mesh-path-without-package",
    .severity = Severity::warning,
    .summary = "A URDF in a ROS package names a mesh by a path without `package://`.",
    .why =
        "ROS hands a robot around as a text, which has no folder. The programs that show it find "
        "files by `package://` and `file://` only, while simulators that open the URDF find "
        "them beside it.",
    .remedy = "Write `package://NAME/PATH`.",
    .sources = "resource_retriever, which RViz and MoveIt use; collada_urdf issue 33, kobuki_ros "
               "issue 51, sdformat_urdf issue 25.",
    .check_model = check,
    .facts = kLostToRos};

}  // namespace smurf::rules::sml1660_mesh_path_without_package_file
