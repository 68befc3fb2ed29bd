// SPDX-License-Identifier: BSD-3-Clause
#include "xacro/tokens.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/utf8.hpp"
#include "base/text/words.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

/// Sorted.
constexpr std::array<std::string_view, 35> kKeywords = {
    "False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
    "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
    "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
    "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield"};

bool is_name_begin(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}
bool is_name(char c) { return is_name_begin(c) || is_digit(c); }

class Splitter {
 public:
  Splitter(std::string_view text, Heap& heap, SyntaxFault& fault, std::vector<Token>& tokens)
      : text_(text), heap_(heap), fault_(fault), tokens_(tokens) {}

  void run() {
    tokens_.clear();
    while (fault_.rule == nullptr && skip_blanks()) {
      if (at_ == text_.size()) break;
      next();
    }
    if (fault_.rule == nullptr && depth_ > 0) {
      const auto begin = brackets_[depth_ - 1];
      fail(begin, begin + 1, std::string("`") + text_[begin] + "` is never closed");
    }
    if (fault_.rule != nullptr) return tokens_.clear();
    add(Token::Kind::end, at_, at_);
  }

 private:
  void fail(std::size_t begin, std::size_t end, std::string message) {
    if (fault_.rule != nullptr) return;
    fault_.rule = &rules::sml3302_xacro_syntax;
    fault_.begin = static_cast<std::uint32_t>(begin);
    fault_.end = static_cast<std::uint32_t>(std::min(end, text_.size()));
    fault_.message = std::move(message);
  }
  void fail_unsupported(std::size_t begin, std::size_t end, const std::string& what) {
    fail(begin, end, what + " is not supported");
    fault_.rule = &rules::sml3304_xacro_unsupported;
  }

  Token& add(Token::Kind kind, std::size_t begin, std::size_t end) {
    Token& token = tokens_.emplace_back();
    token.kind = kind;
    token.begin = static_cast<std::uint32_t>(begin);
    token.end = static_cast<std::uint32_t>(end);
    token.text = text_.substr(begin, end - begin);
    at_ = end;
    return token;
  }

  /// False after a fault.
  bool skip_blanks() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (c == '\n' || c == '\r') {
        if (depth_ == 0) {
          fail(at_, at_ + 1, "a line break ends the expression");
          fault_.help = "put the expression in round brackets, or on one line";
          return false;
        }
        ++at_;
      } else if (c == ' ' || c == '\t' || c == '\f') {
        ++at_;
      } else if (c == '\\' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') {
        at_ += 2;
      } else {
        return true;
      }
    }
    return true;
  }

  void next() {
    const char c = text_[at_];
    const char after = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
    if (is_digit(c) || (c == '.' && is_digit(after))) {
      number();
    } else if (c == '\'' || c == '"') {
      quoted(at_, at_);
    } else if (is_name_begin(c)) {
      name();
    } else {
      mark();
    }
  }

  void name() {
    std::size_t end = at_;
    while (end < text_.size() && is_name(text_[end])) ++end;
    if (end < text_.size() && (text_[end] == '\'' || text_[end] == '"')) return prefixed(end);
    const std::string_view word = text_.substr(at_, end - at_);
    add(is_keyword(word) ? Token::Kind::keyword : Token::Kind::name, at_, end);
  }

  void prefixed(std::size_t quote) {
    const std::string prefix = path::to_lower(text_.substr(at_, quote - at_));
    if (is_one_of(prefix, {"r", "u", "b", "br", "rb"})) return quoted(at_, quote);
    if (is_one_of(prefix, {"f", "fr", "rf"})) {
      return fail_unsupported(at_, quote + 1, "a formatted text (`f'...'`)");
    }
    fail(at_, quote + 1, "a text in quotes does not follow a name");
  }

  std::size_t digits_end(std::size_t from, bool is_hex = false) const {
    const auto is_one = [&](char c) {
      return is_digit(c) || (is_hex && std::isxdigit(static_cast<unsigned char>(c)) != 0);
    };
    while (from < text_.size() &&
           (is_one(text_[from]) ||
            (text_[from] == '_' && from + 1 < text_.size() && is_one(text_[from + 1])))) {
      ++from;
    }
    return from;
  }

  void number() {
    const std::size_t begin = at_;
    const char letter =
        begin + 1 < text_.size() ? static_cast<char>(text_[begin + 1] | 0x20) : '\0';
    if (text_[begin] == '0' && (letter == 'x' || letter == 'o' || letter == 'b')) {
      const unsigned base = letter == 'x' ? 16 : letter == 'o' ? 8 : 2;
      return integer(begin, digits_end(begin + 2, base == 16), base);
    }
    std::size_t end = digits_end(begin);
    bool is_real = false;
    if (end < text_.size() && text_[end] == '.') {
      is_real = true;
      end = digits_end(end + 1);
    }
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      std::size_t exponent = end + 1;
      if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
      if (exponent < text_.size() && is_digit(text_[exponent])) {
        is_real = true;
        end = digits_end(exponent);
      }
    }
    const bool is_imaginary = end < text_.size() && (text_[end] == 'j' || text_[end] == 'J');
    if (!is_real && !is_imaginary) return integer(begin, end, 10);
    const auto value = read_float(text_.substr(begin, end - begin));
    if (!value) return fail(begin, end, "this is no number");
    Token& token = add(Token::Kind::number, begin, end + (is_imaginary ? 1 : 0));
    token.value = is_imaginary ? heap_.complex({0.0, *value}) : Value::of(*value);
    check_number_end();
  }

  void integer(std::size_t begin, std::size_t end, unsigned base) {
    const std::string_view written = text_.substr(begin, end - begin);
    const bool has_zeros = base == 10 && written.size() > 1 && written[0] == '0' &&
                           written.find_first_not_of("0_") != std::string_view::npos;
    if (written.size() > kMostIntegerDigits) {
      return fail_unsupported(
          begin, end, "an integer of more than " + std::to_string(kMostIntegerDigits) + " digits");
    }
    const auto value = read_integer(written, heap_, base);
    if (!value || has_zeros) {
      fail(begin, end, has_zeros ? "an integer does not begin with 0" : "this is no integer");
      if (has_zeros) fault_.help = "delete the zeros at the front";
      return;
    }
    add(Token::Kind::number, begin, end).value = *value;
    check_number_end();
  }

  /// `1if x else y` is allowed, `1e` and `1a` are not.
  void check_number_end() {
    if (at_ >= text_.size() || !is_name_begin(text_[at_])) return;
    std::size_t end = at_;
    while (end < text_.size() && is_name(text_[end])) ++end;
    const std::string_view word = text_.substr(at_, end - at_);
    if (is_one_of(word, {"and", "else", "for", "if", "in", "is", "not", "or"})) return;
    fail(tokens_.back().begin, end, "this is no number");
  }

  static bool is_plain_in(char c, char quote) { return c != quote && c != '\\' && c != '\n'; }

  void quoted(std::size_t begin, std::size_t quote) {
    const std::string prefix = path::to_lower(text_.substr(begin, quote - begin));
    const bool is_raw = prefix.find('r') != std::string::npos;
    const bool is_bytes = prefix.find('b') != std::string::npos;
    const std::string_view three = text_.substr(quote, 3);
    const bool is_long = three == "'''" || three == "\"\"\"";
    const std::string_view closing = is_long ? three : text_.substr(quote, 1);
    std::string value;
    std::size_t at = quote + closing.size();
    for (;; ++at) {
      if (!is_long) {  // what needs no look
        const std::size_t begin_of_plain = at;
        while (at < text_.size() && is_plain_in(text_[at], closing[0])) ++at;
        value.append(text_, begin_of_plain, at - begin_of_plain);
      }
      if (text_.substr(at, closing.size()) == closing) break;
      if (at >= text_.size() || (text_[at] == '\n' && !is_long)) {
        return fail(begin, at, "the text in quotes is never closed");
      }
      if (text_[at] == '\\' && at + 1 < text_.size()) {
        ++at;
        if (is_raw) {
          value += {'\\', text_[at]};
        } else if (!escape(at, value)) {
          return fail(at - 1, at + 1, "this escape is not complete");
        }
      } else {
        value.push_back(text_[at]);
      }
    }
    const std::size_t end = at + closing.size();
    Token& token = add(Token::Kind::text, begin, end);
    token.value = is_bytes ? heap_.bytes(std::move(value)) : heap_.text(std::move(value));
  }

  /// `at` is behind the backslash, and at the last character of the escape afterwards.
  bool escape(std::size_t& at, std::string& value) {
    const char c = text_[at];
    constexpr std::string_view kLetters = "abfnrtv";
    constexpr std::string_view kControls = "\a\b\f\n\r\t\v";
    if (const std::size_t known = kLetters.find(c); known != std::string_view::npos) {
      value.push_back(kControls[known]);
    } else if (c == '\\' || c == '\'' || c == '"') {
      value.push_back(c);
    } else if (c == 'x' || c == 'u' || c == 'U') {
      return code_point(at, c == 'x' ? 2 : c == 'u' ? 4 : 8, value);
    } else if (c >= '0' && c <= '7') {
      unsigned code = 0;
      std::size_t end = at;
      while (end < at + 3 && end < text_.size() && text_[end] >= '0' && text_[end] <= '7') {
        code = code * 8 + static_cast<unsigned>(text_[end++] - '0');
      }
      at = end - 1;
      utf8::append(value, code);
    } else if (c != '\n') {
      value += {'\\', c};
    }
    return true;
  }

  bool code_point(std::size_t& at, std::size_t count, std::string& value) {
    if (at + count >= text_.size()) return false;
    char32_t code = 0;
    for (std::size_t i = 1; i <= count; ++i) {
      const char c = text_[at + i];
      if (std::isxdigit(static_cast<unsigned char>(c)) == 0) return false;
      code = code * 16 + static_cast<char32_t>(is_digit(c) ? c - '0' : (c | 0x20) - 'a' + 10);
    }
    constexpr char32_t kLast = 0x10FFFF;
    if (code > kLast || (code >= 0xD800 && code < 0xE000)) return false;
    at += count;
    utf8::append(value, code);
    return true;
  }

  void mark() {
    const std::size_t size = mark_size(text_.substr(at_));
    const char c = text_[at_];
    if (size == 0) {
      return fail(at_, at_ + utf8::decode(text_.substr(at_)).size,
                  "this character does not belong into an expression");
    }
    if (c == '(' || c == '[' || c == '{') {
      if (depth_ == kMostBrackets) {
        return fail(at_, at_ + 1, "there are more than 200 nested brackets");
      }
      brackets_[depth_++] = static_cast<std::uint32_t>(at_);
    } else if (c == ')' || c == ']' || c == '}') {
      const char open = c == ')' ? '(' : c == ']' ? '[' : '{';
      if (depth_ == 0 || text_[brackets_[depth_ - 1]] != open) {
        return fail(at_, at_ + 1, "`" + std::string(1, c) + "` closes nothing");
      }
      --depth_;
    }
    add(Token::Kind::mark, at_, at_ + size);
  }

  /// The size of the mark at the beginning; 0 if there is none.
  static std::size_t mark_size(std::string_view text) {
    constexpr std::string_view kOfThree = "...";
    constexpr std::string_view kOfTwo = "** // << >> <= >= == != := -> ";
    constexpr std::string_view kOfOne = "()[]{}+-*/%@&|^~<>,:.=;!?";
    if (text.starts_with(kOfThree)) return kOfThree.size();
    if (kOfOne.find(text.front()) == std::string_view::npos) return 0;
    for (std::size_t at = 0; text.size() > 1 && at < kOfTwo.size(); at += 3) {
      if (kOfTwo[at] == text[0] && kOfTwo[at + 1] == text[1]) return 2;
    }
    return 1;
  }

  std::string_view text_;
  Heap& heap_;
  SyntaxFault& fault_;
  std::size_t at_ = 0;
  std::vector<Token>& tokens_;
  static constexpr std::size_t kMostBrackets = 200;  // as Python
  std::array<std::uint32_t, kMostBrackets> brackets_;
  std::size_t depth_ = 0;  ///< of open brackets
};

}  // namespace

bool is_keyword(std::string_view word) {
  constexpr std::size_t kShortest = 2, kLongest = 8;
  if (word.size() < kShortest || word.size() > kLongest) return false;
  return std::binary_search(kKeywords.begin(), kKeywords.end(), word);
}

void split_tokens(std::string_view text, Heap& heap, SyntaxFault& fault,
                  std::vector<Token>& tokens) {
  Splitter(text, heap, fault, tokens).run();
}

}  // namespace smurf::xacro
