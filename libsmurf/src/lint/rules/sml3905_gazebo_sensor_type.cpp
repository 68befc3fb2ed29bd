// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>

#include "base/text/words.hpp"
#include "lint/companions/gazebo.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3905_gazebo_sensor_type_file {
namespace {

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  bool has_classic = false;
  for (const GazeboPlugin& one : gazebo_plugins(model)) {
    has_classic = has_classic || gazebo::is_classic(one.file);
  }
  for (const WrittenSensor& sensor : gazebo_sensors(model)) {
    if (!is_one_of(sensor.type, {"ray", "lidar"})) continue;
    // A file for both simulators, or a sensor whose plugin is of Gazebo Classic.
    if (has_classic || sensor.element.child("plugin")) continue;
    const Span place = place_of(sensor.element, "type");
    findings.report(place, "Gazebo makes no sensor of type " + quoted(sensor.type))
        .help("write `gpu_lidar`");
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "reports that the type is not supported, and sends no data",
     "gz-sim SdfEntityCreator.cc, ign-gazebo6 to gz-sim10"},
};

}  // namespace

extern constinit const Rule sml3905_gazebo_sensor_type{
    .id = "SML3905",
    .name = "gazebo-sensor-type",
    .severity = Severity::warning,
    .summary = "A sensor has a type that only Gazebo Classic makes.",
    .remedy = "Write `gpu_lidar`.",
    .check_companions = check,
    .needs_target = true,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml3905_gazebo_sensor_type_file
