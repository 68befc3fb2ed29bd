// SPDX-License-Identifier: BSD-3-Clause
// Findings whose effect on a reader is not certain, or in parts that a reader does not build.
#pragma once

#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// A construct of findings whose effect depends on files outside of the model, or on text that was
/// not checked. A refusal in a fact about them makes the verdict `not known`.
inline constexpr std::string_view kUncertain = "#uncertain";
/// Adds it to the construct of a finding.
inline void mark_uncertain(Diagnostic& diagnostic) {
  diagnostic.construct += diagnostic.construct.empty() ? kUncertain.substr(1) : kUncertain;
}

/// Whether a fact is about such findings: everywhere, or in one place ("/cylinder/#uncertain").
constexpr bool is_uncertain(const Fact& fact) { return fact.where.ends_with(kUncertain); }

/// Begins the construct of findings in parts that a reader reads, but does not build: the name of
/// the reader follows.
inline constexpr std::string_view kDroppedBy = "#dropped-by-";

}  // namespace smurf
