// SPDX-License-Identifier: BSD-3-Clause
// Fingerprints of lines as GitHub code scanning computes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::render {

/// For every line, "hash:n": a hash of the 100 UTF-16 units from its start, without spaces and
/// tabs, and the number of its occurrences so far. Equal to `primaryLocationLineHash` of
/// github/codeql-action (src/fingerprints.ts), which warns about other values.
class LineHashes {
 public:
  explicit LineHashes(std::string_view text);

  /// At least one, also of an empty text.
  std::size_t size() const { return hashes_.size(); }
  /// Of a line from 0; of the last line if there is none.
  std::string of(std::size_t line) const;

 private:
  std::vector<std::uint64_t> hashes_;
  std::vector<std::uint32_t> occurrences_;
};

}  // namespace smurf::render
