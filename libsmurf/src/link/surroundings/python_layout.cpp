// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdint>
#include <string_view>

#include "base/text/words.hpp"
#include "link/surroundings/python_tokens.hpp"

namespace smurf::python {
namespace {

/// Words that stand between values, or before one.
bool is_operator(std::string_view word) {
  return is_one_of(word, {"and", "or", "not", "in", "is", "if", "else", "for", "lambda", "await",
                          "async", "from", "yield"});
}

/// Two values that follow each other in brackets, texts excepted: Python reads no such thing.
bool is_value(const Token& token) {
  return token.kind == Token::Kind::text || token.kind == Token::Kind::number ||
         (token.kind == Token::Kind::name && !is_operator(token.text));
}

bool is_missing_comma(const Token& before, const Token& token) {
  const bool ends = is_value(before) ||
                    (before.kind == Token::Kind::sign && is_one_of(before.text, {")", "]", "}"}));
  const bool is_joined = before.kind == Token::Kind::text && token.kind == Token::Kind::text;
  // `5if` is two tokens without a blank.
  return ends && is_value(token) && !is_joined && before.kind != Token::Kind::number;
}

/// The columns of the blocks that are open.
class Indentation {
 public:
  std::optional<Fault> add(const Token& first, bool is_after_colon) {
    const std::uint32_t top = columns_.empty() ? 0 : columns_.back();
    if (is_after_colon && first.column <= top)
      return Fault{first.span, "Python needs an indented block here", "indent it"};
    if (!is_after_colon && first.column > top)
      return Fault{first.span, "this line is indented more than the block", "unindent it"};
    if (first.column > top) columns_.push_back(first.column);
    while (!columns_.empty() && columns_.back() > first.column) columns_.pop_back();
    if ((columns_.empty() ? 0 : columns_.back()) != first.column)
      return Fault{first.span, "the indentation of this line fits no block around it",
                   "indent it as one of them"};
    return std::nullopt;
  }

 private:
  std::vector<std::uint32_t> columns_;
};

}  // namespace

std::optional<Fault> fault_of_layout(const std::vector<Token>& tokens) {
  Indentation indentation;
  bool is_first = true, is_after_colon = false;
  int open = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.kind == Token::Kind::line) {
      is_after_colon =
          i > 0 && tokens[i - 1].kind == Token::Kind::sign && tokens[i - 1].text == ":";
      is_first = true;
      continue;
    }
    if (is_first) {
      if (auto fault = indentation.add(token, is_after_colon)) return fault;
    }
    const bool is_sign = token.kind == Token::Kind::sign;
    if (open > 0 && !is_first && is_missing_comma(tokens[i - 1], token)) {
      return Fault{token.span, "a comma is missing before this", "write `,` before it"};
    }
    if (is_sign && is_one_of(token.text, {"(", "[", "{"})) ++open;
    if (is_sign && is_one_of(token.text, {")", "]", "}"})) --open;
    is_first = false;
  }
  return std::nullopt;
}

}  // namespace smurf::python
