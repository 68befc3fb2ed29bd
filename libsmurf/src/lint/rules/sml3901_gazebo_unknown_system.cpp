// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/gazebo.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3901_gazebo_unknown_system_file {
namespace {

constexpr Circumstance kClass{"class"};
constexpr std::string_view kNamespaces[] = {"gz::sim::systems::", "ignition::gazebo::systems::"};

std::string plain(std::string_view name) {
  std::string all(name);
  std::erase_if(all, [](char c) { return c == '-' || c == '_'; });
  return all;
}

/// The system whose library is nearly of this name; others build libraries of the same form.
const gazebo::System* meant(std::string_view name) {
  std::vector<std::string_view> known;
  for (const gazebo::System& one : gazebo::systems()) {
    if (plain(one.name) == plain(name)) return &one;
    known.push_back(one.name);
  }
  const auto near = near_name(name, known);
  return near ? gazebo::find_system(*near) : nullptr;
}

void check_class(const GazeboPlugin& plugin, Findings& findings) {
  const std::string own = gazebo::class_of(*plugin.system);
  for (const std::string_view begin : kNamespaces) {
    if (!plugin.name.starts_with(begin)) continue;
    if (plugin.name.substr(begin.size()) == own) return;
    const Span place = place_of(plugin.element, "name");
    Diagnostic& found =
        findings.report(place, quoted(plugin.file) + " has no class " + quoted(plugin.name));
    const std::string right = std::string(begin) + own;
    found.when(kClass);
    found.help("write " + quoted(right));
    found.fixes.push_back({Applicability::unsafe, {{place, right}}});
    return;
  }
}

/// The library of gz_ros2_control, which has one class and its former name.
void check_control(const GazeboPlugin& plugin, Findings& findings) {
  std::string_view file = plugin.file;
  if (file.starts_with("lib")) file.remove_prefix(3);
  if (file.ends_with(".so")) file.remove_suffix(3);
  const bool is_new = file == "gz_ros2_control-system";
  if (!is_new && file != "ign_ros2_control-system") return;
  constexpr std::string_view kOld = "ign_ros2_control::IgnitionROS2ControlPlugin";
  constexpr std::string_view kNew = "gz_ros2_control::GazeboSimROS2ControlPlugin";
  if (plugin.name == kOld || (is_new && plugin.name == kNew) || plugin.name.empty()) return;
  const Span place = place_of(plugin.element, "name");
  const std::string right(is_new ? kNew : kOld);
  Diagnostic& found =
      findings.report(place, quoted(plugin.file) + " has no class " + quoted(plugin.name));
  found.when(kClass);
  found.help("write " + quoted(right));
  found.fixes.push_back({Applicability::unsafe, {{place, right}}});
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const GazeboPlugin& plugin : gazebo_plugins(model)) {
    check_control(plugin, findings);
    const auto library = gazebo::library_of(plugin.file);
    if (!library) continue;
    if (plugin.system != nullptr) {
      check_class(plugin, findings);
    } else if (const gazebo::System* near = meant(library->name)) {
      const Span place = place_of(plugin.element, "filename");
      const std::string right =
          (library->is_old ? "ignition-gazebo-" : "gz-sim-") + std::string(near->name) + "-system";
      Diagnostic& found =
          findings.report(place, "no system of Gazebo is called " + quoted(plugin.file));
      found.help("did you mean " + quoted(right) + "?");
      found.fixes.push_back({Applicability::unsafe, {{place, right}}});
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::breaks,
     "reports that the library does not contain the plugin, and goes on without the system",
     "gz-sim SystemLoader.cc", when(kClass)},
    {&readers::gazebo, Effect::breaks,
     "reports that it could not find the shared library, and goes on without the system",
     "gz-sim SystemLoader.cc"},
};

}  // namespace

extern constinit const Rule sml3901_gazebo_unknown_system{
    .id = "SML3901",
    .name = "gazebo-unknown-system",
    .severity = Severity::warning,
    .summary = "A plugin names a system of Gazebo that does not exist.",
    .remedy = "Write the name of the library and the class that it has.",
    .sources = "gz-sim, branches ign-gazebo6 to gz-sim10: src/systems, SystemLoader.cc.",
    .check_companions = check,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml3901_gazebo_unknown_system_file
