// SPDX-License-Identifier: BSD-3-Clause
// The elements and attributes of URDF and the keys of SMURF that facts name. Places in facts
// consist of these rows and not of text, so a misspelt place does not compile.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// In the order of their bytes.
inline constexpr std::string_view kPlaceNames[] = {
    "@",
    "@acceleration",
    "@damping",
    "@deceleration",
    "@effort",
    "@filename",
    "@friction",
    "@ixx",
    "@ixy",
    "@ixz",
    "@iyy",
    "@iyz",
    "@izz",
    "@jerk",
    "@joint",
    "@length",
    "@link",
    "@lower",
    "@multiplier",
    "@name",
    "@offset",
    "@quat_xyzw",
    "@radius",
    "@reference",
    "@rgba",
    "@rpy",
    "@scale",
    "@size",
    "@type",
    "@upper",
    "@value",
    "@velocity",
    "@version",
    "@xyz",
    "SMURF version",
    "ambientColor",
    "anchor",
    "axis",
    "bands",
    "box",
    "calibration",
    "capsule",
    "cdf",
    "child",
    "collision",
    "collisions",
    "color",
    "contextual_name",
    "cylinder",
    "date",
    "depth_image",
    "description",
    "disable_collisions",
    "drake:ball_constraint",
    "drake:collision_filter_group",
    "drake:distance_constraint",
    "drake:joint",
    "drake:linear_bushing_rpy",
    "drake:linear_spring_damper",
    "drake:proximity_properties",
    "drake:tendon_constraint",
    "drake_compliance",
    "dynamics",
    "emissionColor",
    "enable_collisions",
    "end_effector",
    "entities",
    "environment",
    "extend",
    "file",
    "gazebo",
    "geometry",
    "graphics",
    "group",
    "group_state",
    "height",
    "inertia",
    "inertial",
    "joint",
    "joints",
    "lasers",
    "lights",
    "limit",
    "link",
    "links",
    "loop_joint",
    "mass",
    "material",
    "materials",
    "mesh",
    "mimic",
    "mimic_multiplier",
    "modelname",
    "motors",
    "name",
    "nodes",
    "orientation_offset",
    "origin",
    "parent",
    "physicmode",
    "physics",
    "plane",
    "poses",
    "position",
    "position_offset",
    "robot",
    "rotation",
    "safety_controller",
    "sensors",
    "smurfs",
    "specularColor",
    "sphere",
    "springDamping",
    "springStiffness",
    "submechanisms",
    "texture",
    "transmission",
    "type",
    "visual",
    "visualType",
    "visuals",
    "width",
    "x",
    "xacro:",
    "y",
    "z",
};
static_assert(std::is_sorted(std::begin(kPlaceNames), std::end(kPlaceNames)));
static_assert(std::size(kPlaceNames) < 255);

/// In a fact, this row means any attribute. In a finding, it means an attribute without a row.
inline constexpr std::string_view kAnyAttribute = "@";
/// This row means all names with this prefix.
inline constexpr std::string_view kOfXacro = "xacro:";

/// The row of a name; PlaceName{} if it has none.
constexpr PlaceName place_name(std::string_view name) {
  if (name.starts_with(kOfXacro)) name = kOfXacro;
  const auto row = std::lower_bound(std::begin(kPlaceNames), std::end(kPlaceNames), name);
  if (row != std::end(kPlaceNames) && *row == name) {
    return static_cast<PlaceName>(row - std::begin(kPlaceNames) + 1);
  }
  return name.starts_with(kAnyAttribute) ? place_name(kAnyAttribute) : PlaceName{};
}

/// The text of a row.
constexpr std::string_view to_string(PlaceName name) {
  return name == PlaceName{} ? std::string_view() : kPlaceNames[static_cast<std::size_t>(name) - 1];
}

/// Findings at a place: at("limit/@upper"), at("origin/@") for all attributes of an origin,
/// at("x"). The names follow each other anywhere in the path of the finding.
consteval Where at(std::string_view path) {
  Where where;
  std::size_t count = 0;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    const std::string_view segment = path.substr(0, end);
    const PlaceName name = place_name(segment);
    const bool is_known = to_string(name) == segment;
    if (!is_known) throw "this name has no row in kPlaceNames";
    where.place.at(count++) = name;
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return where;
}

}  // namespace smurf
