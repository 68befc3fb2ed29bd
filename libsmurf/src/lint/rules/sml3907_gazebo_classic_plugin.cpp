// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "lint/companions/gazebo.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3907_gazebo_classic_plugin_file {
namespace {

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const Surroundings& all = companions.surroundings;
  if (!all.launches_gazebo || all.launches_classic) return;
  for (const GazeboPlugin& plugin : gazebo_plugins(model)) {
    if (!gazebo::is_classic(plugin.file)) continue;
    bool has_both = false;
    for (const xml::View other : plugin.gazebo) {
      has_both = has_both || gazebo::library_of(attribute_text(other, "filename")).has_value();
    }
    if (has_both) continue;
    const gazebo::ClassicPlugin* known = gazebo::find_classic(plugin.file);
    findings
        .report(place_of(plugin.element, "filename"),
                quoted(plugin.file) + " belongs to Gazebo Classic, but the package launches Gazebo")
        .help(known != nullptr ? "use " + std::string(known->successor)
                               : "use a system of Gazebo: `gz-sim-...-system`");
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::breaks,
     "reports that it could not find the library, and goes on without the plugin",
     "gz-sim SystemLoader.cc; gazebo_ros_pkgs"},
};

}  // namespace

extern constinit const Rule sml3907_gazebo_classic_plugin{
    .id = "SML3907",
    .name = "gazebo-classic-plugin",
    .severity = Severity::warning,
    .summary = "A robot that is launched in Gazebo has a plugin of Gazebo Classic.",
    .remedy = "Use the system of Gazebo that replaces it.",
    .check_companions = check,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml3907_gazebo_classic_plugin_file
