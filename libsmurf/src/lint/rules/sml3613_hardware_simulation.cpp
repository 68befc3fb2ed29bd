// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/words.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3613_hardware_simulation_file {
namespace {

constexpr Circumstance kPlugin{"plugin missing"};
constexpr Circumstance kFile{"file"};
constexpr Circumstance kSensor{"sensor"};
constexpr Circumstance kImu{"imu"};

/// What gz_ros2_control and its predecessors offer as the hardware of a robot.
bool is_simulated(const Hardware& hardware) {
  const xml::View part = hardware.element.child("hardware");
  const xml::View plugin = part ? part.child("plugin") : xml::View();
  return plugin && is_one_of(trimmed(plugin.text()),
                             {"gz_ros2_control/GazeboSimSystem", "ign_ros2_control/IgnitionSystem",
                              "gazebo_ros2_control/GazeboSystem"});
}

struct Simulation {
  std::vector<xml::View> plugins;  ///< that run ros2_control
  std::vector<xml::View> sensors;

  explicit Simulation(const LinkedModel& model) {
    for (const xml::ElementId id : model.robot->extensions) {
      const xml::View gazebo(model.robot->document, id);
      if (gazebo.name() != "gazebo") continue;
      for (const xml::View child : gazebo) {
        if (child.name() == "sensor") sensors.push_back(child);
        const std::string_view file = attribute_text(child, "filename");
        const bool is_control =
            file.find("ros2_control") != std::string_view::npos ||
            attribute_text(child, "name").find("ros2_control") != std::string_view::npos;
        if (child.name() == "plugin" && is_control) plugins.push_back(child);
      }
    }
  }

  xml::View sensor(std::string_view name) const {
    for (const xml::View one : sensors) {
      if (attribute_text(one, "name") == name) return one;
    }
    return {};
  }
};

/// The state interfaces of an IMU.
constexpr std::array<std::string_view, 10> kImuStates = {
    "orientation.x",         "orientation.y",        "orientation.z",      "orientation.w",
    "angular_velocity.x",    "angular_velocity.y",   "angular_velocity.z", "linear_acceleration.x",
    "linear_acceleration.y", "linear_acceleration.z"};

void check_imu(const HardwarePart& part, const std::string& title, Findings& findings) {
  for (const HardwareInterface& one : part.interfaces) {
    if (one.name.empty() || one.is_command ||
        std::find(kImuStates.begin(), kImuStates.end(), one.name) != kImuStates.end()) {
      continue;
    }
    const Span place = place_of(one.element, "name");
    Diagnostic& found = findings.report(place, title + " is an IMU in Gazebo, which has no state " +
                                                   quoted(one.name));
    found.severity = Severity::error;
    found.when(kImu);
    const auto near = findings.suggest(one.name, kImuStates);
    found.help(near ? "did you mean " + quoted(*near) + "?"
                    : "write one of orientation.x, angular_velocity.x, linear_acceleration.x, ...");
    if (near) found.fixes.push_back({Applicability::unsafe, {{place, std::string(*near)}}});
  }
}

void check_sensors(const Hardware& hardware, const Simulation& simulation, Findings& findings) {
  std::vector<std::string_view> known;
  for (const xml::View one : simulation.sensors) known.push_back(attribute_text(one, "name"));
  for (const HardwarePart& part : hardware.parts) {
    if (part.element.name() != "sensor" || part.name.empty()) continue;
    const std::string title = title_of(part, hardware);
    if (const xml::View sensor = simulation.sensor(part.name)) {
      if (attribute_text(sensor, "type") == "imu") check_imu(part, title, findings);
      continue;
    }
    const Span place = place_of(part.element, "name");
    Diagnostic& found = findings.report(place, title + " is not a sensor of the model in Gazebo");
    found.when(kSensor);
    if (const auto near = findings.suggest(part.name, known)) {
      found.help("did you mean " + quoted(*near) + "?");
      found.fixes.push_back({Applicability::unsafe, {{place, std::string(*near)}}});
    } else {
      found.help("add a `sensor` of this name in `<gazebo reference=\"...\">`");
    }
  }
}

void check_files(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for (const PluginFile& one : companions.plugin_files) {
    const bool is_missing = one.state == PluginFile::State::missing;
    if (!is_missing && one.state != PluginFile::State::other) continue;
    const xml::View element(model.robot->document, one.element);
    findings
        .report(element.text_span(), is_missing ? "the plugin names the parameter file " +
                                                      quoted(one.path) + ", which does not exist"
                                                : "the parameter file " + quoted(one.path) +
                                                      " has no section `controller_manager`")
        .help(is_missing ? "correct the path, or add the file"
                         : "name the file with the controllers")
        .when(kFile);
  }
}

void check_plugins(const Simulation& simulation, Findings& findings) {
  for (const xml::View plugin : simulation.plugins) {
    const xml::View file = plugin.child("parameters");
    if (file && !trimmed(file.text()).empty()) continue;
    Diagnostic& found = findings.report((file ? file : plugin).name_span(),
                                        file ? "`parameters` of the plugin is empty"
                                             : "the plugin has no `parameters`");
    found.help("write the path of the file with the controllers in `<parameters>`");
    found.when(kFile);
    if (file) found.when(kNoSimulation);
  }
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot) return;
  const Simulation simulation(model);
  check_plugins(simulation, findings);
  check_files(model, companions, findings);
  for (const Hardware& hardware : hardware_of(model)) {
    if (!is_simulated(hardware)) continue;
    if (simulation.plugins.empty()) {
      const xml::View plugin = hardware.element.child("hardware").child("plugin");
      Diagnostic& found = findings.report(
          plugin.text_span(),
          title_of(hardware) + " runs in Gazebo, but no `gazebo` of the robot has the plugin");
      found.help("add `<gazebo><plugin filename=\"gz_ros2_control-system\" ...>`").when(kPlugin);
      if (!companions.lacks_simulation) found.when(kNoSimulation);
    }
    check_sensors(hardware, simulation, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::crashes, "gz_ros2_control ends with an exception",
     "gz_ros2_control gz_system.cpp registerSensors", when(kImu)},
    {&readers::ros2_control, Effect::loses, "gz_ros2_control does not offer its states",
     "gz_ros2_control gz_system.cpp registerSensors", when(kSensor)},
    {&readers::ros2_control, Effect::breaks, "gz_ros2_control reports an error and does not start",
     "gz_ros2_control gz_ros2_control_plugin.cpp Configure", when(kFile)},
    {&readers::ros2_control, Effect::breaks, "nothing loads the hardware in Gazebo",
     "gz_ros2_control gz_ros2_control_plugin.cpp", when(kPlugin)},
};

}  // namespace

extern constinit const Rule sml3613_hardware_simulation{
    .id = "SML3613",
    .name = "hardware-simulation",
    .severity = Severity::warning,
    .summary = "The hardware of a robot in Gazebo lacks its plugin, its parameters or a sensor.",
    .remedy =
        "Add the plugin of gz_ros2_control, name the file with the controllers, and use the names of the sensors.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3613_hardware_simulation_file
