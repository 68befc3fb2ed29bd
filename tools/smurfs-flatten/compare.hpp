// SPDX-License-Identifier: BSD-3-Clause
// --compare-dialects: which entities stand elsewhere, depending on who reads the scene.
#pragma once

#include <string>

#include "smurf/dialect.hpp"
#include "smurf/source.hpp"

namespace smurf::tools {

/// Lists how each reader places the entities whose world pose differs between readers, or that some
/// readers do not load; as a table of at most 80 columns, or as JSON.
std::string compare_dialects(const LinkedScene& scene, const SourceMap& sources, bool as_json);

}  // namespace smurf::tools
