// SPDX-License-Identifier: BSD-3-Clause
#include "convert/gazebo_sensors.hpp"

#include <array>

#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"
#include "convert/import.hpp"

namespace smurf {
namespace {

/// The numbers of "x y z r p y".
std::array<double, 6> six_numbers(std::string_view text) {
  std::array<double, 6> numbers{};
  std::size_t at = 0;
  for (double& number : numbers) number = parse_number(next_word(text, at)).value_or(0);
  return numbers;
}

std::array<double, 6> numbers_of(xml::View element, std::string_view attribute) {
  const xml::Attribute* found = element.attribute(attribute);
  return six_numbers(found != nullptr ? found->value() : std::string_view());
}

}  // namespace

std::vector<GazeboSensor> gazebo_sensors(const urdf::Robot& robot) {
  std::vector<GazeboSensor> sensors;
  for (const xml::ElementId id : robot.extensions) {
    const xml::View gazebo(robot.document, id);
    if (gazebo.name() != "gazebo") continue;
    for (const xml::View child : gazebo) {
      if (child.name() == "sensor") {
        sensors.push_back({child, attribute_of(gazebo, "reference")});
      }
    }
  }
  return sensors;
}

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
