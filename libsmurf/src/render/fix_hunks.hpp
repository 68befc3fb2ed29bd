// SPDX-License-Identifier: BSD-3-Clause
// The lines that a fix changes, before and after.
#pragma once

#include "render/json_text.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"

namespace smurf::render {

/// [{"file", "line", "before", "after"}]: whole lines, but for the far ends of very long ones. At
/// most 20 hunks of at most some kilobytes; one that is left out or cut has "is_cut" in the last.
Json fix_hunks(const Fix& fix, const SourceMap& sources);

}  // namespace smurf::render
