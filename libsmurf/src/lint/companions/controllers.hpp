// SPDX-License-Identifier: BSD-3-Clause
// The controllers in parameter files of ros2_control, and questions that several rules ask.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ast/ros_parameters.hpp"
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "smurf/companions.hpp"

namespace smurf {

/// A controller that a controller_manager may load.
struct RosController {
  std::string_view name;
  yaml::View declared;  ///< its mapping below controller_manager; none if it is not there, but its
                        ///< type is in its section
  yaml::View type;      ///< none if it is missing
  yaml::View section;   ///< the `ros__parameters` of its node; none if there is none
  Span place;           ///< its name
  const ControllerClass* known = nullptr;

  /// A parameter of its section, "joints"; none if it is not written.
  yaml::View parameter(std::string_view key) const;
  /// The texts of a list; empty if it is not one.
  std::vector<yaml::View> list(std::string_view key) const;
};

/// The controllers of one file.
struct ControllerFile {
  const Companion* companion = nullptr;
  std::vector<RosController> controllers;
  yaml::View manager;  ///< the `ros__parameters` of controller_manager; none if there is none
};

/// Calls `visit` for every controllers.yaml of the model.
void for_each_controller_file(const Companions& companions,
                              const std::function<void(const ControllerFile&)>& visit);

/// Calls `visit` with every controller of a known class that has a section, and the parameters of
/// that class.
void for_each_known_controller(
    const Companions& companions,
    const std::function<void(const RosController&, const std::vector<RosParameter>&)>& visit);

/// Calls `visit` for every parameter that is written in a mapping and below, and that is among
/// `known`, with its path: "gains.elbow.p".
void for_each_parameter(
    yaml::View mapping, const std::vector<RosParameter>& known,
    const std::function<void(yaml::View, const std::string&, const RosParameter&)>& visit,
    const std::string& prefix = {});

/// SML3701: a joint of a robot with another number of joints.
inline constexpr Circumstance kNumberedJoint{"numbered"};

/// SML3701: all names of the file lack a prefix.
inline constexpr Circumstance kLostPrefix{"prefix"};

/// The type that rcl and rclcpp give to a scalar, in the letters of RosParameter; 0 for one that is
/// empty or filled in later.
char rcl_type_of(yaml::View value);

/// "controller `arm_controller`"
std::string title_of(const RosController& controller);

/// Whether a text is filled in when the file is launched: `$(var prefix)`, `<namespace>`.
bool is_placeholder(std::string_view text);

}  // namespace smurf
