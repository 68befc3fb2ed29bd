// SPDX-License-Identifier: BSD-3-Clause
// Findings whose effect on a reader is not certain.
#pragma once

#include "smurf/diagnostic.hpp"

namespace smurf {

/// Findings whose effect depends on files outside of the model, or on text that was not checked. A
/// refusal in a fact about them makes the verdict `not known`.
inline constexpr Circumstance kUncertain{"uncertain"};

/// Whether a fact is about such findings: everywhere, or in one place.
constexpr bool is_uncertain(const Fact& fact) { return fact.where.needs(kUncertain); }

}  // namespace smurf
