// SPDX-License-Identifier: BSD-3-Clause
// Moves findings in an expanded robot to the xacro files in which it was written.
#pragma once

#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/xacro.hpp"

namespace smurf {

/// Precondition: the findings are located. The calls around a finding become labels.
void place_in_xacro(const xacro::Expansions& expansions, const SourceMap& sources,
                    std::vector<Diagnostic>& found);

/// How findings in the URDF that is made of a language are marked; null for xacro.
const Circumstance* mark_of(Language language);

}  // namespace smurf
