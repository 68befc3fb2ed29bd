// SPDX-License-Identifier: BSD-3-Clause
// Where files stand in their repository.
#pragma once

#include "smurf/render.hpp"

namespace smurf::tools {

/// Paths from the folder that holds `.git`, sought from the current folder upward; from the current
/// folder when there is none. Links are resolved, as code hosts know no file by two names.
RepositoryPath in_repository();

}  // namespace smurf::tools
