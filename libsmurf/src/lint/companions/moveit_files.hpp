// SPDX-License-Identifier: BSD-3-Clause
// The parameter files of MoveIt, and questions that several rules ask.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "ast/ros_parameters.hpp"
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "smurf/companions.hpp"

namespace smurf {

/// Calls `visit` for every companion of a kind with its root, if that is a mapping.
void for_each_file(const Companions& companions, CompanionKind kind,
                   const std::function<void(const Companion&, yaml::View)>& visit);

/// Calls `visit` for every joint in a joint_limits.yaml: a mapping below its name.
void for_each_joint_limit(const Companions& companions,
                          const std::function<void(const Companion&, yaml::View)>& visit);

/// Whether a mapping of this name only contains the parameters of MoveIt.
bool is_moveit_wrapper(std::string_view key);

/// Calls `visit` for every value that MoveIt reads, with its parameter and its path. It reads
/// `max_velocity` of a joint only with `has_velocity_limits: true`.
void for_each_moveit_value(const Companions& companions,
                           const std::function<void(const Companion&, const RosParameter&,
                                                    yaml::View, const std::string&)>& visit);

/// The SRDF of the robot, if there is one only: a group may be in another one.
const Companion* only_srdf(const Companions& companions);

}  // namespace smurf
