// SPDX-License-Identifier: BSD-3-Clause
// What the controllers of ros2_controllers and the programs of MoveIt read from parameter files.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace smurf {

/// A parameter of a ROS 2 program.
struct RosParameter {
  std::string_view path;  ///< "gains.*.p"; `*` is any name
  char type = 's';        ///< d double, i integer, b boolean, s text; capital letters are lists
  bool is_required = false;
  std::string_view fallback{};       ///< the default; may be empty
  std::string_view conditions{};     ///< see conditions_of(); may be empty
  std::string_view distributions{};  ///< h, j, k, r: Humble, Jazzy, Kilted and Rolling that have it
};

/// What must hold for a value: one of the texts, or a bound for the number.
struct ValueCondition {
  enum class Kind : char { one_of, above, at_least, below, at_most, unique, size };
  Kind kind{};
  std::vector<std::string_view> texts{};  ///< one_of; of a list: for every item
  double bound = 0;                       ///< of a number, or the size of a list
};
std::vector<ValueCondition> conditions_of(const RosParameter& parameter);
/// "above 0", "one of `splines`, `none`"
std::string describe(const ValueCondition& condition);

/// A controller of ros2_controllers.
struct ControllerClass {
  std::string_view name;  ///< "joint_trajectory_controller/JointTrajectoryController"
  std::string_view distributions;
  std::string_view chainable;   ///< the distributions in which others may command it
  std::string_view parameters;  ///< see parameters_of()
};
std::span<const ControllerClass> controller_classes();
/// Null for a class of another package.
const ControllerClass* find_controller_class(std::string_view type);

/// A parameter file of MoveIt.
struct MoveitFile {
  std::string_view name;  ///< "joint_limits.yaml"
  std::string_view parameters;
};
std::span<const MoveitFile> moveit_files();
const MoveitFile* find_moveit_file(std::string_view name);

/// The parameters of a class, and those of all controllers.
std::vector<RosParameter> parameters_of(const ControllerClass& type);
std::vector<RosParameter> parameters_of(const MoveitFile& file);
/// Those of controller_manager itself.
std::vector<RosParameter> manager_parameters();
/// The parameter at a path, with names for `*`; null if there is none.
const RosParameter* find_parameter(const std::vector<RosParameter>& all, std::string_view path);

/// One sentence about a parameter, by the end of its path; empty for one that nobody described.
std::string_view sentence_about(std::string_view path);
/// Whether the value of a parameter of a controller holds names of joints.
bool holds_joints(std::string_view key);
/// Whether the members of the mapping at a path have the names of joints: `gains`.
bool has_joints_as_keys(std::string_view path);

/// "double", "list of texts"
std::string_view type_name(const RosParameter& parameter);
std::string_view parameter_type_name(char type);
/// "Humble and Jazzy"; empty if all distributions have it.
std::string distribution_names(std::string_view distributions);

}  // namespace smurf
