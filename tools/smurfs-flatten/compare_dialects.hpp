// SPDX-License-Identifier: BSD-3-Clause
// --compare-dialects: entities whose pose depends on the program that reads the scene.
#pragma once

#include <string>

#include "smurf/dialect.hpp"
#include "smurf/source.hpp"

namespace smurf::tools {

/// Lists the entities whose world pose differs between readers, or that some readers do not load,
/// with all poses; as a table of at most 80 columns, or as JSON.
std::string compare_dialects(const LinkedScene& scene, const SourceMap& sources, bool as_json);

}  // namespace smurf::tools
