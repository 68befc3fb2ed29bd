// SPDX-License-Identifier: BSD-3-Clause
// The setting `xacro`: robots, and the arguments with which they are checked.
#pragma once

#include <string>
#include <vector>

#include "smurf/config.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Appends the robots of a list such as `[{file: a.urdf.xacro, arguments: {side: [left, right]}}]`.
/// Paths are relative to `folder`.
void read_xacro_setting(yaml::View value, const std::string& folder, const FileReader& files,
                        DiagnosticSink& sink, std::vector<ConfigXacro>& robots);

}  // namespace smurf
