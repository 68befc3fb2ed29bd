// SPDX-License-Identifier: BSD-3-Clause
// The models that a format names by file: whether its reader loads them, and copies of those that
// it does not load.
#pragma once

#include <set>
#include <string>

#include "smurf/conversion.hpp"

namespace smurf {

/// Asks `request.format.reader` about each of these models. One that it refuses is replaced in
/// `flat` by a copy in `request.model_folder` that it loads, with its meshes in a format that it
/// reads. A model without such a copy becomes the refusal of the result.
void judge_models(const SceneRequest& request, const LinkedScene& scene,
                  const std::set<std::size_t>& models, const FileReader& files,
                  const Limits& limits, FlatScene& flat, SceneResult& result);

}  // namespace smurf
