// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/ros_paths.hpp"

namespace smurf::rules::sml1918_mesh_path_relative_unread_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_lost_to_ros(model, false, findings);
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "opens the file",
     "Bullet, DART, Drake, Newton and Pinocchio, run"},
    {&readers::ros, Effect::loses, kOpensAddressesOnly, kRetriever},
    {&readers::moveit, Effect::loses, kOpensAddressesOnly, kRetriever},
};

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
    .facts = kFacts};

}  // namespace smurf::rules::sml1918_mesh_path_relative_unread_file
