// SPDX-License-Identifier: BSD-3-Clause
// The words of a text and their lines.
#pragma once

#include <cstdint>
#include <string_view>

namespace smurf {

class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  /// The next word; empty at the end. Inline, like the functions below, because large files have
  /// millions of words.
  std::string_view next() {
    skip_blanks();
    begin_ = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '\n') ++at_;
    return text_.substr(begin_, at_ - begin_);
  }
  /// The rest of the line without surrounding spaces; may be empty.
  std::string_view rest_of_line();
  /// The next line, in the same form; empty at the end.
  std::string_view next_line();
  bool is_at_end() {
    skip_blanks();
    return at_ == text_.size();
  }

  /// Line (1-based) and byte of the last word.
  std::uint32_t line() const { return line_; }
  std::uint64_t offset() const { return begin_; }

 private:
  static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  }
  void skip_blanks() {
    for (; at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '\n'); ++at_) {
      if (text_[at_] == '\n') ++line_;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
  std::uint32_t line_ = 1;
};

}  // namespace smurf
