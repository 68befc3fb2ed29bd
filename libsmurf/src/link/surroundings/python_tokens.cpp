// SPDX-License-Identifier: BSD-3-Clause
#include "link/surroundings/python_tokens.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <utility>

#include "base/text/quoted.hpp"

namespace smurf::python {
namespace {

bool is_name_start(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_name_part(char c) { return is_name_start(c) || (c >= '0' && c <= '9'); }

class Lexer {
 public:
  Lexer(std::string_view text, SourceId source) : text_(text), source_(source) {}

  Tokens run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n') {
        end_line();
        ++at_;
        line_begin_ = at_;
      } else if (c == ' ' || c == '\t' || c == '\r') {
        ++at_;
      } else if (c == '\\' && at_ + 1 < text_.size()) {
        at_ += text_[at_ + 1] == '\r' ? 3 : 2;
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (!text_token()) {
        other_token();
      }
    }
    if (!open_.empty()) {
      report(open_.back().span, quoted(open_.back().text) + " is never closed",
             "write " + quoted(std::string(1, closing(open_.back().text.front()))));
    }
    open_.clear();
    end_line();
    if (is_doubtful_) fault_.reset();
    if (!fault_ && !is_doubtful_) fault_ = fault_of_layout(tokens_);
    return {std::move(tokens_), std::move(fault_)};
  }

 private:
  struct Bracket {
    std::string_view text;
    Span span;
  };

  static char closing(char bracket) { return bracket == '(' ? ')' : bracket == '[' ? ']' : '}'; }

  void report(Span span, std::string message, std::string help) {
    if (!fault_) fault_ = {span, std::move(message), std::move(help)};
  }

  void close(std::string_view bracket, Span span) {
    if (open_.empty()) {
      return report(span, quoted(bracket) + " closes nothing", "delete it");
    }
    const char expected = closing(open_.back().text.front());
    if (bracket.front() != expected) {
      report(span, quoted(bracket) + " does not close " + quoted(open_.back().text),
             "write " + quoted(std::string(1, expected)) + " before it");
    }
    open_.pop_back();
  }

  void end_line() {
    const bool is_open =
        !open_.empty() || tokens_.empty() || tokens_.back().kind == Token::Kind::line;
    if (!is_open) push(Token::Kind::line, at_, at_);
  }

  Token& push(Token::Kind kind, std::size_t begin, std::size_t end) {
    Token& token = tokens_.emplace_back();
    token.kind = kind;
    token.text = text_.substr(begin, end - begin);
    token.span = {source_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    token.column = static_cast<std::uint32_t>(begin - std::min(begin, line_begin_));
    return token;
  }

  bool text_token() {
    std::size_t quote = at_;
    while (quote < text_.size() && quote - at_ < 2 && is_name_start(text_[quote])) ++quote;
    if (quote >= text_.size() || (text_[quote] != '\'' && text_[quote] != '"')) return false;
    const std::string_view prefix = text_.substr(at_, quote - at_);
    if (prefix.find_first_not_of("rRbBfFuU") != std::string_view::npos) return false;
    const char mark = text_[quote];
    const bool is_long = text_.substr(quote, 3) == std::string(3, mark);
    const std::string close(is_long ? 3 : 1, mark);
    const bool is_raw = prefix.find_first_of("rR") != std::string_view::npos;
    std::string value;
    std::size_t at = quote + close.size();
    while (at < text_.size() && text_.substr(at, close.size()) != close) {
      if (text_[at] == '\n' && !is_long) break;
      if (text_.substr(at, 3) == "\\\r\n") {  // the line goes on
        at += 3;
      } else if (text_[at] == '\\' && at + 1 < text_.size()) {
        if (is_raw) value += text_[at];
        const char next = text_[at + 1];
        if (is_raw || next != '\n') value += !is_raw && next == 'n' ? '\n' : next;
        at += 2;
      } else {
        value += text_[at++];
      }
    }
    const std::size_t end = std::min(at + close.size(), text_.size());
    Token& token = push(Token::Kind::text, at_, end);
    token.value = std::move(value);
    if (text_.substr(at, close.size()) != close) {
      report({token.span.source, token.span.begin, token.span.begin + 1}, "the text does not end",
             "write " + quoted(close) + " at its end");
    }
    // Since Python 3.12, a text may be in a text: f"{names["left"]}".
    const auto count = [&](char c) {
      return std::count(token.value.begin(), token.value.end(), c);
    };
    const bool is_f = prefix.find_first_of("fF") != std::string_view::npos;
    if (is_f && count('{') != count('}')) is_doubtful_ = true;
    token.is_format = prefix.find_first_of("fF") != std::string_view::npos &&
                      token.value.find('{') != std::string::npos;
    // The text between the quotes is the place of a finding.
    token.span.begin = static_cast<std::uint32_t>(quote + close.size());
    token.span.end = static_cast<std::uint32_t>(std::max(at, quote + close.size()));
    token.span.end = std::min(token.span.end, static_cast<std::uint32_t>(end));
    at_ = end;
    return true;
  }

  void other_token() {
    const std::size_t begin = at_;
    const char c = text_[at_];
    if (is_name_start(c) || static_cast<unsigned char>(c) >= 0x80) {
      while (at_ < text_.size() && (is_name_part(text_[at_]) || (text_[at_] & 0x80) != 0)) ++at_;
      push(Token::Kind::name, begin, at_);
    } else if (c >= '0' && c <= '9') {
      while (at_ < text_.size() && (is_name_part(text_[at_]) || text_[at_] == '.')) ++at_;
      push(Token::Kind::number, begin, at_);
    } else {
      constexpr std::string_view kLong[] = {"**=", "//=", "...", "==", "!=", "<=", ">=", "->",
                                            "**",  "//",  "+=",  "-=", "*=", "/=", ":=", "%="};
      std::size_t size = 1;
      for (const std::string_view one : kLong) {
        if (text_.substr(at_, one.size()) == one) {
          size = one.size();
          break;
        }
      }
      at_ += size;
      const Token& token = push(Token::Kind::sign, begin, at_);
      if (c == '(' || c == '[' || c == '{') open_.push_back({token.text, token.span});
      if (c == ')' || c == ']' || c == '}') close(token.text, token.span);
    }
  }

  std::string_view text_;
  SourceId source_;
  std::size_t at_ = 0, line_begin_ = 0;
  std::vector<Bracket> open_;
  std::vector<Token> tokens_;
  std::optional<Fault> fault_;
  bool is_doubtful_ = false;  ///< brackets may be in texts that were not read as such
};

}  // namespace

Tokens tokens_of(std::string_view text, SourceId source) { return Lexer(text, source).run(); }

}  // namespace smurf::python
