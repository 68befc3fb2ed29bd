// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/uncertain.hpp"
#include "base/text/lists.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3712_controller_unknown_part_file {
namespace {

constexpr std::string_view kImu =
    "orientation.x orientation.y orientation.z orientation.w angular_velocity.x "
    "angular_velocity.y angular_velocity.z linear_acceleration.x linear_acceleration.y "
    "linear_acceleration.z";
constexpr std::string_view kForceTorque = "force.x force.y force.z torque.x torque.y torque.z";
constexpr std::string_view kPose =
    "position.x position.y position.z orientation.x orientation.y orientation.z orientation.w";

/// A parameter that names parts of `ros2_control`, the elements that it may name, and the state
/// interfaces that the controller claims of them.
struct Naming {
  std::string_view type, parameter, elements, states;
};
constexpr Naming kNamings[] = {
    {"imu_sensor_broadcaster/IMUSensorBroadcaster", "sensor_name", "sensor", kImu},
    {"force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster", "sensor_name", "sensor",
     kForceTorque},
    {"range_sensor_broadcaster/RangeSensorBroadcaster", "sensor_name", "sensor", "range"},
    {"pose_broadcaster/PoseBroadcaster", "pose_name", "sensor gpio joint", kPose},
    {"gps_sensor_broadcaster/GPSSensorBroadcaster", "sensor_name", "sensor",
     "latitude longitude altitude"},
    {"magnetometer_broadcaster/MagnetometerBroadcaster", "sensor_name", "sensor",
     "magnetic_field.x magnetic_field.y magnetic_field.z"},
    {"battery_state_broadcaster/BatteryStateBroadcaster", "sensor_name", "sensor gpio joint", ""},
    {"admittance_controller/AdmittanceController", "ft_sensor.name", "sensor", kForceTorque},
    {"gpio_controllers/GpioCommandController", "gpios", "gpio", ""},
};

/// The parts of all elements `ros2_control` of a robot.
struct Parts {
  std::vector<Hardware> all;
  bool is_wholly_listed = true;  ///< no driver can offer more than the elements list

  explicit Parts(const LinkedModel& model) : all(hardware_of(model)) {
    for (const Hardware& one : all) {
      const xml::View hardware = one.element.child("hardware");
      const xml::View plugin = hardware ? hardware.child("plugin") : xml::View();
      is_wholly_listed =
          is_wholly_listed && plugin &&
          is_one_of(trimmed(plugin.text()),
                    {"mock_components/GenericSystem", "fake_components/GenericSystem",
                     "gz_ros2_control/GazeboSimSystem", "ign_ros2_control/IgnitionSystem",
                     "gazebo_ros2_control/GazeboSystem",
                     "topic_based_ros2_control/TopicBasedSystem"});
    }
  }

  const HardwarePart* find(std::string_view name, std::string_view elements) const {
    for (const Hardware& hardware : all) {
      for (const HardwarePart& part : hardware.parts) {
        if (part.name == name && is_word_of(part.element.name(), elements)) return &part;
      }
    }
    return nullptr;
  }
  std::vector<std::string_view> names(std::string_view elements) const {
    std::vector<std::string_view> found;
    for (const Hardware& hardware : all) {
      for (const HardwarePart& part : hardware.parts) {
        if (is_word_of(part.element.name(), elements)) found.push_back(part.name);
      }
    }
    return found;
  }
  static bool is_word_of(std::string_view word, std::string_view words) {
    for (std::size_t at = 0;;) {
      const std::string_view next = next_word(words, at);
      if (next.empty() || next == word) return !next.empty();
    }
  }
};

class Check {
 public:
  Check(const Parts& parts, Findings& findings) : parts_(parts), findings_(findings) {}

  void controller(const RosController& controller) {
    title_ = title_of(controller);
    for (const Naming& naming : kNamings) {
      if (naming.type != controller.known->name) continue;
      const yaml::View value = at(controller.section, naming.parameter);
      if (!value) continue;
      if (value.is_scalar()) part(value, naming);
      if (!value.is_sequence()) continue;
      for (const yaml::View item : value) {
        if (item.is_scalar()) part(item, naming);
      }
    }
    const yaml::View names = controller.section.find("interface_names");
    const bool is_force = controller.known->name.starts_with("force_torque");
    if (names && names.is_mapping() && is_force) interfaces(names);
  }

 private:
  static yaml::View at(yaml::View value, std::string_view path) {
    while (value && value.is_mapping()) {
      const std::size_t dot = path.find('.');
      value = value.find(path.substr(0, dot));
      if (dot == std::string_view::npos) return value;
      path.remove_prefix(dot + 1);
    }
    return {};
  }

  void part(yaml::View value, const Naming& naming) {
    const std::string_view name = value.text();
    if (name.empty() || is_placeholder(name)) return;
    const HardwarePart* known = parts_.find(name, naming.elements);
    if (known == nullptr) {
      const std::string kind(naming.elements.substr(0, naming.elements.find(' ')));
      unknown(value,
              title_ + " needs the " + kind + " " + quoted(name) + ", which no ros2_control has",
              parts_.names(naming.elements));
      return;
    }
    std::string missing;
    for (std::size_t next = 0;;) {
      const std::string_view state = next_word(naming.states, next);
      if (state.empty()) break;
      if (!known->has(state, false)) missing += (missing.empty() ? "" : ", ") + quoted(state);
    }
    if (missing.empty()) return;
    Diagnostic& found =
        findings_.report(value.span(), title_ + " needs the state interface " + missing + " of " +
                                           quoted(name) + ", which no ros2_control offers");
    found.label(place_of(known->element, "name"), "it is defined here");
    found.help("add it to " + quoted(name) + " in `ros2_control`");
    soften(found);
  }

  /// `interface_names: {force: {x: wrist/force.x}}`.
  void interfaces(yaml::View names) {
    for (const yaml::View axes : names) {
      if (!axes.is_mapping()) continue;
      for (const yaml::View one : axes) {
        if (!one.is_scalar() || is_placeholder(one.text())) continue;
        const std::size_t slash = one.text().find('/');
        if (slash == std::string_view::npos) continue;
        const std::string_view name = one.text().substr(0, slash);
        const HardwarePart* known = parts_.find(name, "sensor gpio joint");
        if (known == nullptr) {
          unknown(one,
                  title_ + " needs the state interface " + quoted(one.text()) +
                      ", but no ros2_control has the sensor " + quoted(name),
                  parts_.names("sensor"));
        } else if (!known->has(one.text().substr(slash + 1), false)) {
          Diagnostic& found = findings_.report(one.span(), title_ + " needs the state interface " +
                                                               quoted(one.text()) +
                                                               ", which no ros2_control offers");
          found.label(place_of(known->element, "name"), "the sensor is defined here");
          found.help("name an interface of the sensor, or add it in `ros2_control`");
          soften(found);
        }
      }
    }
  }

  void unknown(yaml::View value, const std::string& message,
               const std::vector<std::string_view>& known) {
    Diagnostic& found = findings_.report(value.span(), message);
    if (const auto near = near_name(value.text().substr(0, value.text().find('/')), known)) {
      found.help("did you mean " + quoted(*near) + "?");
      return;
    }
    soften(found);
    const std::string all = listed(all_quoted(known));
    found.help(all.empty()
                   ? "add it to `ros2_control`"
                   : "write one of " + shortened(all, 200) + ", or add it to `ros2_control`");
  }

  /// A driver may offer interfaces that its element does not list.
  void soften(Diagnostic& found) const {
    if (parts_.is_wholly_listed) return;
    found.severity = Severity::warning;
    found.when(kUncertain);
  }

  const Parts& parts_;
  Findings& findings_;
  std::string title_;
};

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const Parts parts(model);
  if (parts.all.empty()) return;                  // its hardware may be in an xacro file
  std::map<std::string_view, std::size_t> files;  // that configure a controller of this name
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& one : file.controllers) ++files[one.name];
  });
  Check check(parts, findings);
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& one : file.controllers) {
      if (one.known != nullptr && one.section && files[one.name] == 1) check.controller(one);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::breaks,
     "reports that the state interface does not exist, and does not activate the controller, "
     "unless the driver offers more than its element lists",
     "ros2_control controller_manager.cpp, resource_manager.cpp", when(kUncertain)},
    {&readers::ros2_control, Effect::breaks,
     "reports that the interface does not exist, and does not activate the controller",
     "ros2_control controller_manager.cpp, resource_manager.cpp"},
};

}  // namespace

extern constinit const Rule sml3712_controller_unknown_part{
    .id = "SML3712",
    .name = "controller-unknown-part",
    .severity = Severity::error,
    .summary = "A controller names a sensor, a GPIO or an interface that no `ros2_control` has.",
    .remedy = "Correct the name, or add the part with its interfaces to `ros2_control`.",
    .sources = "ros2_control semantic_components; ros2_controllers *_parameters.yaml.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3712_controller_unknown_part_file
