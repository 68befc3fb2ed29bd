// SPDX-License-Identifier: BSD-3-Clause
// What findings mean for the targets.
#pragma once

#include <span>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/readers.hpp"

namespace smurf {

/// Sets severities, notes what each target makes of a finding, and drops what only concerns others.
void apply_targets(std::vector<Diagnostic>& diagnostics, std::span<const Reader* const> targets);

}  // namespace smurf
