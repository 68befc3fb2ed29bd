// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>
#include <vector>

#include "base/text/words.hpp"
#include "lint/companions/frames.hpp"
#include "lint/companions/gazebo.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3904_gazebo_sensor_frame_file {
namespace {

constexpr Circumstance kNoFrame{"no frame"};

/// Whether ros2_control sends the data, in the frame of its broadcaster.
bool is_controlled(const std::vector<Hardware>& all, std::string_view sensor) {
  for (const Hardware& hardware : all) {
    for (const HardwarePart& part : hardware.parts) {
      if (part.name == sensor && part.element.name() == "sensor") return true;
    }
  }
  return false;
}

void check_sensor(const LinkedModel& model, const WrittenSensor& sensor,
                  const std::vector<Hardware>& hardware, bool is_gazebo, Findings& findings) {
  bool has_frame = false;
  const auto look_at = [&](xml::View element) {
    has_frame = true;
    Diagnostic* found =
        check_frame(model, text_in(element), place_in(element),
                    quoted(element.name()) + " of the sensor " + quoted(sensor.name), findings);
    if (found != nullptr && like_name(text_in(element), model.link_names.names())) {
      found->severity = Severity::warning;
      found->when(kMisspeltFrame);
    }
  };
  for (const xml::View child : sensor.element) {
    if (is_one_of(child.name(), {"gz_frame_id", "ignition_frame_id", "frame_id"})) look_at(child);
    const xml::View optical =
        child.name() == "camera" ? child.child("optical_frame_id") : xml::View();
    if (optical) look_at(optical);
    if (child.name() == "plugin") has_frame = true;  // which may set it
  }
  const bool sends_data = !gazebo::system_of_sensor(sensor.type).empty() &&
                          !is_one_of(sensor.type, {"contact", "logical_camera", "force_torque"});
  if (has_frame || !sends_data || !is_gazebo || is_controlled(hardware, sensor.name)) return;
  const std::string_view link = attribute_text(sensor.gazebo, "reference");
  if (link.empty()) return;
  const std::string robot = model.robot->name.value_or("ROBOT");
  Diagnostic& found =
      findings.report(place_of(sensor.element, "name"),
                      "the data of the sensor " + quoted(sensor.name) + " come in the frame " +
                          quoted(robot + "/" + std::string(link) + "/" + std::string(sensor.name)) +
                          ", which nobody publishes");
  found.severity = Severity::info;
  found.when(kNoFrame);
  found.help("add `<gz_frame_id>" + std::string(link) +
             "</gz_frame_id>`, or `<frame_id>` for Jetty");
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  if (!model.robot || !model.is_complete) return;
  const std::vector<WrittenSensor> sensors = gazebo_sensors(model);
  if (sensors.empty()) return;
  const std::vector<Hardware> hardware = hardware_of(model);
  const bool is_gazebo = is_for_gazebo(model);
  for (const WrittenSensor& sensor : sensors) {
    check_sensor(model, sensor, hardware, is_gazebo, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "sends data in a frame that tf2 does not know",
     "gz-sensors Sensor.cc, ign-sensors6 to gz-sensors10", when(kNoFrame)},
    {&readers::gazebo, Effect::changes, "sends data in a frame that the robot does not have",
     "gz-sensors Sensor.cc", when(kMisspeltFrame)},
    {&readers::gazebo, Effect::changes, "sends data in a frame whose name tf2 refuses",
     "gz-sensors Sensor.cc; geometry2 buffer_core.cpp", when(kSlashedFrame)},
    {&readers::gazebo, Effect::ignores, "sends data in this frame, which another node may publish",
     "gz-sensors Sensor.cc"},
};

}  // namespace

extern constinit const Rule sml3904_gazebo_sensor_frame{
    .id = "SML3904",
    .name = "gazebo-sensor-frame",
    .severity = Severity::warning,
    .summary = "A sensor in Gazebo sends its data in a frame that is no link of the robot.",
    .why = "RViz and navigation cannot place the data.",
    .remedy = "Name a link of the robot in `gz_frame_id`.",
    .check_companions = check,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml3904_gazebo_sensor_frame_file
