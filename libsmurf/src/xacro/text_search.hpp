// SPDX-License-Identifier: BSD-3-Clause
// Where a text is in another one, in time that grows with the sum of their lengths. That of
// std::string::find() grows with the product.
#pragma once

#include <cstddef>
#include <string_view>

#include "xacro/meter.hpp"

namespace smurf::xacro {

/// The two-way algorithm of Crochemore and Perrin (1991). Counts its work.
class TextSearch {
 public:
  enum class Direction : bool { forwards, backwards };

  /// `wanted` must live as long as this.
  TextSearch(std::string_view wanted, Meter& meter, Direction direction = Direction::forwards);
  /// As text.find(wanted, from), or as text.rfind(wanted).
  std::size_t find(std::string_view text, std::size_t from = 0) const;

 private:
  char wanted_at(std::size_t i) const {
    return direction_ == Direction::forwards ? wanted_[i] : wanted_[wanted_.size() - 1 - i];
  }
  /// The begin of the largest suffix by one of the two orders of characters, and its period.
  struct Suffix {
    std::size_t begin = 0, period = 1;
  };
  Suffix largest_suffix(bool is_inverse) const;
  template <class At>
  std::size_t search(const At& at, std::size_t size) const;

  std::string_view wanted_;
  Meter& meter_;
  Direction direction_;
  std::size_t middle_ = 0;    ///< wanted_ is compared from here to its end, then back to its begin
  std::size_t period_ = 1;    ///< by how much a match moves the text on
  bool is_periodic_ = false;  ///< its first part repeats in the second
};

}  // namespace smurf::xacro
