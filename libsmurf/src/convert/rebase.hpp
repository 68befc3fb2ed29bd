// SPDX-License-Identifier: BSD-3-Clause
// Mesh and texture paths for another folder.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "smurf/convert.hpp"

namespace smurf {

/// Edits for mesh and texture paths that do not resolve from the absolute `folder`, for URIs whose
/// file was found, and for all paths with `copies` (UrdfImport::copies).
std::vector<Edit> rebase_paths(const LinkedModel& model, const std::string& folder,
                               const std::string& current_folder,
                               const std::map<std::string, std::string>& copies = {});

}  // namespace smurf
