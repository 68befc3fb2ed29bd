// SPDX-License-Identifier: BSD-3-Clause
// The tokens of an expression.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "xacro/syntax.hpp"

namespace smurf::xacro {

struct Token {
  enum class Kind : std::uint8_t { name, keyword, number, text, mark, end };
  Kind kind = Kind::end;
  std::uint32_t begin = 0, end = 0;
  std::string_view text;  ///< as written
  Value value;            ///< of a number or a text

  bool is(std::string_view mark) const {
    return (kind == Kind::mark || kind == Kind::keyword) && text.size() == mark.size() &&
           text.front() == mark.front() && (mark.size() == 1 || text == mark);
  }
};

/// Whether a word has a meaning of its own in Python, and is no name.
bool is_keyword(std::string_view word);

/// Replaces the tokens by those of a text; by none after a fault.
void split_tokens(std::string_view text, Heap& heap, SyntaxFault& fault,
                  std::vector<Token>& tokens);

}  // namespace smurf::xacro
