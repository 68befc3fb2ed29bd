// SPDX-License-Identifier: BSD-3-Clause
// What findings mean for an exported URDF.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "smurf/convert.hpp"

namespace smurf::tools {

/// Why the URDF would be wrong with this finding. Most are none: what is wrong with the robot is
/// the same in the URDF, byte for byte.
std::optional<std::string> loss_in_urdf(const Diagnostic& finding, const LinkedModel& model,
                                        const UrdfExport& wanted);

/// Whether urdfdom surely survives a text with these findings: it crashes on some.
bool may_ask_urdfdom(std::span<const Diagnostic> findings);

}  // namespace smurf::tools
