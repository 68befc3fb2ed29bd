// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>

#include "base/text/words.hpp"
#include "lint/companions/gazebo.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3902_gazebo_release_file {
namespace {

constexpr Circumstance kPlugin{"plugin"};
constexpr Circumstance kElement{"element"};
constexpr Circumstance kSensor{"sensor"};

void report(Span place, const std::string& what, std::string_view missing, const Circumstance& kind,
            std::string help, Findings& findings) {
  Diagnostic& found =
      findings.report(place, gazebo::release_names(missing) +
                                 (missing.size() > 1 ? " do not have " : " does not have ") + what);
  gazebo::mark_missing(missing, found);
  found.when(kind);
  found.help(std::move(help));
}

std::string without(std::string_view releases) {
  std::string rest;
  for (const char one : gazebo::kAll) {
    if (releases.find(one) == std::string_view::npos) rest += one;
  }
  return rest;
}

void check_plugin(const GazeboPlugin& plugin, Findings& findings) {
  const Span place = place_of(plugin.element, "filename");
  if (plugin.system != nullptr && plugin.system->releases != gazebo::kAll) {
    report(place,
           "the system " + quoted(plugin.file) + ", which is in " +
               gazebo::release_names(plugin.system->releases) + " only",
           without(plugin.system->releases), kPlugin,
           "use " + gazebo::release_names(plugin.system->releases) + ", or another system",
           findings);
  }
  std::string_view file = plugin.file;
  if (file.starts_with("lib")) file.remove_prefix(3);
  if (file.ends_with(".so")) file.remove_suffix(3);
  if (file == "ign_ros2_control-system") {
    report(place, "the library " + quoted(plugin.file), "HIJ", kPlugin,
           "write `gz_ros2_control-system`", findings);
  } else if (file == "gz_ros2_control-system") {
    report(place, "the library " + quoted(plugin.file), "F", kPlugin,
           "write `ign_ros2_control-system`, and the class "
           "`ign_ros2_control::IgnitionROS2ControlPlugin`",
           findings);
  }
}

/// A plugin of Gazebo Classic. An element with both kinds serves both simulators.
void check_classic(const GazeboPlugin& plugin, Findings& findings) {
  for (const xml::View other : plugin.gazebo) {
    if (gazebo::library_of(attribute_text(other, "filename"))) return;
  }
  const gazebo::ClassicPlugin* known = gazebo::find_classic(plugin.file);
  Diagnostic& found =
      findings.report(place_of(plugin.element, "filename"),
                      quoted(plugin.file) + " belongs to Gazebo Classic; Gazebo cannot load it");
  // `gazebo` without a release may be Classic, too.
  gazebo::mark_missing("GHIJ", found);
  found.when(kPlugin);
  found.help(known != nullptr ? "use " + std::string(known->successor)
                              : "use a system of Gazebo: `gz-sim-...-system`");
}

/// What a release reads as the frame of a sensor.
void check_frames(const WrittenSensor& sensor, Findings& findings) {
  const auto has = [&](std::string_view name) { return bool(sensor.element.child(name)); };
  const xml::View own = sensor.element.child("frame_id");
  const xml::View gz = sensor.element.child("gz_frame_id");
  const xml::View old = sensor.element.child("ignition_frame_id");
  if (own && !gz && !old) {
    report(own.name_span(), "`frame_id` in a sensor: they ignore it", "FGH", kElement,
           "write `gz_frame_id`, which Fortress to Ionic read", findings);
  }
  if (old && !gz && !own) {
    report(old.name_span(), "`ignition_frame_id`: they ignore it", "HIJ", kElement,
           "write `gz_frame_id`", findings);
  }
  for (const xml::View child : sensor.element) {
    const xml::View optical =
        child.name() == "camera" ? child.child("optical_frame_id") : xml::View();
    if (!optical || has("frame_id")) continue;
    report(optical.name_span(), "`optical_frame_id`: it ignores it", "J", kElement,
           "write `frame_id` in the sensor, beside `camera`", findings);
  }
}

void check_sensor(const WrittenSensor& sensor, Findings& findings) {
  check_frames(sensor, findings);
  const Span place = place_of(sensor.element, "type");
  if (sensor.type == "air_speed" || sensor.type == "wide_angle_camera") {
    report(place, "sensors of type " + quoted(sensor.type), "F", kSensor,
           "use a later release, or another sensor", findings);
  }
  if (sensor.type != "custom") return;
  const xml::Attribute* gz = sensor.element.attribute("gz:type");
  const xml::Attribute* old = sensor.element.attribute("ignition:type");
  if (gz != nullptr && old == nullptr) {
    report(gz->name_span(), "the attribute `gz:type`", "F", kSensor, "write `ignition:type`",
           findings);
  } else if (old != nullptr && gz == nullptr) {
    report(old->name_span(), "the attribute `ignition:type`", "HIJ", kSensor, "write `gz:type`",
           findings);
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const GazeboPlugin& plugin : gazebo_plugins(model)) {
    if (gazebo::is_classic(plugin.file)) {
      check_classic(plugin, findings);
    } else {
      check_plugin(plugin, findings);
    }
  }
  for (const WrittenSensor& sensor : gazebo_sensors(model)) check_sensor(sensor, findings);
}

constexpr auto kPlugins = gazebo::facts_of_releases(
    Effect::breaks, "reports that it could not find the library, and goes on without the plugin",
    "gz-sim SystemLoader.cc; src/systems of ign-gazebo6 to gz-sim10", when(kPlugin));
constexpr auto kElements = gazebo::facts_of_releases(
    Effect::loses, "ignores the element: the data come in the frame `MODEL/LINK/SENSOR`",
    "gz-sensors Sensor.cc and CameraSensor.cc, ign-sensors6 to gz-sensors10", when(kElement));
constexpr auto kSensors =
    gazebo::facts_of_releases(Effect::loses, "makes no sensor",
                              "gz-sensors Util.cc, ign-sensors6 to gz-sensors10", when(kSensor));

constexpr Fact kFacts[] = {
    kPlugins[0],
    kPlugins[1],
    kPlugins[2],
    kPlugins[3],
    kPlugins[4],
    kElements[0],
    kElements[1],
    kElements[2],
    kElements[3],
    kElements[4],
    kSensors[0],
    kSensors[1],
    kSensors[2],
    kSensors[3],
    kSensors[4],
    {&readers::gazebo, Effect::takes, "reads it", "gz-sim, gz-sensors of this release"},
};

}  // namespace

extern constinit const Rule sml3902_gazebo_release{
    .id = "SML3902",
    .name = "gazebo-release",
    .severity = Severity::warning,
    .summary = "A plugin, sensor or element for Gazebo is not in the release.",
    .remedy = "Write what the release reads.",
    .check_companions = check,
    .needs_target = true,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml3902_gazebo_release_file
