// SPDX-License-Identifier: BSD-3-Clause
// Mesh paths that readers find from the file of the URDF, which programs of ROS do not have.
#pragma once

#include <string_view>

#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf {

/// What RViz and MoveIt do with a mesh path without a scheme. Their text of the robot has no
/// folder.
inline constexpr std::string_view kOpensAddressesOnly =
    "opens `package://` and `file://` only: RViz and MoveIt show the link without the mesh";
inline constexpr std::string_view kRetriever =
    "resource_retriever retriever.cpp, read; libcurl 7.88 on such paths, run";

/// The facts about relative paths.
inline constexpr Fact kLostToRos[] = {
    {&readers::urdf, Effect::takes, "opens the file",
     "Bullet, DART, Drake, Newton and Pinocchio, run"},
    {&readers::ros, Effect::loses, kOpensAddressesOnly, kRetriever},
    {&readers::moveit, Effect::loses, kOpensAddressesOnly, kRetriever},
};

/// The path of a mesh or texture that readers of files find and programs of ROS do not.
bool is_lost_to_ros(const MeshReference& reference);

/// Reports the paths, with the address to write if their package is known (`in_package`).
void report_lost_to_ros(const LinkedModel& model, bool in_package, Findings& findings);

}  // namespace smurf
