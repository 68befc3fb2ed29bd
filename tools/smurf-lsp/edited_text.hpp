// SPDX-License-Identifier: BSD-3-Clause
// A text to which a client makes thousands of changes at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf-lsp/positions.hpp"

namespace smurf::lsp {

/// Kept in blocks whose lines and units are counted, so that a change takes time for the number of
/// blocks and for one of them, wherever it is and however long its line.
class EditedText {
 public:
  EditedText(std::string_view text, Encoding encoding);

  /// A change of a range, or of all, as the protocol has it; places as offset_in() takes them.
  void apply(const Json& change);
  std::string text() const;

 private:
  struct Block {
    std::string text;
    std::size_t lines = 0;    ///< that end in it
    std::uint32_t units = 0;  ///< 0 is never asked for of a block in which lines end
  };
  struct Place {
    std::size_t block = 0, byte = 0;
  };

  void count(Block& block) const;
  /// Blocks of a text, none of which begins within a character.
  std::vector<Block> cut(std::string_view text) const;
  std::optional<Place> line_begin(std::uint32_t line) const;
  Place place_of(const Json& position) const;
  Place without_return(Place at) const;
  void replace(Place begin, Place end, std::string_view inserted);

  Encoding encoding_;
  std::vector<Block> blocks_;  ///< never none
};

}  // namespace smurf::lsp
