// SPDX-License-Identifier: BSD-3-Clause
// The setting `companions`: files of ROS that belong to a robot.
#pragma once

#include <string>
#include <vector>

#include "smurf/config.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Appends the entries of a list such as `[{robot: a.urdf, files: [controllers.yaml]}]`. Paths are
/// relative to `folder`.
void read_companion_setting(yaml::View value, const std::string& folder, const FileReader& files,
                            DiagnosticSink& sink, std::vector<ConfigCompanions>& robots);

}  // namespace smurf
