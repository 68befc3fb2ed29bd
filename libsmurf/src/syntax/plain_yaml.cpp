// SPDX-License-Identifier: BSD-3-Clause
// Everything here is a subset of what yaml-cpp 0.7 reads, chosen so that both agree on every byte;
// tests/unit/plain_yaml_test.cpp compares them.
#include "syntax/plain_yaml.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "syntax/text_check.hpp"

namespace smurf {
namespace {

/// The roles of a byte in a plain scalar. The first ones are content.
enum class CharClass : std::uint8_t {
  plain,      ///< always content
  no_start,   ///< content, except as the first byte
  flow_sign,  ///< content outside of brackets only
  ending,     ///< space, line end, colon, number sign: depends on neighbouring bytes
  foreign,    ///< tabs, carriage returns, control bytes: left to yaml-cpp
};

constexpr std::array<CharClass, 256> char_classes() {
  std::array<CharClass, 256> classes{};
  for (std::size_t c = 0; c < 256; ++c)
    classes[c] = c < 0x20 || c == 0x7f ? CharClass::foreign : CharClass::plain;
  for (const char c : std::string_view("&*!|>'\"%@`-"))
    classes[static_cast<unsigned char>(c)] = CharClass::no_start;
  for (const char c : std::string_view(",[]{}?"))
    classes[static_cast<unsigned char>(c)] = CharClass::flow_sign;
  for (const char c : std::string_view(" \n:#"))
    classes[static_cast<unsigned char>(c)] = CharClass::ending;
  return classes;
}
constexpr std::array<CharClass, 256> kCharClasses = char_classes();

/// yaml-cpp treats a text of more than 1000 bytes as a value, never as a key.
constexpr std::uint32_t kLongestKey = 1000;

class PlainScanner {
 public:
  PlainScanner(std::string_view text, YamlBuilder& builder) : text_(text), builder_(builder) {}

  std::optional<std::uint32_t> run() {
    while (to_next_token()) {
      if (!close_deeper_levels() || !read_line()) return at_;
    }
    if (at_ < size() || !has_content_) return at_;
    while (!levels_.empty()) close_level();
    return std::nullopt;
  }

 private:
  /// A block list or mapping that is open.
  struct Level {
    std::uint32_t column;
    bool is_list;
    bool awaits_value;       ///< a key or a dash was read, but not its value
    std::uint32_t sign_end;  ///< the place after that dash, or after the colon of that key
  };
  struct Scalar {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    yaml::Style style = yaml::Style::plain;
    bool has_doubled_quotes = false;  ///< '' means one quote
  };

  std::uint32_t size() const { return static_cast<std::uint32_t>(text_.size()); }
  char peek(std::uint32_t ahead = 0) const {
    return at_ + ahead < size() ? text_[at_ + ahead] : '\n';
  }
  bool is_end_of_word(std::uint32_t ahead) const {
    return peek(ahead) == ' ' || peek(ahead) == '\n';
  }
  bool is_dash() const { return peek() == '-' && is_end_of_word(1); }
  static bool is_of_tag(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  }
  static CharClass class_of(char c) { return kCharClasses[static_cast<unsigned char>(c)]; }

  void skip_spaces() {
    const std::string_view text = text_;
    std::size_t at = at_;
    while (at < text.size() && text[at] == ' ') ++at;
    at_ = static_cast<std::uint32_t>(at);
  }

  /// Skips a comment, in which yaml-cpp allows any byte. A comment must not touch the text before
  /// it.
  bool skip_comment() {
    if (at_ > line_begin_ && text_[at_ - 1] != ' ') return false;
    while (at_ < size() && text_[at_] != '\n') {
      const char c = text_[at_];
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return false;
      ++at_;
    }
    return true;
  }

  /// Skips to the next byte that is not a space, line end or comment. False at the end of the text,
  /// and at anything left to yaml-cpp; then at_ is before the end.
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
    const char c = peek();
    if (c != '-' && c != '.') return c == '%';
    const std::string_view mark = text_.substr(at_, 3);
    return mark == "---" || mark == "...";
  }

  /// After the last token of a line: whether only a comment follows.
  bool at_end_of_line() {
    skip_spaces();
    return peek() == '\n' || (peek() == '#' && skip_comment());
  }

  /// Adds the absent value that the level expects.
  void add_absent(const Level& level) {
    builder_.add_null(builder_.span(level.sign_end, level.sign_end));
  }

  void close_level() {
    if (levels_.back().awaits_value) add_absent(levels_.back());
    levels_.pop_back();
    builder_.close();
  }

  /// Begins an entry of the list or mapping in this column, and opens the collection if necessary.
  bool begin_entry(std::uint32_t begin, bool is_list, std::uint32_t sign_end) {
    const std::uint32_t column = begin - line_begin_;
    const bool is_open =
        !levels_.empty() && levels_.back().is_list == is_list && levels_.back().column == column;
    if (is_open) {
      if (levels_.back().awaits_value) add_absent(levels_.back());
    } else {
      if (!levels_.empty()) {
        if (!levels_.back().awaits_value) return false;
        levels_.back().awaits_value = false;
      }
      builder_.open(is_list ? yaml::Kind::sequence : yaml::Kind::mapping, begin, false);
      levels_.push_back({column, is_list, false, 0});
    }
    levels_.back().awaits_value = true;
    levels_.back().sign_end = sign_end;
    return true;
  }

  /// Closes all levels that the column of the next token ends. False if no open level fits the
  /// column.
  bool close_deeper_levels() {
    const std::uint32_t column = at_ - line_begin_;
    while (!levels_.empty() && levels_.back().column > column) close_level();
    if (levels_.empty()) return !has_content_;
    // A list may begin in the column of its key.
    if (levels_.back().column == column && levels_.back().is_list && !is_dash()) close_level();
    if (levels_.empty()) return false;
    const Level& level = levels_.back();
    return level.column == column ? !level.is_list || is_dash() : level.awaits_value;
  }

  /// Reads the tokens of one line: dashes, a key, a value. A value in brackets may have more lines.
  bool read_line() {
    has_content_ = true;
    const bool is_entry = is_dash();
    while (is_dash()) {
      if (!begin_entry(at_, true, at_ + 1)) return false;
      ++at_;
      skip_spaces();
      if (peek() == '\n' || peek() == '#') return at_end_of_line();
    }
    if (peek() == '[' || peek() == '{') return read_flow() && at_end_of_line();
    Scalar first;
    const bool has_tag = peek() == '!';
    // Its indentation would be that of the tag, not of the value.
    if (has_tag && !is_entry) return false;
    if (!read_tagged_scalar(first, false)) return false;
    const std::uint32_t after = at_;
    skip_spaces();
    if (peek() == ':' && has_tag) return false;
    if (peek() != ':') return at_end_of_line() && take_value(first);
    if (after != at_ || !is_end_of_word(1) || at_ - first.begin > kLongestKey) return false;
    return take_key(first) && read_value();
  }

  /// Reads the value after a key, on the same line.
  bool read_value() {
    ++at_;
    skip_spaces();
    if (peek() == '\n' || peek() == '#') return at_end_of_line();
    if (is_dash()) return false;
    if (peek() == '[' || peek() == '{') return read_flow() && at_end_of_line();
    Scalar value;
    return read_tagged_scalar(value, false) && at_end_of_line() && take_value(value);
  }

  bool take_key(const Scalar& key) {
    if (!begin_entry(key.begin, false, at_ + 1) || is_null(key)) return false;
    add_text(key);
    return true;
  }

  /// Whether a value may begin here. Informs the innermost level.
  bool begin_value(std::uint32_t at) {
    if (levels_.empty() || !levels_.back().awaits_value) return false;
    levels_.back().awaits_value = false;
    return at - line_begin_ > levels_.back().column;
  }

  bool take_value(const Scalar& value) {
    if (!begin_value(value.begin)) return false;
    add(value);
    return true;
  }

  std::string_view bytes(const Scalar& scalar) const {
    return text_.substr(scalar.begin, scalar.end - scalar.begin);
  }

  static bool is_null(std::string_view bytes) {
    return bytes == "~" || bytes == "null" || bytes == "Null" || bytes == "NULL";
  }
  bool is_null(const Scalar& scalar) const {
    const char first = text_[scalar.begin];
    return (first == '~' || first == 'n' || first == 'N') && is_null(bytes(scalar));
  }

  void add(const Scalar& scalar) {
    if (!is_null(scalar)) return add_text(scalar);
    builder_.add_null(builder_.span(scalar.begin, scalar.end));
  }

  void add_text(const Scalar& scalar) {
    std::string_view text = bytes(scalar);
    if (scalar.style != yaml::Style::plain) {
      text = text.substr(1, text.size() - 2);
      if (scalar.has_doubled_quotes) text = builder_.keep(without_doubled_quotes(text));
    }
    builder_.add_scalar(builder_.span(scalar.begin, scalar.end), scalar.style, text);
  }

  static std::string without_doubled_quotes(std::string_view text) {
    std::string single;
    for (std::size_t at = 0; at < text.size(); ++at) {
      single += text[at];
      if (text[at] == '\'') ++at;
    }
    return single;
  }

  /// A scalar, perhaps with a tag on its line: `!degrees 90`. Tags are not in the tree.
  bool read_tagged_scalar(Scalar& scalar, bool in_flow) {
    if (peek() != '!') return read_scalar(scalar, in_flow);
    const std::uint32_t begin = ++at_;
    while (is_of_tag(peek())) ++at_;
    if (at_ == begin || peek() != ' ') return false;
    skip_spaces();
    // With a tag, `null` is a text.
    return read_scalar(scalar, in_flow) && !is_null(scalar);
  }

  bool read_scalar(Scalar& scalar, bool in_flow) {
    const char first = peek();
    return first == '"' || first == '\'' ? read_quoted(scalar) : read_plain(scalar, in_flow);
  }

  /// Quotes that close on their line, without escapes.
  bool read_quoted(Scalar& scalar) {
    const char quote = peek();
    scalar = {at_, 0, quote == '"' ? yaml::Style::double_quoted : yaml::Style::single_quoted,
              false};
    for (++at_; at_ < size(); ++at_) {
      const char c = text_[at_];
      if (c == quote) {
        if (quote == '"' || peek(1) != '\'') {
          scalar.end = ++at_;
          return true;
        }
        scalar.has_doubled_quotes = true;
        ++at_;
      } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || (c == '\\' && quote == '"')) {
        return false;
      }
    }
    return false;
  }

  /// Reads to the end of a plain scalar on its line, without trailing spaces.
  bool read_plain(Scalar& scalar, bool in_flow) {
    if (class_of(peek()) != CharClass::plain &&
        (peek() != '-' || in_flow_stop(1) || is_end_of_word(1))) {
      return false;
    }
    const CharClass last_content = in_flow ? CharClass::no_start : CharClass::flow_sign;
    const std::uint32_t begin = at_;
    std::uint32_t end = at_;
    for (;; ++at_) {
      end = skip_content(last_content, end);
      const char c = peek();
      if (c == '\n' || class_of(c) == CharClass::flow_sign) break;
      if (class_of(c) == CharClass::foreign) return false;
      if (c == ' ') continue;
      if (c == '#' && text_[at_ - 1] == ' ') break;
      if (c == ':' && is_end_of_word(1)) break;
      if (c == ':' && in_flow) return false;
      end = at_ + 1;
    }
    if (in_flow && peek() == '?') return false;
    at_ = end;
    scalar = {begin, end, yaml::Style::plain, false};
    return true;
  }

  /// Returns the end of the content that begins here; `end` if there is none.
  std::uint32_t skip_content(CharClass last, std::uint32_t end) {
    const std::string_view text = text_;
    std::size_t at = at_;
    while (at < text.size() && class_of(text[at]) <= last) ++at;
    if (at != at_) end = at_ = static_cast<std::uint32_t>(at);
    return end;
  }

  bool in_flow_stop(std::uint32_t ahead) const {
    return std::string_view(",[]{}:#?").find(peek(ahead)) != std::string_view::npos;
  }

  /// Reads a list or mapping in brackets, with all its contents.
  bool read_flow() {
    const bool is_root = levels_.empty();  // close_deeper_levels() allows nothing after it
    if (!is_root && !begin_value(at_)) return false;
    std::vector<char> brackets;
    do {
      // Reads a value, the end of an empty list or mapping, or a key.
      const char c = peek();
      if (c == '[' || c == '{') {
        brackets.push_back(c);
        builder_.open(c == '[' ? yaml::Kind::sequence : yaml::Kind::mapping, at_, true);
        ++at_;
        if (!to_next_token()) return false;
        const bool is_empty = peek() == (c == '[' ? ']' : '}');
        if (!is_empty && c == '{' && !read_flow_key()) return false;
        if (!is_empty) continue;
      } else {
        Scalar value;
        if (!read_tagged_scalar(value, true)) return false;
        add(value);
      }
      if (!end_flow_entry(brackets)) return false;
    } while (!brackets.empty());
    return true;
  }

  /// `key: `, up to the value.
  bool read_flow_key() {
    Scalar key;
    if (!read_scalar(key, true) || is_null(key) || peek() != ':' || !is_end_of_word(1) ||
        at_ - key.begin > kLongestKey) {
      return false;
    }
    add_text(key);
    ++at_;
    return to_next_token();
  }

  /// Reads closing brackets and the comma after an entry, up to the next value.
  bool end_flow_entry(std::vector<char>& brackets) {
    while (!brackets.empty()) {
      if (!to_next_token()) return false;
      const char c = peek();
      if (c == ',') {
        ++at_;
        return to_next_token() && (brackets.back() == '[' || read_flow_key());
      }
      if (c != (brackets.back() == '[' ? ']' : '}')) return false;
      builder_.close(++at_);
      brackets.pop_back();
    }
    return true;
  }

  std::string_view text_;
  YamlBuilder& builder_;
  std::uint32_t at_ = 0;
  std::uint32_t line_begin_ = 0;
  bool has_content_ = false;
  std::vector<Level> levels_;
};

}  // namespace

std::optional<std::uint32_t> scan_plain_yaml(std::string_view text, YamlBuilder& builder) {
  if (byte_order_mark_size(text) > 0) return 0;
  return PlainScanner(text, builder).run();
}

}  // namespace smurf
