// SPDX-License-Identifier: BSD-3-Clause
// Where the companions of a robot name its parts.
#pragma once

#include <vector>

#include "link/companions/library.hpp"
#include "smurf/companions.hpp"
#include "smurf/references.hpp"

namespace smurf {

/// The names of joints, links, groups and controllers in one companion, known or not.
std::vector<Reference> names_in_companion(const LinkedModel& model, const Companion& companion);

/// The names of joints and links in it, each once, without expressions.
std::vector<CompanionName> part_names(const Companion& companion);

/// Writes into the companion how many names of joints and links it has, and the model of these.
void count_names(const LinkedModel& model, Companion& companion);

}  // namespace smurf
