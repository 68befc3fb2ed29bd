// SPDX-License-Identifier: BSD-3-Clause
// The words of a text and their lines.
#pragma once

#include <cstdint>
#include <string_view>

namespace smurf {

class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  /// The next word; empty at the end.
  std::string_view next();
  /// The rest of the line without surrounding spaces; may be empty.
  std::string_view rest_of_line();
  /// The next line, in the same form; empty at the end.
  std::string_view next_line();
  bool is_at_end();

  /// Line (1-based) and byte of the last word.
  std::uint32_t line() const { return line_; }
  std::uint64_t offset() const { return begin_; }

 private:
  void skip_blanks();

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
  std::uint32_t line_ = 1;
};

}  // namespace smurf
