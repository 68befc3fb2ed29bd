// SPDX-License-Identifier: BSD-3-Clause
// Fingerprints of lines as GitHub code scanning computes them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace smurf::render {

/// For every line, "hash:n": a hash of the 100 UTF-16 units from its start, without spaces and
/// tabs, and the number of its occurrences so far. Equal to `primaryLocationLineHash` of
/// github/codeql-action (src/fingerprints.ts), which warns about other values.
std::vector<std::string> line_hashes(std::string_view text);

}  // namespace smurf::render
