// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>

#include "base/text/words.hpp"
#include "lint/companions/gazebo.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3906_gazebo_misplaced_file {
namespace {

constexpr Circumstance kInLink{"in a link"};
constexpr Circumstance kInPlugin{"in a plugin"};

/// Sensors in links are SML1465.
void check_parts(const LinkedModel& model, Findings& findings) {
  for (const xml::View part : model.robot->document.view()) {
    if (!is_one_of(part.name(), {"link", "joint"})) continue;
    for (const xml::View child : part) {
      const bool is_known = child.name() == "sensor" && part.name() == "joint" &&
                            !gazebo::system_of_sensor(attribute_text(child, "type")).empty();
      if (!is_known && child.name() != "plugin") continue;
      findings
          .report(child.name_span(), "a " + quoted(child.name()) + " in a " + quoted(part.name()) +
                                         " of a URDF is not read")
          .help("move it into `<gazebo reference=\"" + std::string(attribute_text(part, "name")) +
                "\">`")
          .when(kInLink);
    }
  }
}

/// The description of a sensor inside of its plugin.
void check_plugins(const LinkedModel& model, Findings& findings) {
  for (const GazeboPlugin& plugin : gazebo_plugins(model)) {
    if (!plugin.sensor) continue;
    for (const xml::View child : plugin.element) {
      const bool is_sensor = is_one_of(child.name(), {"ray", "lidar", "camera", "imu"});
      if (!is_sensor || child.begin() == child.end() || plugin.sensor.child(child.name())) continue;
      findings
          .report(child.name_span(), quoted(child.name()) + " stands in the `plugin`, not in the "
                                                            "`sensor`, which has the defaults")
          .help("move it out of the `plugin`")
          .when(kInPlugin);
    }
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  if (!model.robot) return;
  check_parts(model, findings);
  check_plugins(model, findings);
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "makes no such sensor or plugin",
     "sdformat 12.3 parser_urdf.cc, run", when(kInLink)},
    {&readers::gazebo, Effect::changes, "gives the sensor its defaults: 640 rays of range 0",
     "sdformat 12.3, run", when(kInPlugin)},
};

}  // namespace

extern constinit const Rule sml3906_gazebo_misplaced{
    .id = "SML3906",
    .name = "gazebo-misplaced",
    .severity = Severity::warning,
    .summary = "An element for Gazebo stands where Gazebo does not read it.",
    .remedy = "Move it to where Gazebo reads it.",
    .check_companions = check,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml3906_gazebo_misplaced_file
