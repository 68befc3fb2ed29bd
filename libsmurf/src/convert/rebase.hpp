// SPDX-License-Identifier: BSD-3-Clause
// Mesh and texture paths for another folder.
#pragma once

#include <string>
#include <vector>

#include "smurf/convert.hpp"

namespace smurf {

/// Edits of the relative mesh and texture paths that do not resolve as they are written from the
/// absolute `folder`.
std::vector<Edit> rebase_paths(const LinkedModel& model, const std::string& folder,
                               const std::string& current_folder);

}  // namespace smurf
