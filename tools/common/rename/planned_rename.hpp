// SPDX-License-Identifier: BSD-3-Clause
// Renames things in all files of the planned models and scenes, and proves that every name still
// means the same.
#pragma once

#include <set>
#include <span>
#include <string>

#include "smurf/check.hpp"
#include "smurf/rename.hpp"

namespace smurf::tools {

/// Replaces texts in the session by their renamed versions and loads them again, to check that
/// every name has the same meaning. Writes nothing. Edits and problems point into the loaded
/// sources of the session. Files that `changeable` denies are not changed; a name in them is a
/// problem. `input` is the name of a text that is not a file, or "". `read` receives the identities
/// of all files that were loaded. A surrounding file that other robots with the name may share,
/// too, is a problem, or with `leaves_shared` stays as it is.
Renamed rename_planned(const Plan& plan, CheckSettings settings, std::span<const Rename> renames,
                       Session& session, const FileReader& changeable,
                       const std::string& input = {}, std::set<std::string>* read = nullptr,
                       bool leaves_shared = false);

}  // namespace smurf::tools
