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

/// See Rule::taken_over. `language`: cases::kOfMjcf or kOfSdf.
bool is_taken_over(const Rule& rule, const Circumstance& language);
/// Whether our facts about a reader are about files of such a language itself, and not about the
/// URDF of it.
bool reads_itself(const Reader& reader, const Circumstance& language);

/// Sets severities, notes the effects on each target, and removes findings about other readers.
void apply_targets(std::vector<Diagnostic>& diagnostics, std::span<const Reader* const> targets);

}  // namespace smurf
