// SPDX-License-Identifier: BSD-3-Clause
// Everything here is a subset of what yaml-cpp 0.7 reads, chosen so that both agree on every byte;
// tests/unit/plain_yaml_test.cpp compares them.
#include "syntax/plain_yaml.hpp"

#include <yaml-cpp/mark.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace smurf {
namespace {

/// What a byte may be in a plain scalar.
enum class CharClass : std::uint8_t {
  foreign,    ///< tabs, carriage returns, control bytes: left to yaml-cpp
  plain,      ///< always content
  no_start,   ///< content, but not as the first byte
  flow_sign,  ///< content outside of brackets only
  ending,     ///< blank, line end, colon, number sign: depends on what is beside it
};

constexpr std::array<CharClass, 256> char_classes() {
  std::array<CharClass, 256> classes{};
  for (std::size_t c = 0x21; c < 256; ++c)
    classes[c] = c == 0x7f ? CharClass::foreign : CharClass::plain;
  for (const char c : std::string_view("&*!|>'\"%@`-"))
    classes[static_cast<unsigned char>(c)] = CharClass::no_start;
  for (const char c : std::string_view(",[]{}?"))
    classes[static_cast<unsigned char>(c)] = CharClass::flow_sign;
  for (const char c : std::string_view(" \n:#"))
    classes[static_cast<unsigned char>(c)] = CharClass::ending;
  return classes;
}
constexpr std::array<CharClass, 256> kClasses = char_classes();

/// yaml-cpp takes a longer text for a value, not for a key.
constexpr std::uint32_t kLongestKey = 1000;

class Scanner {
 public:
  Scanner(std::string_view text, YAML::EventHandler& handler) : text_(text), handler_(handler) {}

  bool run() {
    while (to_next_token()) {
      if (!close_deeper_levels() || !read_line()) return false;
    }
    if (at_ < size() || !has_content_) return false;
    while (!levels_.empty()) close_level();
    handler_.OnDocumentEnd();
    return true;
  }

 private:
  /// A block list or mapping that is open.
  struct Level {
    std::uint32_t column;
    bool is_list;
    bool awaits_value;  ///< a key or a dash was read, its value not yet
  };
  struct Scalar {
    std::uint32_t begin;
    bool is_quoted;
    std::string_view text;
    bool has_doubled_quotes;  ///< '' stands for one quote
  };

  std::uint32_t size() const { return static_cast<std::uint32_t>(text_.size()); }
  char peek(std::uint32_t ahead = 0) const {
    return at_ + ahead < size() ? text_[at_ + ahead] : '\n';
  }
  bool is_end_of_word(std::uint32_t ahead) const {
    return peek(ahead) == ' ' || peek(ahead) == '\n';
  }
  bool is_dash() const { return peek() == '-' && is_end_of_word(1); }
  CharClass char_class() const { return kClasses[static_cast<unsigned char>(peek())]; }

  YAML::Mark mark_of(std::uint32_t at) const {
    YAML::Mark mark;
    mark.pos = static_cast<int>(at);
    return mark;
  }

  void skip_spaces() {
    while (at_ < size() && text_[at_] == ' ') ++at_;
  }

  /// Over a comment, which yaml-cpp lets hold any byte; no comment may touch what stands before.
  bool skip_comment() {
    if (at_ > line_begin_ && text_[at_ - 1] != ' ') return false;
    while (at_ < size() && text_[at_] != '\n') {
      const char c = text_[at_];
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return false;
      ++at_;
    }
    return true;
  }

  /// To the next byte that is no blank, line end or comment. False at the end of the text, and when
  /// there is something that is left to yaml-cpp: at_ is before the end then.
  bool to_next_token() {
    while (at_ < size()) {
      const char c = text_[at_];
      if (c == '\n') {
        line_begin_ = ++at_;
        if (is_document_mark()) return false;
      } else if (c == ' ') {
        ++at_;
      } else if (c == '#') {
        if (!skip_comment()) return false;
      } else {
        return !(at_ == 0 && is_document_mark());
      }
    }
    return false;
  }

  bool is_document_mark() const {
    const std::string_view mark = text_.substr(at_, 3);
    return mark == "---" || mark == "..." || peek() == '%';
  }

  /// After the last token of a line: true when there is nothing but a comment.
  bool at_end_of_line() {
    skip_spaces();
    return peek() == '\n' || (peek() == '#' && skip_comment());
  }

  void tell_null() { handler_.OnNull(mark_of(at_), 0); }

  void close_level() {
    const Level level = levels_.back();
    if (level.awaits_value) tell_null();
    levels_.pop_back();
    if (level.is_list) {
      handler_.OnSequenceEnd();
    } else {
      handler_.OnMapEnd();
    }
  }

  void open_level(bool is_list) {
    if (!levels_.empty()) levels_.back().awaits_value = false;
    if (is_list) {
      handler_.OnSequenceStart(mark_of(at_), tag_, 0, YAML::EmitterStyle::Block);
    } else {
      handler_.OnMapStart(mark_of(at_), tag_, 0, YAML::EmitterStyle::Block);
    }
    levels_.push_back({at_ - line_begin_, is_list, false});
  }

  /// Closes what the column of the next token ends. False when it fits to nothing that is open.
  bool close_deeper_levels() {
    const std::uint32_t column = at_ - line_begin_;
    while (!levels_.empty() && levels_.back().column > column) close_level();
    if (levels_.empty()) return !has_content_;
    // A list may stand in the column of the key it belongs to.
    if (levels_.back().column == column && levels_.back().is_list && !is_dash()) close_level();
    if (levels_.empty()) return false;
    const Level& level = levels_.back();
    return level.column == column ? !level.is_list || is_dash() : level.awaits_value;
  }

  /// Reads the tokens of one line: dashes, a key, a value. A value in brackets may take more lines.
  bool read_line() {
    has_content_ = true;
    while (is_dash()) {
      if (!take_dash()) return false;
      ++at_;
      skip_spaces();
      if (peek() == '\n' || peek() == '#') return at_end_of_line();
    }
    if (peek() == '[' || peek() == '{') return read_flow() && at_end_of_line();
    const std::optional<Scalar> first = read_scalar(false);
    if (!first) return false;
    const std::uint32_t after = at_;
    skip_spaces();
    if (peek() != ':') return at_end_of_line() && take_value(*first);
    if (after != at_ || !is_end_of_word(1) || at_ - first->begin > kLongestKey) return false;
    return take_key(*first) && read_value();
  }

  /// The value behind a key, on its line.
  bool read_value() {
    ++at_;
    skip_spaces();
    if (peek() == '\n' || peek() == '#') return at_end_of_line();
    if (is_dash()) return false;
    if (peek() == '[' || peek() == '{') return read_flow() && at_end_of_line();
    const std::optional<Scalar> value = read_scalar(false);
    return value && at_end_of_line() && take_value(*value);
  }

  bool take_dash() {
    const std::uint32_t column = at_ - line_begin_;
    const bool is_open =
        !levels_.empty() && levels_.back().is_list && levels_.back().column == column;
    if (is_open) {
      if (levels_.back().awaits_value) tell_null();
    } else {
      if (!levels_.empty() && !levels_.back().awaits_value) return false;
      open_level(true);
    }
    levels_.back().awaits_value = true;
    return true;
  }

  bool take_key(const Scalar& key) {
    const std::uint32_t column = key.begin - line_begin_;
    const std::uint32_t after = at_;
    at_ = key.begin;
    const bool is_open =
        !levels_.empty() && !levels_.back().is_list && levels_.back().column == column;
    if (is_open) {
      if (levels_.back().awaits_value) tell_null();
    } else {
      if (!levels_.empty() && !levels_.back().awaits_value) return false;
      open_level(false);
    }
    levels_.back().awaits_value = true;
    at_ = after;
    if (is_null(key)) return false;
    tell(key);
    return true;
  }

  /// True when a value may begin here, of which the innermost level is told.
  bool begin_value(std::uint32_t at) {
    if (levels_.empty() || !levels_.back().awaits_value) return false;
    levels_.back().awaits_value = false;
    return at - line_begin_ > levels_.back().column;
  }

  bool take_value(const Scalar& value) {
    if (!begin_value(value.begin)) return false;
    tell(value);
    return true;
  }

  static bool is_null(const Scalar& scalar) {
    const std::string_view text = scalar.text;
    return !scalar.is_quoted && (text == "~" || text == "null" || text == "Null" || text == "NULL");
  }

  void tell(const Scalar& scalar) {
    if (is_null(scalar)) {
      handler_.OnNull(mark_of(scalar.begin), 0);
      return;
    }
    if (scalar.has_doubled_quotes) {
      value_.clear();
      for (std::size_t at = 0; at < scalar.text.size(); ++at) {
        value_ += scalar.text[at];
        if (scalar.text[at] == '\'') ++at;
      }
    } else {
      value_.assign(scalar.text);
    }
    handler_.OnScalar(mark_of(scalar.begin), tag_, 0, value_);
  }

  std::optional<Scalar> read_scalar(bool in_flow) {
    return peek() == '"' || peek() == '\'' ? read_quoted() : read_plain(in_flow);
  }

  /// Quotes that close on their line, without escapes.
  std::optional<Scalar> read_quoted() {
    const char quote = peek();
    Scalar scalar{at_, true, {}, false};
    for (++at_; at_ < size(); ++at_) {
      const char c = text_[at_];
      if (c == quote) {
        if (quote == '"' || peek(1) != '\'') {
          scalar.text = text_.substr(scalar.begin + 1, at_ - scalar.begin - 1);
          ++at_;
          return scalar;
        }
        scalar.has_doubled_quotes = true;
        ++at_;
      } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || (c == '\\' && quote == '"')) {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  /// Up to what ends a plain scalar on its line; blanks at its end do not belong to it.
  std::optional<Scalar> read_plain(bool in_flow) {
    if (char_class() != CharClass::plain &&
        (peek() != '-' || in_flow_stop(1) || is_end_of_word(1))) {
      return std::nullopt;
    }
    const std::uint32_t begin = at_;
    std::uint32_t end = at_;
    for (; at_ < size(); ++at_) {
      const CharClass kind = char_class();
      if (kind == CharClass::foreign) return std::nullopt;
      if (kind == CharClass::flow_sign && in_flow) break;
      if (kind == CharClass::ending) {
        const char c = peek();
        if (c == '\n') break;
        if (c == ' ') continue;
        if (c == '#' && text_[at_ - 1] == ' ') break;
        if (c == ':' && is_end_of_word(1)) break;
        if (c == ':' && in_flow) return std::nullopt;
      }
      end = at_ + 1;
    }
    if (in_flow && peek() == '?') return std::nullopt;
    at_ = end;
    return Scalar{begin, false, text_.substr(begin, end - begin), false};
  }

  bool in_flow_stop(std::uint32_t ahead) const {
    return std::string_view(",[]{}:#?").find(peek(ahead)) != std::string_view::npos;
  }

  /// A list or mapping in brackets, with all that is in it.
  bool read_flow() {
    const bool is_root = levels_.empty();  // close_deeper_levels() lets nothing follow
    if (!is_root && !begin_value(at_)) return false;
    std::vector<char> brackets;
    do {
      // A value, or the end of an empty list or mapping, or a key.
      const char c = peek();
      if (c == '[' || c == '{') {
        brackets.push_back(c);
        if (c == '[') {
          handler_.OnSequenceStart(mark_of(at_), tag_, 0, YAML::EmitterStyle::Flow);
        } else {
          handler_.OnMapStart(mark_of(at_), tag_, 0, YAML::EmitterStyle::Flow);
        }
        ++at_;
        if (!to_next_token()) return false;
        const bool is_empty = peek() == (c == '[' ? ']' : '}');
        if (!is_empty && c == '{' && !read_flow_key()) return false;
        if (!is_empty) continue;
      } else {
        const std::optional<Scalar> value = read_scalar(true);
        if (!value) return false;
        tell(*value);
      }
      if (!end_flow_entry(brackets)) return false;
    } while (!brackets.empty());
    return true;
  }

  /// `key: `, up to the value.
  bool read_flow_key() {
    const std::optional<Scalar> key = read_scalar(true);
    if (!key || is_null(*key) || peek() != ':' || !is_end_of_word(1) ||
        at_ - key->begin > kLongestKey) {
      return false;
    }
    tell(*key);
    ++at_;
    return to_next_token();
  }

  /// Closing brackets and the comma behind an entry, up to the next value.
  bool end_flow_entry(std::vector<char>& brackets) {
    while (!brackets.empty()) {
      if (!to_next_token()) return false;
      const char c = peek();
      if (c == ',') {
        ++at_;
        return to_next_token() && (brackets.back() == '[' || read_flow_key());
      }
      if (c != (brackets.back() == '[' ? ']' : '}')) return false;
      if (c == ']') {
        handler_.OnSequenceEnd();
      } else {
        handler_.OnMapEnd();
      }
      brackets.pop_back();
      ++at_;
    }
    return true;
  }

  std::string_view text_;
  YAML::EventHandler& handler_;
  std::uint32_t at_ = 0;
  std::uint32_t line_begin_ = 0;
  bool has_content_ = false;
  std::vector<Level> levels_;
  std::string value_;      ///< kept between scalars for its memory
  const std::string tag_;  ///< no tags in what is read here
};

}  // namespace

bool scan_plain_yaml(std::string_view text, YAML::EventHandler& handler) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  return !text.starts_with(kByteOrderMark) && Scanner(text, handler).run();
}

}  // namespace smurf
