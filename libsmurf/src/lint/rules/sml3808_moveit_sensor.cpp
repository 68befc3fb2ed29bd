// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3808_moveit_sensor_file {
namespace {

constexpr Circumstance kList{"list"};

/// The mappings of the file, the first of each name.
struct Sections {
  std::map<std::string_view, yaml::View> by_name;  ///< all keys
  std::vector<std::string_view> mappings;

  explicit Sections(yaml::View root) {
    for (const yaml::View one : root) {
      by_name.try_emplace(one.key(), one);
      if (one.is_mapping()) mappings.push_back(one.key());
    }
  }
};

void check_sensor(yaml::View name, const Sections& sections, Findings& findings) {
  const auto known = sections.by_name.find(name.text());
  const yaml::View section = known == sections.by_name.end() ? yaml::View() : known->second;
  if (section && section.is_mapping() && section.find("sensor_plugin")) return;
  if (section && section.is_mapping()) {
    findings.report(section.key_span(), "the sensor " + quoted(name.text()) + " has no plugin")
        .help("write `sensor_plugin: occupancy_map_monitor/PointCloudOctomapUpdater`");
    return;
  }
  Diagnostic& found =
      findings.report(name.span(), "there is no section for the sensor " + quoted(name.text()));
  const auto near = findings.suggest(name.text(), sections.mappings);
  found.help(near ? "did you mean " + quoted(*near) + "?"
                  : "write a mapping " + quoted(name.text()) + " with `sensor_plugin`");
  if (near) found.fixes.push_back({Applicability::unsafe, {{name.span(), std::string(*near)}}});
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_file(companions, CompanionKind::sensors_3d, [&](const Companion& file, yaml::View root) {
    const yaml::View sensors = root.find("sensors");
    if (!sensors || !sensors.is_sequence() || !file.is_ros2) return;
    const Sections sections(root);
    for (const yaml::View one : sensors) {
      if (one.is_scalar()) {
        check_sensor(one, sections, findings);
      } else if (one.is_mapping() && one.find("sensor_plugin")) {
        findings.report(sensors.key_span(), "`sensors` is a list of mappings, as in ROS 1")
            .help("write a list of names, and a mapping for each of them beside it")
            .when(kList);
        return;
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "cannot be launched: parameters are no lists of mappings",
     "launch_ros parameter types; moveit2 occupancy_map_monitor_middleware_handle.cpp",
     when(kList)},
    {&readers::moveit, Effect::loses, "reports an error and does not use the sensor",
     "moveit2 occupancy_map_monitor_middleware_handle.cpp"},
};

}  // namespace

extern constinit const Rule sml3808_moveit_sensor{
    .id = "SML3808",
    .name = "moveit-sensor",
    .severity = Severity::warning,
    .summary =
        "A sensor in sensors_3d.yaml has no section or no plugin, or is written as in ROS 1.",
    .remedy = "List the names of the sensors, and write a mapping with `sensor_plugin` for each.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3808_moveit_sensor_file
