// SPDX-License-Identifier: BSD-3-Clause
// Findings at several places that have one cause become one finding. This is the only place that
// joins findings: each place keeps what readers distinguish there.
#pragma once

#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// Joins the calls of one macro, and what is repeated in a file (Diagnostic::others_are). The first
/// of the most severe places of each speaks for the others. Precondition: the findings are located.
void join_places(std::vector<Diagnostic>& found, const SourceMap& sources);

/// Adds the places of a finding that is the same in another robot or model.
void join_same(Diagnostic& kept, const Diagnostic& same);

}  // namespace smurf
