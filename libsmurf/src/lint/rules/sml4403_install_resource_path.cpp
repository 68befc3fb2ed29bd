// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4403_install_resource_path_file {
namespace {

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const Surroundings& all = companions.surroundings;
  if (all.packages.empty() || !model.robot) return;
  const SurroundingPackage& own = all.packages.front();
  const std::string begin = "package://" + own.name + "/";
  const bool has_mesh =
      std::any_of(model.meshes.begin(), model.meshes.end(),
                  [&](const MeshReference& one) { return one.filename.starts_with(begin); });
  bool starts_gazebo = false, sets_path = false;
  for (const LaunchFile& launch : all.launch_files) {
    starts_gazebo = starts_gazebo || launch.included_packages.contains("ros_gz_sim");
    sets_path = sets_path || launch.sets_resource_path;
    for (const LaunchNode& node : launch.nodes) {
      starts_gazebo = starts_gazebo || runs(node, "ros_gz_sim", "create");
    }
  }
  const bool has_hooks = std::any_of(all.packages.begin(), all.packages.end(),
                                     [](const SurroundingPackage& one) { return one.has_hooks; });
  if (!has_mesh || !starts_gazebo || sets_path || has_hooks) return;
  findings
      .report(own.export_span, "Gazebo looks for the meshes of " + quoted(own.name) +
                                   " on GZ_SIM_RESOURCE_PATH, where nothing puts the package")
      .help("add `<gazebo_ros gazebo_model_path=\"${prefix}/..\"/>` to `<export>`, or set "
            "GZ_SIM_RESOURCE_PATH in the launch file");
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "shows no meshes: it changes package:// to model://",
     "sdformat parser_urdf.cc; ros_gz_sim gz_sim.launch.py"},
};

}  // namespace

extern constinit const Rule sml4403_install_resource_path{
    .id = "SML4403",
    .name = "install-resource-path",
    .severity = Severity::warning,
    .summary = "Gazebo cannot find the meshes of a package that a launch file starts it with.",
    .remedy = "Export the path in package.xml, or set it in the launch file.",
    .check_companions = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml4403_install_resource_path_file
