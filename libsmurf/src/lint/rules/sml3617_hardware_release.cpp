// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3617_hardware_release_file {
namespace {

constexpr Circumstance kClass{"class"};
constexpr Circumstance kHumbleOnly{"Humble only"};
constexpr Circumstance kLater{"since Jazzy"};
constexpr Circumstance kParameter{"parameter"};

void check_class(xml::View plugin, Findings& findings) {
  const std::string_view name = trimmed(plugin.text());
  const Span place = plugin.text_span();
  if (name == "fake_components/GenericSystem") {
    Diagnostic& found = findings.report(place, "only Humble has " + quoted(name) +
                                                   "; it is `mock_components/GenericSystem` now");
    found.when(kClass).when(kHumbleOnly).help("write `mock_components/GenericSystem`");
    found.fixes.push_back({Applicability::safe, {{place, "mock_components/GenericSystem"}}});
  } else if (name == "gazebo_ros2_control/GazeboSystem") {
    findings.report(place, "only Humble has " + quoted(name) + ", which belongs to Gazebo Classic")
        .help("write `gz_ros2_control/GazeboSimSystem`")
        .when(kClass)
        .when(kHumbleOnly);
  } else if (name == "gz_ros2_control/GazeboSimSystem") {
    findings.report(place, "Humble does not have " + quoted(name) + ", unless it was built for it")
        .help("write `ign_ros2_control/IgnitionSystem`")
        .when(kClass)
        .when(kLater);
  }
}

/// Parameters of mock_components, by their names in Humble and later.
void check_parameter(xml::View parameter, Findings& findings) {
  constexpr std::string_view kKnown[] = {"mock_sensor_commands",
                                         "mock_gpio_commands",
                                         "disable_commands",
                                         "calculate_dynamics",
                                         "position_state_following_offset",
                                         "custom_interface_with_following_offset",
                                         "state_following_offset",
                                         "fake_sensor_commands",
                                         "fake_gpio_commands",
                                         "example_param_hw_start_duration_sec"};
  const std::string_view name = attribute_text(parameter, "name");
  const Span place = place_of(parameter, "name");
  if (name == "fake_sensor_commands" || name == "fake_gpio_commands") {
    const std::string right = "mock" + std::string(name.substr(4));
    Diagnostic& found = findings.report(place, "only Humble reads " + quoted(name) + "; it is " +
                                                   quoted(right) + " now");
    found.when(kParameter).when(kHumbleOnly).help("write " + quoted(right));
    found.fixes.push_back({Applicability::safe, {{place, right}}});
    return;
  }
  const auto near = only_nearest(name, kKnown);
  if (!near) return;
  Diagnostic& found = findings.report(place, "mock_components has no parameter " + quoted(name));
  found.when(kParameter).help("did you mean " + quoted(*near) + "?");
  found.fixes.push_back({Applicability::unsafe, {{place, std::string(*near)}}});
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& hardware : hardware_of(model)) {
    const xml::View part = hardware.element.child("hardware");
    const xml::View plugin = part ? part.child("plugin") : xml::View();
    if (!plugin) continue;
    check_class(plugin, findings);
    const std::string_view name = trimmed(plugin.text());
    if (name != "mock_components/GenericSystem" && name != "fake_components/GenericSystem")
      continue;
    for (const xml::View child : part) {
      if (child.name() == "param") check_parameter(child, findings);
    }
  }
}

constexpr std::string_view kNoClass = "finds no such class and loads no hardware at all";
constexpr std::string_view kClasses =
    "ros2_control mock_components_plugin_description.xml, gz_ros2_control gz_hardware_plugins.xml, "
    "branches humble, jazzy, kilted and rolling";
constexpr std::string_view kMock = "ros2_control generic_system.cpp, branches humble and jazzy";

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::refuses, kNoClass, kClasses,
     when(kClass, kHumbleOnly).since(kParserOfJazzy)},
    {&readers::ros2_control, Effect::takes, "loads it", kClasses, when(kClass, kHumbleOnly)},
    {&readers::ros2_control, Effect::changes,
     "finds no such class, unless gz_ros2_control was built for it", kClasses,
     when(kClass, kLater).before(kParserOfJazzy)},
    {&readers::ros2_control, Effect::takes, "loads it", kClasses, when(kClass, kLater)},
    {&readers::ros2_control, Effect::loses, "ignores it without a message", kMock,
     when(kParameter, kHumbleOnly).since(kParserOfJazzy)},
    {&readers::ros2_control, Effect::takes, "reads it, with a warning", kMock,
     when(kParameter, kHumbleOnly)},
    {&readers::ros2_control, Effect::loses, "ignores it without a message", kMock,
     when(kParameter)},
};

}  // namespace

extern constinit const Rule sml3617_hardware_release{
    .id = "SML3617",
    .name = "hardware-release",
    .severity = Severity::info,
    .summary = "The class or a parameter of the hardware is not in every distribution of ROS.",
    .remedy = "Write the class and the parameters of the distribution.",
    .check_companions = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml3617_hardware_release_file
