// SPDX-License-Identifier: BSD-3-Clause
// Angles whose value differs from the intended one.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "smurf/urdf.hpp"

namespace smurf {

/// One number of an attribute, as written and where.
struct WrittenNumber {
  std::string_view text;
  double value = 0;
  Span span;
};
/// The numbers of an attribute; none when one cannot be read or located.
std::vector<WrittenNumber> written_numbers(const xml::Attribute& attribute);

/// Calls `visit` for every `rpy` of the robot that is not plainly zero.
void for_each_turn(const urdf::Robot& robot,
                   const std::function<void(const xml::Attribute&)>& visit);

/// The multiple of pi/2 that was rounded or cut to this text: pi/2 for "1.57". None when the text
/// is no such number, or is exact to 1e-6 rad.
std::optional<double> intended_right_angle(const WrittenNumber& angle);

/// The degrees that a number would be as radians, when it is an angle that people write as a
/// fraction of pi.
std::optional<double> degrees_of_radians(double number);

/// True for a pitch so near to pi/2 that urdfdom takes it for pi/2 (pose.h:118-126: |sin| >=
/// 0.99999), and far enough for that to be seen. `rpy` are roll, pitch and yaw.
bool is_rpy_snapped(const std::vector<WrittenNumber>& rpy);

}  // namespace smurf
