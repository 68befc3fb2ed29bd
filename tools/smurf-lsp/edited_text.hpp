// SPDX-License-Identifier: BSD-3-Clause
// A text that can be changed thousands of times quickly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf-lsp/positions.hpp"

namespace smurf::lsp {

/// Keeps the text in blocks with counts of lines and units. So the time of a change depends on the
/// number of blocks and the size of one, but not on its place or the length of its line.
class EditedText {
 public:
  EditedText(std::string_view text, Encoding encoding);

  /// Applies a change of a range, or of the whole text, as the protocol defines it. Places are
  /// those of offset_in().
  void apply(const Json& change);
  std::string text() const;

 private:
  struct Block {
    std::string text;
    std::size_t lines = 0;    ///< number of lines that end in the block
    std::uint32_t units = 0;  ///< not used if a line ends in the block
  };
  struct Place {
    std::size_t block = 0, byte = 0;
  };

  void count(Block& block) const;
  /// Splits a text into blocks, but not within a character.
  std::vector<Block> cut(std::string_view text) const;
  std::optional<Place> line_begin(std::uint32_t line) const;
  Place place_of(const Json& position) const;
  Place without_return(Place at) const;
  void replace(Place begin, Place end, std::string_view inserted);

  Encoding encoding_;
  std::vector<Block> blocks_;  ///< never empty
};

}  // namespace smurf::lsp
