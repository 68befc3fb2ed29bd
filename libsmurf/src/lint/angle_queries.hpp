// SPDX-License-Identifier: BSD-3-Clause
// Angles whose value differs from the intended one.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "smurf/urdf.hpp"

namespace smurf {

/// One number of an attribute, with its text and place.
struct WrittenNumber {
  std::string_view text;
  double value = 0;
  Span span;
};
/// The numbers of an attribute; none if one cannot be read or located.
std::vector<WrittenNumber> written_numbers(const xml::Attribute& attribute);

/// Calls `visit` for every `rpy` of the robot whose text is not a usual zero.
void for_each_turn(const urdf::Robot& robot,
                   const std::function<void(const xml::Attribute&)>& visit);

/// Whether an angle in radians is more than two turns, but no number such as 1e16 for "no limit".
bool looks_like_degrees(double angle);

/// The multiple of pi/2 that was rounded or truncated to this text: pi/2 for "1.57". None if the
/// text is not such a number, or is exact to 1e-6 rad.
std::optional<double> intended_right_angle(const WrittenNumber& angle);

/// The number in degrees if it is probably in radians, because it is a usual fraction of
/// pi.
std::optional<double> degrees_of_radians(double number);

/// Whether a pitch is so near to pi/2 that urdfdom treats it as pi/2 (pose.h:118-126: |sin| >=
/// 0.99999), but the difference is visible. `rpy` are roll, pitch and yaw.
bool is_rpy_snapped(const std::vector<WrittenNumber>& rpy);

}  // namespace smurf
