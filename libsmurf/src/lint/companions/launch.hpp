// SPDX-License-Identifier: BSD-3-Clause
// The launch files around a robot, and questions that several rules ask about them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/readers.hpp"
#include "link/surroundings/frame_names.hpp"
#include "lint/queries.hpp"
#include "smurf/companions.hpp"

namespace smurf {

void for_each_launch(const Companions& companions,
                     const std::function<void(const LaunchFile&)>& visit);

/// How a launch file gives the output of xacro as a parameter: "`Command(['xacro ', path])`".
std::string_view xacro_call(const LaunchFile& launch);

/// A package of ROS that robots are started with, and its programs; empty if they are not listed.
struct RosPackage {
  std::string_view name, programs;
};
std::span<const RosPackage> ros_packages();
bool is_ros_package(std::string_view name);

/// Whether a node runs this program of a package.
bool runs(const LaunchNode& node, std::string_view package, std::string_view executable);

/// Whether a frame is one of another description, or published by a launch file.
bool is_published_elsewhere(const Surroundings& surroundings, std::string_view frame);

}  // namespace smurf
