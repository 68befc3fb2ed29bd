// SPDX-License-Identifier: BSD-3-Clause
// Writes values as text: deterministic, numbers as the shortest text that reads back the same.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "smurf/flatten.hpp"
#include "smurf/joint_order.hpp"
#include "smurf/limits.hpp"
#include "smurf/linked.hpp"
#include "smurf/new_model.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// Flat JSON as schemas/flat-scene.schema.json describes it. `links` writes the link poses too.
std::string write_flat_json(const FlatScene& scene, bool links);

/// A model as JSON, each entry with its place, as described by schemas/model-dump.schema.json: the
/// URDF in SI units, annotations with the types of their tables. Omits unreadable values. None if
/// the text would have more than `most` bytes.
std::optional<std::string> write_model_json(const LinkedModel& model, const SourceMap& sources,
                                            std::uint64_t most = Limits{}.scene_bytes);
/// A scene as JSON: its files, the instances with their poses in the world, and the models.
std::optional<std::string> write_scene_json(const LinkedScene& scene, const SourceMap& sources,
                                            std::uint64_t most = Limits{}.scene_bytes);

/// The orders of a robot, and the permutations between each two that are known, as JSON.
std::string write_joint_orders_json(std::span<const JointOrder> orders);

/// The files of a model, the main file last. Paths start from the folder of the output.
std::vector<TextFile> write_smurf(const NewModel& model);

}  // namespace smurf
