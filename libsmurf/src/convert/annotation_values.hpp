// SPDX-License-Identifier: BSD-3-Clause
// Annotations and the values of the URDF that they repeat or contradict.
#pragma once

#include <map>
#include <optional>
#include <string_view>

#include "smurf/convert.hpp"

namespace smurf {

/// Comparisons that decide which values are applied and which are lost.
class AnnotationValues {
 public:
  explicit AnnotationValues(const LinkedModel& model);

  /// The URDF defines or uses the material.
  bool defines(const MaterialAnnotation& entry) const;
  /// Null when no definition of the material has a colour (texture).
  const urdf::Material* definition(std::string_view name) const;
  bool says_color(const MaterialAnnotation& entry) const;
  bool says_texture(const MaterialAnnotation& entry) const;

  /// The movable joint that the motor drives; null when there is none.
  const urdf::Joint* joint_of(const Motor& motor) const;
  /// The joint of the motor that this one mimics.
  const urdf::Joint* leader_of(const Motor& motor) const;
  bool says_limit(const Motor& motor, std::string_view key) const;
  bool says_mimic(const Motor& motor) const;

  const urdf::Joint* joint_of(const JointAnnotation& entry) const;
  /// None if the key is not about damping or friction.
  std::optional<bool> says_dynamics(const JointAnnotation& entry, yaml::View key) const;

 private:
  const LinkedModel& model_;
  std::map<std::string_view, const urdf::Material*> materials_;
};

/// Absent components as in Phobos: black and opaque.
std::array<double, 4> rgba_of(const Color& color);
/// The same colour with components between 0 and 1, as graphics show it.
std::array<double, 4> visible(std::array<double, 4> rgba);

enum class LimitValue : std::uint8_t { lower, upper, effort, velocity };
/// The value in the URDF that corresponds to a key of a motor.
std::optional<LimitValue> limit_value(std::string_view key);
const Field<double>& limit_field(const urdf::Limit& limit, LimitValue value);
/// The corresponding value of the motor; the newer of two names takes precedence, as in MARS.
std::optional<double> limit_of(const Motor& motor, LimitValue value);

enum class DynamicsValue : std::uint8_t { damping, friction };
std::optional<DynamicsValue> dynamics_value(std::string_view key);

}  // namespace smurf
