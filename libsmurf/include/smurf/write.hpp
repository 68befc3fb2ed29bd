// SPDX-License-Identifier: BSD-3-Clause
// Values to text: deterministic, numbers as the shortest text that reads back.
#pragma once

#include <string>
#include <vector>

#include "smurf/flatten.hpp"
#include "smurf/new_model.hpp"

namespace smurf {

/// Flat JSON as schemas/flat-scene.schema.json describes it. `links` writes the link poses too.
std::string write_flat_json(const FlatScene& scene, bool links);

/// The files of a model, the main file last. Paths start from the folder of the output.
std::vector<TextFile> write_smurf(const NewModel& model);

}  // namespace smurf
