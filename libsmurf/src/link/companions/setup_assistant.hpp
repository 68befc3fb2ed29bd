// SPDX-License-Identifier: BSD-3-Clause
// The files that the MoveIt Setup Assistant remembers.
#pragma once

#include "smurf/companions.hpp"

namespace smurf {

/// Sets `missing` of a `.setup_assistant`. A file of a package that is not found is not missing.
void find_missing_files(Companion& companion, LoadContext& context);

}  // namespace smurf
