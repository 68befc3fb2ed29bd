// SPDX-License-Identifier: BSD-3-Clause
// --compare-dialects: which entities stand elsewhere, depending on who reads the scene.
#pragma once

#include <string>

#include "smurf/dialect.hpp"
#include "smurf/source.hpp"

namespace smurf::tools {

/// The readings of every entity whose world pose is not the same to all readers, or that some of
/// them do not load. As a table of at most 80 columns for people, or as JSON.
std::string compare_dialects(const LinkedScene& scene, const SourceMap& sources, bool as_json);

}  // namespace smurf::tools
