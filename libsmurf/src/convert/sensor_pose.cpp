// SPDX-License-Identifier: BSD-3-Clause
#include "convert/sensor_pose.hpp"

#include <algorithm>
#include <array>

#include "base/numbers.hpp"

namespace smurf {
namespace {

/// The numbers of "x y z r p y".
std::array<double, 6> six_numbers(std::string_view text) {
  std::array<double, 6> numbers{};
  std::size_t count = 0;
  while (!text.empty() && count < numbers.size()) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) break;
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", begin), text.size());
    numbers[count++] = parse_number(text.substr(begin, end - begin)).value_or(0);
    text.remove_prefix(end);
  }
  return numbers;
}

std::array<double, 6> numbers_of(xml::View element, std::string_view attribute) {
  const xml::Attribute* found = element.attribute(attribute);
  return six_numbers(found != nullptr ? found->value : std::string_view());
}

}  // namespace

Pose sensor_pose(xml::View sensor) {
  if (const xml::View origin = sensor.child("origin")) {
    const auto xyz = numbers_of(origin, "xyz");
    const auto rpy = numbers_of(origin, "rpy");
    return {{xyz[0], xyz[1], xyz[2]}, from_rpy({rpy[0], rpy[1], rpy[2]})};
  }
  const xml::View pose = sensor.child("pose");
  const auto p = six_numbers(pose ? pose.text() : std::string_view());
  return {{p[0], p[1], p[2]}, from_rpy({p[3], p[4], p[5]})};
}

}  // namespace smurf
