// SPDX-License-Identifier: BSD-3-Clause
// The tokens of a Python file, with their places.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/source.hpp"

namespace smurf::python {

struct Token {
  enum class Kind : std::uint8_t { name, text, number, sign, line, end };
  Kind kind = Kind::end;
  std::string_view text;  ///< as written
  std::string value;      ///< of a text
  bool is_format = false;
  Span span;
  std::uint32_t column = 0;  ///< of the first token of a line
};

/// Why Python does not run a file.
struct Fault {
  Span span;
  std::string message, help;
};

struct Tokens {
  std::vector<Token> tokens;   ///< lines in brackets are one line
  std::optional<Fault> fault;  ///< the first bracket or text that does not end
};
/// What is wrong with the layout of tokens whose brackets and texts end: an indentation, a comma
/// that is missing in brackets.
std::optional<Fault> fault_of_layout(const std::vector<Token>& tokens);
/// Reads what it can, whatever is wrong.
Tokens tokens_of(std::string_view text, SourceId source);

}  // namespace smurf::python
