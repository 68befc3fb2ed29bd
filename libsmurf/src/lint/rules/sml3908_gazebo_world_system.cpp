// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "lint/companions/gazebo.hpp"
#include "lint/companions/launch.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3908_gazebo_world_system_file {
namespace {

bool has_system(const LaunchWorld& world, const std::vector<GazeboPlugin>& own,
                std::string_view system) {
  for (const std::string& file : world.plugins) {
    const auto library = gazebo::library_of(file);
    if (library && library->name == system) return true;
  }
  for (const GazeboPlugin& one : own) {
    if (one.system != nullptr && one.system->name == system) return true;
  }
  return false;
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const std::vector<GazeboPlugin> own = gazebo_plugins(model);
  for (const LaunchWorld& world : companions.surroundings.worlds) {
    if (world.plugins.empty()) continue;  // the server may add them
    std::vector<std::string_view> told;
    for (const WrittenSensor& sensor : gazebo_sensors(model)) {
      const std::string_view system = gazebo::system_of_sensor(sensor.type);
      if (system.empty() || has_system(world, own, system)) continue;
      if (std::find(told.begin(), told.end(), system) != told.end()) continue;
      told.push_back(system);
      findings
          .report(world.place, "the world has no `gz-sim-" + std::string(system) +
                                   "-system`, which the sensor " + quoted(sensor.name) +
                                   " of the robot needs")
          .label(place_of(sensor.element, "name"), "the sensor is defined here")
          .help("add `<plugin filename=\"gz-sim-" + std::string(system) +
                "-system\" ...>` to the world");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "sends no data of the sensor, without a message",
     "gz-sim src/systems and server.config of ign-gazebo6 to gz-sim10"},
};

}  // namespace

extern constinit const Rule sml3908_gazebo_world_system{
    .id = "SML3908",
    .name = "gazebo-world-system",
    .severity = Severity::warning,
    .summary =
        "A world that a launch file starts lacks the system that makes the data of a sensor.",
    .remedy = "Add the system to the world.",
    .check_companions = check,
    .needs_target = true,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml3908_gazebo_world_system_file
