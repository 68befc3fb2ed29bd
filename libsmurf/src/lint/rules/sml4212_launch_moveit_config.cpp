// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/suggest.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4212_launch_moveit_config_file {
namespace {

/// The builder takes the only file of controllers, or one with a usual name.
void check_controllers(const LaunchText& name, const SurroundingPackage& package,
                       const LaunchFile& launch, Findings& findings) {
  std::size_t count = 0;
  for (const std::string& one : package.config_files) {
    if (!one.ends_with("_controllers.yaml")) continue;
    ++count;
    if (one == "moveit_controllers.yaml" || one == "moveit2_controllers.yaml" ||
        one == name.text + "_controllers.yaml") {
      return;
    }
  }
  const auto& methods = launch.builder_methods;
  const bool is_given =
      std::find(methods.begin(), methods.end(), "trajectory_execution") != methods.end();
  if (count < 2 || is_given) return;
  findings
      .report(name.span, "MoveItConfigsBuilder cannot guess which of " + std::to_string(count) +
                             " files `*_controllers.yaml` in " + quoted(package.name) + " is meant")
      .help("call it `moveit_controllers.yaml`, or add `.trajectory_execution(file_path=...)`");
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  constexpr std::string_view kEnd = "_moveit_config";
  std::vector<std::string_view> robots;
  for (const SurroundingPackage& one : companions.surroundings.packages) {
    if (one.name.ends_with(kEnd))
      robots.push_back(std::string_view(one.name).substr(0, one.name.size() - kEnd.size()));
  }
  for_each_launch(companions, [&](const LaunchFile& launch) {
    for (const LaunchText& name : launch.moveit_configs) {
      for (const SurroundingPackage& one : companions.surroundings.packages) {
        if (name.is_known && one.name == name.text + std::string(kEnd))
          check_controllers(name, one, launch, findings);
      }
      if (!name.is_known || std::find(robots.begin(), robots.end(), name.text) != robots.end())
        continue;
      const auto near = only_nearest(name.text, robots);
      if (!near) continue;
      findings.report(name.span, "there is no package " + quoted(name.text + std::string(kEnd)))
          .help("did you mean " + quoted(*near) + "?");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::refuses, "ends the launch: PackageNotFoundError",
     "moveit2 moveit_configs_builder.py"},
};

}  // namespace

extern constinit const Rule sml4212_launch_moveit_config{
    .id = "SML4212",
    .name = "launch-moveit-config",
    .severity = Severity::error,
    .summary = "MoveItConfigsBuilder gets the name of a robot without a package.",
    .why = "The name is that of the package without `_moveit_config`.",
    .remedy = "Write the name of the robot, or add `package_name=`.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4212_launch_moveit_config_file
