// SPDX-License-Identifier: BSD-3-Clause
// Paths of one run.
#pragma once

#include "base/files/canonical_paths.hpp"
#include "smurf/plan.hpp"

namespace smurf {

/// Shared by the whole run, because it looks up each path only once.
const CanonicalPaths& canonical_paths();

}  // namespace smurf
