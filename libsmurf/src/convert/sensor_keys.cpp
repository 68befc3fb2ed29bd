// SPDX-License-Identifier: BSD-3-Clause
#include "convert/sensor_keys.hpp"

#include <numbers>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/quantity.hpp"

namespace smurf {

std::optional<double> SensorKeys::find(std::string_view key) const {
  const yaml::View value = keys_.find(key);
  const std::optional<double> number = value ? value.number() : std::nullopt;
  return number && is_quantity(*number) ? number : std::nullopt;
}

double SensorKeys::number(std::string_view key, double fallback) const {
  return find(key).value_or(fallback);
}

double SensorKeys::part(std::string_view key, std::string_view component, double fallback) const {
  const yaml::View mapping = keys_.find(key);
  return mapping && mapping.is_mapping() ? SensorKeys(mapping).number(component, fallback)
                                         : fallback;
}

Vector3 SensorKeys::vector(std::string_view key) const {
  return {part(key, "x", 0), part(key, "y", 0), part(key, "z", 0)};
}

std::optional<Vector3> SensorKeys::angles(std::string_view key) const {
  const yaml::View mapping = keys_.find(key);
  if (!mapping || !mapping.is_mapping() || !mapping.find("roll")) return std::nullopt;
  return Vector3{part(key, "roll", 0), part(key, "pitch", 0), part(key, "yaw", 0)};
}

Quaternion SensorKeys::quaternion(std::string_view key) const {
  const Quaternion q{part(key, "w", 1), part(key, "x", 0), part(key, "y", 0), part(key, "z", 0)};
  return norm(q) > 0 ? normalized(q) : Quaternion();
}

Vector3 SensorKeys::rpy(std::string_view key) const {
  constexpr double kRadians = std::numbers::pi / 180;
  const auto given = angles(key);
  if (!given) return to_rpy(quaternion(key));
  const auto& [roll, pitch, yaw] = *given;
  return {roll * kRadians, pitch * kRadians, yaw * kRadians};
}

Quaternion SensorKeys::rotation(std::string_view key) const {
  const auto given = angles(key);
  return given ? from_rpy_degrees(*given) : quaternion(key);
}

}  // namespace smurf
