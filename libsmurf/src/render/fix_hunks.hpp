// SPDX-License-Identifier: BSD-3-Clause
// The lines that a fix changes, before and after.
#pragma once

#include "render/json_text.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"

namespace smurf::render {

/// [{"file", "line", "before", "after"}] with whole lines; very long lines are truncated. At most
/// 20 hunks of some kilobytes each; the last one has "is_cut" if any hunk was truncated or omitted.
Json fix_hunks(const Fix& fix, const SourceMap& sources);

}  // namespace smurf::render
