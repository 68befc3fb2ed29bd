// SPDX-License-Identifier: BSD-3-Clause
// What findings mean for a flattened scene.
#pragma once

#include <optional>
#include <string>

#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"

namespace smurf::tools {

/// Why poses or shapes of the result would be wrong with this finding. What is wrong with the
/// masses or the motors of a robot does not move it.
std::optional<std::string> loss_in_scene(const Diagnostic& finding, const SourceMap& sources);

}  // namespace smurf::tools
