// SPDX-License-Identifier: BSD-3-Clause
// The parameter files that plugins of Gazebo for ros2_control name.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/companions.hpp"

namespace smurf {

/// Whether the file name of a plugin is that of gz_ros2_control or one of its predecessors.
bool is_control_plugin(std::string_view file_name);

/// The elements `parameters` of such plugins, with the state of the files.
std::vector<PluginFile> plugin_files_of(const LinkedModel& model, LoadContext& context);

/// Looks in the text of a robot for elements `<parameters>`, and adds the path that each names,
/// without the package: "/config/arm.yaml" for `$(find arm)/config/arm.yaml`.
void add_plugin_files(std::string_view text, std::set<std::string, std::less<>>& ends);

}  // namespace smurf
