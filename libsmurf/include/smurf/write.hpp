// SPDX-License-Identifier: BSD-3-Clause
// Values to text: deterministic, numbers as the shortest text that reads back.
#pragma once

#include <string>

#include "smurf/flatten.hpp"

namespace smurf {

/// Flat JSON as schemas/flat-scene.schema.json describes it. `links` writes the link poses too.
std::string write_flat_json(const FlatScene& scene, bool links);

}  // namespace smurf
