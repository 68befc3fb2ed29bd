// SPDX-License-Identifier: BSD-3-Clause
// Values to text: deterministic, numbers as the shortest text that reads back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "smurf/flatten.hpp"
#include "smurf/limits.hpp"
#include "smurf/linked.hpp"
#include "smurf/new_model.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// Flat JSON as schemas/flat-scene.schema.json describes it. `links` writes the link poses too.
std::string write_flat_json(const FlatScene& scene, bool links);

/// All that was read of a model, each entry with its place, as schemas/model-dump.schema.json
/// describes it: the URDF in SI units, annotations as their tables understand them. What could not
/// be understood is left out. None when it would have more bytes than `most`.
std::optional<std::string> write_model_json(const LinkedModel& model, const SourceMap& sources,
                                            std::uint64_t most = Limits{}.scene_bytes);
/// The same of a scene: its files, the instances with their poses in the world, and the models.
std::optional<std::string> write_scene_json(const LinkedScene& scene, const SourceMap& sources,
                                            std::uint64_t most = Limits{}.scene_bytes);

/// The files of a model, the main file last. Paths start from the folder of the output.
std::vector<TextFile> write_smurf(const NewModel& model);

}  // namespace smurf
