// SPDX-License-Identifier: BSD-3-Clause
// Entities of a scene that are not models: planes and other primitives, heightmaps.
#pragma once

#include "smurf-load-check/body_plan.hpp"
#include "smurf-load-check/shape_files.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/flatten.hpp"

namespace smurf::load_check {

/// Adds fixed objects around the models. Returns the number of omitted entities: moving ones, and
/// unknown types. Reads image files.
std::size_t add_environment(const LinkedScene& scene, const FlatScene& flat, Plan& plan,
                            const ShapeFiles& files, DiagnosticSink& sink);

}  // namespace smurf::load_check
