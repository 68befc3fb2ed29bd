// SPDX-License-Identifier: BSD-3-Clause
#include "link/surroundings/python_names.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "base/text/words.hpp"

namespace smurf::python {
namespace {

class Names {
 public:
  Names(const std::vector<Token>& tokens, File& file)
      : tokens_(tokens), file_(file), is_target_(tokens.size() + 1) {
    for (std::size_t k = tokens.size(); k-- > 0;) {
      const bool is_sign = tokens[k].kind == Token::Kind::sign;
      const bool is_list = tokens[k].kind == Token::Kind::name ||
                           (is_sign && is_one_of(tokens[k].text, {",", "(", ")", "[", "]"}));
      is_target_[k] = (is_sign && tokens[k].text == "=") || (is_list && is_target_[k + 1]);
    }
  }

  /// Names that are bound: imports, functions with their parameters, assignments, loops.
  void run() {
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      if (token.kind != Token::Kind::name) continue;
      const bool is_first = i == 0 || tokens_[i - 1].kind == Token::Kind::line;
      const Token& next = tokens_[i + 1];
      if (is_first && is_one_of(token.text, {"import", "from"})) {
        note_import(i);
      } else if (is_one_of(token.text, {"def", "class"}) && next.kind == Token::Kind::name) {
        file_.bound.emplace(next.text);
        if (token.text == "def") i = note_function(i) - 1;
      } else if (is_one_of(token.text, {"for", "lambda", "global", "nonlocal"})) {
        std::size_t k = i + 1;
        for (; k < tokens_.size() && tokens_[k].kind != Token::Kind::line; ++k) {
          if (tokens_[k].text == "in" || tokens_[k].text == ":") break;
          if (tokens_[k].kind == Token::Kind::name) file_.bound.emplace(tokens_[k].text);
        }
        i = k - 1;
      } else if (token.text == "as" && next.kind == Token::Kind::name) {
        file_.bound.emplace(next.text);
      } else if (next.kind == Token::Kind::sign &&
                 is_one_of(next.text, {"=", ":=", ",", ":", ")"})) {
        // An assignment, also of several names; a keyword or a value, too, which does no harm.
        if (next.text == "=" || next.text == ":=" || is_first || is_target_[i])
          file_.bound.emplace(token.text);
      }
    }
  }

 private:
  void note_import(std::size_t at) {
    std::string module;
    bool is_from = tokens_[at].text == "from";
    std::size_t k = at + 1;
    if (is_from) {
      for (; k < tokens_.size() && tokens_[k].text != "import"; ++k) {
        if (tokens_[k].kind == Token::Kind::line) return;
        module += tokens_[k].text;
      }
      ++k;
    }
    for (; k < tokens_.size() && tokens_[k].kind != Token::Kind::line; ++k) {
      if (tokens_[k].text == "*") file_.has_star_import = true;
      if (tokens_[k].kind != Token::Kind::name || tokens_[k].text == "as") continue;
      const bool is_part = k > 0 && tokens_[k - 1].text == ".";
      if (is_part) continue;
      file_.bound.emplace(tokens_[k].text);
      file_.imported[std::string(tokens_[k].text)] =
          is_from ? module : std::string(tokens_[k].text);
    }
  }

  /// Where its parameters end.
  std::size_t note_function(std::size_t at) {
    const std::uint32_t column = tokens_[at].column;
    File::Function function;
    function.name = tokens_[at + 1].text;
    function.span = tokens_[at + 1].span;
    std::size_t k = at + 2;
    int open = 0;
    for (; k < tokens_.size() && tokens_[k].kind != Token::Kind::line; ++k) {
      if (tokens_[k].text == "(") ++open;
      if (tokens_[k].text == ")" && --open == 0) break;
      if (tokens_[k].kind == Token::Kind::name) file_.bound.emplace(tokens_[k].text);
    }
    const std::size_t end = k;
    if (column > 0) return end;
    bool is_first = false;
    for (; k < tokens_.size() && tokens_[k].kind != Token::Kind::end; ++k) {
      if (tokens_[k].kind == Token::Kind::line) {
        is_first = true;
        continue;
      }
      if (is_first && tokens_[k].column <= column) break;
      is_first = false;
      function.returns =
          function.returns || is_one_of(tokens_[k].text, {"return", "yield", "raise"});
    }
    file_.functions.push_back(std::move(function));
    return end;
  }

  const std::vector<Token>& tokens_;
  File& file_;
  std::vector<bool> is_target_;  ///< by token: names, commas and brackets from it on end at `=`
};

}  // namespace

void note_names(const std::vector<Token>& tokens, File& file) { Names(tokens, file).run(); }

WrittenCall::Argument argument_of(const Value& value, std::span<const Token> tokens) {
  using Kind = WrittenCall::Argument::Kind;
  WrittenCall::Argument argument;
  if (tokens.empty()) return argument;
  const Token &first = tokens.front(), &last = tokens.back();
  const bool is_single = tokens.size() == 1;
  argument.span = first.span;
  if (const std::string* text = value.literal()) argument.text = *text;
  if (is_single && first.kind == Token::Kind::number) {
    argument.kind = Kind::number;
  } else if (is_single && is_one_of(first.text, {"True", "False"})) {
    argument.kind = Kind::truth;
  } else if (is_single && first.text == "None") {
    argument.kind = Kind::nothing;
  } else if (value.is_lazy) {
    argument.kind = Kind::lazy;
  } else if (value.kind == Value::Kind::mapping && last.text == "}") {
    argument.kind = Kind::mapping;
  } else if (value.is_list()) {
    argument.kind = Kind::list;
  } else if (value.is_text() && is_single && first.kind == Token::Kind::text) {
    argument.kind = Kind::text;
  }
  const bool is_written = argument.kind == Kind::number || argument.kind == Kind::truth;
  if (is_written) argument.text = std::string(first.text);
  return argument;
}

}  // namespace smurf::python
