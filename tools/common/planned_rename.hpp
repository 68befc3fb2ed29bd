// SPDX-License-Identifier: BSD-3-Clause
// New names in all files of the models and scenes that are planned, with the proof that every name
// still means the same.
#pragma once

#include <span>
#include <string>

#include "smurf/check.hpp"
#include "smurf/rename.hpp"

namespace smurf::tools {

/// The renamed texts go to the session, in front of those on the disk, where they are loaded again
/// to see that every name means what it meant; nothing is written. Edits and problems point into
/// the loaded sources of the session. `input` is a text that is no file; "": there is none.
Renamed rename_planned(const Plan& plan, CheckSettings settings, std::span<const Rename> renames,
                       Session& session, const std::string& input = {});

}  // namespace smurf::tools
