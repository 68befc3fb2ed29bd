// SPDX-License-Identifier: BSD-3-Clause
// Adjusts findings to the readers that the user names with --target.
#pragma once

#include <span>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/readers.hpp"

namespace smurf {

/// What another file or argument may settle: an info for every target.
inline constexpr Circumstance kExcused{"excused"};

/// The name of a link or joint that is there, and that sdformat merges with another when it reads
/// a URDF.
inline constexpr Circumstance kMerged{"merged"};

/// See Rule::taken_over. `where`: the cases of a finding; `language`: cases::kOfMjcf or kOfSdf.
bool is_taken_over(const Rule& rule, const Circumstances& where, const Circumstance& language);
/// Whether our facts about a reader are about files of such a language itself, and not about the
/// URDF of it.
bool reads_itself(const Reader& reader, const Circumstance& language);

/// Sets severities, notes the effects on each target, and removes findings about other readers.
void apply_targets(std::vector<Diagnostic>& diagnostics, std::span<const Reader* const> targets);

}  // namespace smurf
