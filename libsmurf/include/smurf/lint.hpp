// SPDX-License-Identifier: BSD-3-Clause
// Runs the rules over models and scenes.
#pragma once

#include <span>
#include <vector>

#include "smurf/findings.hpp"
#include "smurf/linked.hpp"
#include "smurf/readers.hpp"

namespace smurf {

void lint_model(const LinkedModel& model, const RuleSelection& selection, DiagnosticSink& sink);
/// Runs the rules about the scene itself; lint_model() checks its models.
void lint_scene(const LinkedScene& scene, const RuleSelection& selection, DiagnosticSink& sink);
/// Runs the rules about companions, and those about elements `ros2_control` of the robot.
void lint_companions(const LinkedModel& model, const Companions& companions,
                     const RuleSelection& selection, DiagnosticSink& sink);

/// Fills the pointer of every diagnostic that has none, from the trees of the model, scene or
/// companions.
void locate(const LinkedModel& model, std::span<Diagnostic> diagnostics);
void locate(const LinkedScene& scene, std::span<Diagnostic> diagnostics);
void locate(const Companions& companions, std::span<Diagnostic> diagnostics);

/// Sorts by path, line, column and id, and removes repetitions (a file may belong to two models).
void sort_findings(std::vector<Diagnostic>& diagnostics, const SourceMap& sources);

/// Applies the selection and the targets, then sort_findings(). Diagnostics must
/// be located before, because effects on readers depend on the place. With
/// targets, a finding is an error if a target reports an error, refuses the file
/// or crashes, and a warning if a target silently loses or changes something. If
/// all targets load the file as intended, a finding is one level milder. It keeps
/// its severity if there is no fact about any reader, or if the body is
/// impossible.
std::vector<Diagnostic> apply_selection(std::vector<Diagnostic> diagnostics,
                                        const SourceMap& sources, const RuleSelection& selection);

}  // namespace smurf
