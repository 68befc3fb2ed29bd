// SPDX-License-Identifier: BSD-3-Clause
// Runs the rules over the companions of a robot.
#pragma once

#include <span>

#include "smurf/companions.hpp"
#include "smurf/lint.hpp"

namespace smurf {

/// Runs the rules about companions, and those about elements `ros2_control` of the robot.
void lint_companions(const LinkedModel& model, const Companions& companions,
                     const RuleSelection& selection, DiagnosticSink& sink);

/// Fills the pointers of the diagnostics in the companions.
void locate(const Companions& companions, std::span<Diagnostic> diagnostics);

}  // namespace smurf
