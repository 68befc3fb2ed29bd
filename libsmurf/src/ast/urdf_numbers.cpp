// SPDX-License-Identifier: BSD-3-Clause
// The strict grammar is that of urdfdom 3.0.1 (utils.h:73-88): the text must be a decimal number to
// its last byte, vector components are separated by the space character.
#include "ast/urdf_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/file_cases.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"
#include "base/numbers/floating.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

/// Whether a text is not a number, but resembles one.
bool is_out_of_range(std::string_view text) {
  const std::size_t e = text.find('e');
  if (e == std::string_view::npos || e + 1 >= text.size()) return false;
  std::string_view exponent = text.substr(e + 1);
  if (exponent.front() == '-' || exponent.front() == '+') exponent.remove_prefix(1);
  const std::string_view mantissa = text.substr(0, e);
  return !exponent.empty() && std::all_of(exponent.begin(), exponent.end(), is_digit) &&
         parse_number(mantissa).has_value();
}

struct Token {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

std::vector<Token> split(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t at = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    tokens.push_back(
        {static_cast<std::uint32_t>(at - word.size()), static_cast<std::uint32_t>(at)});
  }
  return tokens;
}

/// Some readers refuse numbers below the precision of a double.
bool is_subnormal(double value) {
  return value != 0 && std::fabs(value) < std::numeric_limits<double>::min();
}

/// Reads numbers on which all readers agree, as on nearly all; false for a text that needs further
/// checks.
bool read_plain(std::string_view text, std::span<double> out) {
  std::size_t at = 0;
  for (double& value : out) {
    while (at < text.size() && text[at] == ' ') ++at;
    const std::size_t begin = at;
    while (at < text.size() && text[at] != ' ') ++at;
    const std::optional<double> read = parse_number(text.substr(begin, at - begin));
    if (!read || is_subnormal(*read)) return false;
    value = *read;
  }
  return at == text.size();
}

std::size_t count_between_spaces(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != ' ' && (i == 0 || text[i - 1] == ' ')) ++count;
  }
  return count;
}

class NumberReader {
 public:
  NumberReader(const xml::Attribute& attribute, DiagnosticSink& sink)
      : attribute_(attribute), text_(attribute.value()), sink_(sink) {}

  bool read(std::span<double> out) {
    wanted_ = out.size();
    if (has_residue() || is_comma_separated()) return false;
    const std::vector<Token> tokens = split(text_);
    miscount_ = tokens.size() > out.size()   ? &cases::kTooMany
                : tokens.size() < out.size() ? &cases::kTooFew
                                             : nullptr;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      const std::optional<double> value = number(tokens[i]);
      if (!value) return false;
      if (i < out.size()) out[i] = *value;
    }
    if (!check_count(tokens, out.size())) return false;
    check_blanks(tokens, out.size());
    return true;
  }

 private:
  /// A finding on the number, with what readers of another grammar can make of the whole text.
  Diagnostic& report(const Rule& rule, Span at, std::string message) {
    Diagnostic& diagnostic = sink_.report(rule, at, std::move(message));
    // Drake looks for a space before it reads a scale of three numbers.
    const bool is_one = attribute_.name() == "scale" && text_.find(' ') == text_.npos;
    const std::vector<double> read = read_leading_numbers(text_);
    if (read.size() == (is_one ? 1 : wanted_)) diagnostic.when(cases::kEnoughRead);
    constexpr double kLeast = 1e-8;  // of a scale for Drake
    const auto is_nothing = [](double number) { return std::fabs(number) < kLeast; };
    if (std::any_of(read.begin(), read.end(), is_nothing)) diagnostic.when(cases::kReadsZero);
    if (count_between_spaces(text_) >= wanted_) diagnostic.when(cases::kEnoughWords);
    return diagnostic;
  }

  /// Spans into the value are exact as long as no entity was decoded.
  Span place(Token token) const {
    const Span whole = attribute_.value_span();
    if (whole.end - whole.begin != text_.size()) return whole;
    return {whole.source, whole.begin + token.begin, whole.begin + token.end};
  }
  Token whole() const { return {0, static_cast<std::uint32_t>(text_.size())}; }

  bool has_residue() {
    if (is_xacro(text_)) return true;  // the reader of the file has reported it
    if (text_.find('%') != std::string_view::npos) {
      report_percent(place(whole()), text_, sink_);
      return true;
    }
    return false;
  }

  bool is_comma_separated() {
    const std::vector<Token> tokens = split(text_);
    const auto commas = std::count(text_.begin(), text_.end(), ',');
    const bool all_joined = tokens.size() == 1 && commas >= 2;
    const bool trailing =
        tokens.size() > 1 &&
        std::any_of(tokens.begin(), tokens.end(), [&](Token t) { return text_[t.end - 1] == ','; });
    if (!all_joined && !trailing) return false;
    std::string fixed;
    for (const char c : text_) {
      if (c != ',')
        fixed += c;
      else if (all_joined)
        fixed += ' ';
    }
    Diagnostic& diagnostic =
        report(rules::sml1806_comma_separator, place(whole()),
               "commas separate the numbers of `" + std::string(attribute_.name()) + "`");
    diagnostic.help("separate them by single spaces");
    // Not safe: Bullet reads the text as a zero vector.
    diagnostic.fixes.push_back({Applicability::unsafe, {{attribute_.value_span(), fixed}}});
    return true;
  }

  std::optional<double> number(Token token) {
    std::string_view text = text_.substr(token.begin, token.end - token.begin);
    // These blanks are no blanks of XML, and reported as such; programs in C skip them.
    text.remove_prefix(std::min(text.find_first_not_of("\v\f"), text.size()));
    if (const std::optional<double> value = parse_number(text)) {
      if (is_subnormal(*value)) report_subnormal(token, text);
      return value;
    }
    const std::string lower = path::to_lower(text);
    const std::string_view bare = lower.starts_with('-') || lower.starts_with('+')
                                      ? std::string_view(lower).substr(1)
                                      : std::string_view(lower);
    const std::string shown = quoted(text);
    if (bare == "nan" || (bare.starts_with("nan(") && bare.ends_with(')'))) {
      Diagnostic& diagnostic = report(rules::sml1803_number_nan, place(token),
                                      shown + " is not a number that a reader can use");
      add_cases(bare, diagnostic);
    } else if (bare == "inf" || bare == "infinity") {
      Diagnostic& diagnostic = report(rules::sml1804_number_infinite, place(token),
                                      shown + " is infinite, which urdfdom refuses");
      if (lower.starts_with('-')) diagnostic.when(cases::kZeroOrLess);
      add_cases(bare, diagnostic);
    } else if (is_decimal_comma(text)) {
      report_comma(token, text);
    } else if (bare.starts_with("0x") || has_suffix(bare)) {
      Diagnostic& diagnostic = report(rules::sml1809_hex_or_suffix, place(token),
                                      shown + " is not a plain decimal number");
      add_kind_of_hex(text, diagnostic);
      if (miscount_ != nullptr) diagnostic.when(*miscount_);
    } else if (std::any_of(text.begin(), text.end(),
                           [](char c) { return static_cast<unsigned char>(c) >= 0x80; })) {
      report(rules::sml1811_unicode_digit_or_space, place(token),
             shown + " contains the character " + code_point(text) +
                 ", which only looks like part of a number")
          .help("type the number again");
    } else if (is_out_of_range(bare)) {
      report(rules::sml1810_overflow_underflow, place(token),
             shown + " is outside the range of a double")
          .when(is_underflow(text) ? cases::kUnderflow : cases::kOverflow);
    } else {
      report(rules::sml1801_not_a_number, place(token), shown + " is not a number");
    }
    return std::nullopt;
  }

  /// MuJoCo counts the numbers first, and reads only short words in a scale.
  void add_cases(std::string_view word, Diagnostic& diagnostic) const {
    if (miscount_ != nullptr) diagnostic.when(*miscount_);
    if (attribute_.name() == "scale" && word.size() > 3) diagnostic.when(cases::kLongWord);
  }

  void report_subnormal(Token token, std::string_view text) {
    report(rules::sml1810_overflow_underflow, place(token),
           quoted(text) + " is so small that a double keeps only some of its digits")
        .when(cases::kSubnormal);
  }

  /// The first character beyond ASCII, as "U+2212".
  static std::string code_point(std::string_view text) {
    std::size_t at = 0;
    while (static_cast<unsigned char>(text[at]) < 0x80) ++at;
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    std::uint32_t value = first & (0xFFU >> (size + 1));
    for (std::size_t i = 1; i < size && at + i < text.size(); ++i) {
      value = value << 6U | (static_cast<unsigned char>(text[at + i]) & 0x3FU);
    }
    std::string digits;
    for (; value > 0 || digits.size() < 4; value >>= 4U) {
      digits.insert(digits.begin(), "0123456789ABCDEF"[value & 0xFU]);
    }
    return "U+" + digits;
  }

  static bool is_decimal_comma(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos || text.find(',', comma + 1) != std::string_view::npos) {
      return false;
    }
    std::string point(text);
    point[comma] = '.';
    return parse_number(point).has_value();
  }

  void report_comma(Token token, std::string_view text) {
    std::string point(text);
    std::replace(point.begin(), point.end(), ',', '.');
    Diagnostic& diagnostic =
        report(rules::sml1805_decimal_comma, place(token), quoted(text) + " has a decimal comma");
    diagnostic.help("write `" + point + "`");
    // Not safe: Bullet, and Drake in single numbers, read the digits before the comma.
    diagnostic.fixes.push_back({Applicability::unsafe, {{place(token), point}}});
  }

  static void add_kind_of_hex(std::string_view text, Diagnostic& diagnostic) {
    const std::optional<double> value = parse_hexadecimal(text);
    if (!value && path::to_lower(text).find("0x") >= 2) return;  // a suffix
    diagnostic.when(cases::kHex);
    if (!value) diagnostic.when(cases::kBroken);
    if (value && *value <= 0) diagnostic.when(cases::kZeroOrLess);
  }

  /// A number with trailing letters: "1kg", "1.0f", "90deg".
  static bool has_suffix(std::string_view text) {
    std::size_t at = text.size();
    while (at > 0 && !is_digit(text[at - 1]) && text[at - 1] != '.') --at;
    return at > 0 && at < text.size() && parse_number(text.substr(0, at)).has_value();
  }

  /// What the numbers of an attribute are: "x, y and z: ".
  static std::string meant_by(std::string_view attribute) {
    if (attribute == "xyz") return "x, y and z: ";
    if (attribute == "rpy") return "roll, pitch and yaw in radians: ";
    if (attribute == "size") return "the lengths along x, y and z: ";
    if (attribute == "scale") return "a factor for each axis: ";
    if (attribute == "rgba") return "red, green, blue and alpha, each from 0 to 1: ";
    return "";
  }

  bool check_count(const std::vector<Token>& tokens, std::size_t count) {
    if (tokens.empty()) {
      Diagnostic& diagnostic = report(rules::sml1801_not_a_number, attribute_.span(),
                                      quoted(attribute_.name()) + " is empty");
      diagnostic.when(cases::kEmpty);
      if (!attribute_.value().empty()) diagnostic.when(cases::kBlanks);
      return false;
    }
    if (tokens.size() == count) return true;
    const std::string_view name = attribute_.name();
    const bool is_scale = name == "scale";
    const bool is_color = name == "rgba";
    Diagnostic& diagnostic = report(rules::sml1807_vector_count, place(whole()),
                                    quoted(name) + " must have " + counted(count, "number") +
                                        ", not " + std::to_string(tokens.size()));
    diagnostic.when(*miscount_);
    diagnostic.help("write " + meant_by(name) + counted(count, "number"));
    if (is_scale && tokens.size() == 1) {
      // Bullet, Drake and yourdfpy take one number for all three axes.
      const std::string factor(text_.substr(tokens[0].begin, tokens[0].end - tokens[0].begin));
      add_fix(diagnostic, factor + " " + factor + " " + factor, Applicability::safe);
    } else if (is_color && tokens.size() == 3) {
      add_fix(diagnostic,
              std::string(text_.substr(tokens[0].begin, tokens[2].end - tokens[0].begin)) + " 1",
              Applicability::unsafe);
    }
    return false;
  }

  void add_fix(Diagnostic& diagnostic, std::string text, Applicability applicability) const {
    diagnostic.help("write `" + text + "`");
    diagnostic.fixes.push_back({applicability, {{attribute_.value_span(), std::move(text)}}});
  }

  /// Whether a space or the end of the text follows each number. Readers that split at spaces then
  /// find tabs and line breaks only in front of numbers, where they skip them.
  bool are_blanks_leading(const std::vector<Token>& tokens) const {
    return std::all_of(tokens.begin(), tokens.end(), [&](Token token) {
      return token.end == text_.size() || text_[token.end] == ' ';
    });
  }

  void check_blanks(const std::vector<Token>& tokens, std::size_t count) {
    const auto is_line_or_tab = [](char c) { return c == '\t' || c == '\n' || c == '\r'; };
    std::string fixed;
    for (const Token token : tokens) {
      if (!fixed.empty()) fixed += ' ';
      fixed += text_.substr(token.begin, token.end - token.begin);
    }
    if (count == 1) {
      if (tokens.back().end == text_.size()) return;  // readers skip blanks in front
      Diagnostic& diagnostic = report(rules::sml1802_number_whitespace, place(whole()),
                                      "white space follows the number `" + fixed + "`");
      diagnostic.help("delete the white space");
      diagnostic.fixes.push_back({Applicability::safe, {{attribute_.value_span(), fixed}}});
    } else if (std::any_of(text_.begin(), text_.end(), is_line_or_tab)) {
      Diagnostic& diagnostic = report(rules::sml1802_number_whitespace, place(whole()),
                                      "a tab or line break between the numbers of `" +
                                          std::string(attribute_.name()) + "`");
      diagnostic.help("separate them by single spaces");
      if (are_blanks_leading(tokens)) diagnostic.when(cases::kLeading);
      diagnostic.fixes.push_back({Applicability::unsafe, {{attribute_.value_span(), fixed}}});
    }
  }

  const xml::Attribute& attribute_;
  std::string_view text_;
  DiagnosticSink& sink_;
  std::size_t wanted_ = 0;                  ///< how many numbers are expected
  const Circumstance* miscount_ = nullptr;  ///< too many or too few words
};

}  // namespace

bool is_xacro(std::string_view value) {
  for (std::size_t at = value.find('$'); at != std::string_view::npos;
       at = value.find('$', at + 1)) {
    if (at + 1 < value.size() && (value[at + 1] == '{' || value[at + 1] == '(')) return true;
  }
  return false;
}

void report_percent(Span place, std::string_view value, DiagnosticSink& sink) {
  Diagnostic& diagnostic =
      sink.report(rules::sml1012_percent_in_value, place, quoted(value) + " contains `%`");
  diagnostic.note("urdfdom up to 5.0 passes this text to printf, which may crash");
  diagnostic.when(kUncertain);  // for the elements where a run may end or not
}

std::optional<double> parse_hexadecimal(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  if (!text.starts_with("0x") && !text.starts_with("0X")) return std::nullopt;
  text.remove_prefix(2);
  double value = 0;
  const auto read = read_hexadecimal(text, value);
  const bool is_whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  if (!is_whole || text.starts_with('-') || !std::isfinite(value)) return std::nullopt;
  return is_negative ? -value : value;
}

bool has_blank_behind(std::string_view text, bool is_vector) {
  for (std::size_t at = 1; at < text.size(); ++at) {
    const bool separates = is_vector && text[at] == ' ';
    if (is_blank(text[at]) && !separates && !is_blank(text[at - 1])) return true;
  }
  return false;
}

bool is_underflow(std::string_view text) {
  const std::string lower = path::to_lower(text);
  return !parse_number(text) && is_out_of_range(lower) && lower.find("e-") != std::string::npos;
}

bool read_numbers(const xml::Attribute& attribute, std::span<double> out, DiagnosticSink& sink) {
  return read_plain(attribute.value(), out) || NumberReader(attribute, sink).read(out);
}

}  // namespace smurf
