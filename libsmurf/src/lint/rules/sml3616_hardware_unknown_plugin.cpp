// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/uncertain.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3616_hardware_unknown_plugin_file {
namespace {

/// Classes that many robots name, of packages that are seldom beside them.
constexpr std::array<std::string_view, 6> kKnown = {
    "fake_components/GenericSystem",   "gazebo_ros2_control/GazeboSystem",
    "gz_ros2_control/GazeboSimSystem", "ign_ros2_control/IgnitionSystem",
    "mock_components/GenericSystem",   "topic_based_ros2_control/TopicBasedSystem"};

std::string_view package_of(std::string_view name) { return name.substr(0, name.find('/')); }

/// Hardware that the packages around the robot export.
std::vector<std::string_view> exported_by(const Companions& companions, std::string_view package) {
  std::vector<std::string_view> names;
  for (const ExportedClass& one : companions.classes) {
    const bool is_hardware = one.base.starts_with("hardware_interface::");
    if (is_hardware && (package.empty() || one.package == package)) names.push_back(one.name);
  }
  return names;
}

void check_plugin(const xml::View plugin, const Companions& companions, Findings& findings) {
  const std::string_view name = trimmed(plugin.text());
  std::vector<std::string_view> known = exported_by(companions, {});
  const auto has = [&](const auto& all) {
    return std::find(all.begin(), all.end(), name) != all.end();
  };
  if (name.find('/') == std::string_view::npos || is_placeholder(name) || has(known) ||
      has(kKnown)) {
    return;
  }
  const std::vector<std::string_view> own = exported_by(companions, package_of(name));
  known.insert(known.end(), kKnown.begin(), kKnown.end());
  auto near = findings.suggest(name, known);
  // Another package exports it, unless the name is nearly that of a known one.
  constexpr int kMostEdits = 2;
  // The packages of the known classes have no others.
  const auto of_package = std::find_if(kKnown.begin(), kKnown.end(), [&](std::string_view one) {
    return package_of(one) == package_of(name);
  });
  if (own.empty() && of_package != kKnown.end()) near = *of_package;
  const bool is_slip =
      near && (of_package != kKnown.end() || edit_distance(*near, name, kMostEdits) <= kMostEdits);
  if (own.empty() && !is_slip) return;
  Diagnostic& found = findings.report(plugin.text_span(),
                                      own.empty() ? "no known hardware has the name " + quoted(name)
                                                  : "the package " + quoted(package_of(name)) +
                                                        " exports no hardware " + quoted(name));
  if (own.empty()) found.when(kUncertain);
  if (!near) {
    found.help("write a class that the package exports, such as " + quoted(own.front()));
    return;
  }
  found.help("did you mean " + quoted(*near) + "?");
  found.fixes.push_back({Applicability::unsafe, {{plugin.text_span(), std::string(*near)}}});
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for (const Hardware& hardware : hardware_of(model)) {
    const xml::View part = hardware.element.child("hardware");
    const xml::View plugin = part ? part.child("plugin") : xml::View();
    if (plugin) check_plugin(plugin, companions, findings);
  }
}

constexpr std::string_view kSource =
    "ros2_control hardware_interface/src/resource_manager.cpp load_hardware";
constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::refuses,
     "loads no hardware, unless another package exports the class", kSource, when(kUncertain)},
    {&readers::ros2_control, Effect::refuses, "finds no such class and loads no hardware at all",
     kSource},
    {&readers::ros, Effect::breaks, "ros2_control loads no hardware", kSource},
};

}  // namespace

extern constinit const Rule sml3616_hardware_unknown_plugin{
    .id = "SML3616",
    .name = "hardware-unknown-plugin",
    .severity = Severity::warning,
    .summary = "No package around the robot exports the class of its hardware.",
    .why =
        "A `plugin` is the name of a class in a plugin description of pluginlib. Nothing is reported for packages "
        "that are not beside the robot, unless the name is nearly that of a well-known class.",
    .remedy = "Write the name as the plugin description of the package has it.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3616_hardware_unknown_plugin_file
