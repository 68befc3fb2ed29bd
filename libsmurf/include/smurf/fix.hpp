// SPDX-License-Identifier: BSD-3-Clause
// Fixes of diagnostics, applied to texts.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// A file as it is with the fixes.
struct FixedText {
  std::string path;  ///< as the SourceMap names it
  std::string text;  ///< the whole file; bytes that no fix changes are copied
};

/// The changes of apply_fixes().
struct AppliedFixes {
  std::vector<FixedText> texts;  ///< changed files only, sorted by path
  std::vector<Edit> edits;       ///< the same, one by one
  std::size_t count = 0;         ///< diagnostics whose fix was applied
};

/// Applies the fixes of the diagnostics, in their order: the safe ones, and the unsafe ones too
/// when `most` is unsafe. A fix is applied whole or not at all. A fix is left for another round if
/// it overlaps an earlier fix, because its bytes have changed, or if it gives a second key of a
/// mapping the same new name.
AppliedFixes apply_fixes(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                         Applicability most);

}  // namespace smurf
