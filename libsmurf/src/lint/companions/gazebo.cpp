// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/gazebo.hpp"

#include <algorithm>

#include "base/text/words.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf {
namespace {

// The recursions are as deep as the file, whose depth is limited.
void find_plugins(xml::View element, xml::View gazebo, xml::View sensor,
                  std::vector<GazeboPlugin>& found) {
  for (const xml::View child : element) {
    if (child.name() != "plugin") {
      find_plugins(child, gazebo, child.name() == "sensor" ? child : sensor, found);
      continue;
    }
    GazeboPlugin& one = found.emplace_back(GazeboPlugin{
        child, gazebo, sensor, attribute_text(child, "filename"), attribute_text(child, "name")});
    const auto library = gazebo::library_of(one.file);
    if (library) one.system = gazebo::find_system(library->name);
  }
}

void find_sensors(xml::View element, xml::View gazebo, std::vector<WrittenSensor>& found) {
  for (const xml::View child : element) {
    if (child.name() == "plugin") continue;
    if (child.name() != "sensor") {
      find_sensors(child, gazebo, found);
    } else {
      found.push_back(
          {child, gazebo, attribute_text(child, "name"), attribute_text(child, "type")});
    }
  }
}

template <class Visit>
void for_each_gazebo(const LinkedModel& model, const Visit& visit) {
  if (!model.robot) return;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() == "gazebo") visit(gazebo);
  }
}

}  // namespace

std::vector<GazeboPlugin> gazebo_plugins(const LinkedModel& model) {
  std::vector<GazeboPlugin> found;
  for_each_gazebo(model, [&](xml::View gazebo) { find_plugins(gazebo, gazebo, {}, found); });
  return found;
}

std::vector<WrittenSensor> gazebo_sensors(const LinkedModel& model) {
  std::vector<WrittenSensor> found;
  for_each_gazebo(model, [&](xml::View gazebo) { find_sensors(gazebo, gazebo, found); });
  return found;
}

bool is_for_gazebo(const LinkedModel& model) {
  bool has_system = false;
  for (const GazeboPlugin& one : gazebo_plugins(model)) {
    if (gazebo::is_classic(one.file)) return false;
    has_system =
        has_system || gazebo::library_of(one.file).has_value() ||
        is_one_of(one.file, {"gz_ros2_control-system", "ign_ros2_control-system",
                             "libgz_ros2_control-system.so", "libign_ros2_control-system.so"});
  }
  return has_system;
}

std::string_view text_in(xml::View element) { return trimmed(element.text()); }

Span place_in(xml::View element) {
  return element.text_span().empty() ? element.name_span() : element.text_span();
}

}  // namespace smurf
