// SPDX-License-Identifier: BSD-3-Clause
// What the controllers of ros2_controllers read from parameter files.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace smurf {

struct ControllerClass {
  std::string_view name;           ///< "joint_trajectory_controller/JointTrajectoryController"
  std::string_view distributions;  ///< that have it; h, j and r: Humble, Jazzy and Rolling
  std::string_view parameters;     ///< see parameters_of()
};

struct Parameter {
  std::string_view path;  ///< "gains.*.p"; `*` is the name of a joint
  char type = 's';        ///< d double, i integer, b boolean, s text; capitals: lists
  bool is_required = false;
  std::string_view distributions;
};

/// Null for a class of another package.
const ControllerClass* find_controller_class(std::string_view type);
std::vector<std::string_view> controller_class_names();
/// The parameters of a class, and those of all controllers.
std::vector<Parameter> parameters_of(const ControllerClass& type);
/// The parameter at a path, with names for `*`; null if there is none.
const Parameter* find_parameter(const std::vector<Parameter>& all, std::string_view path);

}  // namespace smurf
