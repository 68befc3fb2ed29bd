// SPDX-License-Identifier: BSD-3-Clause
// Sources: configmaps ConfigAtom.hpp:335-386; PyYAML resolver.py. Both were run.
#include "ast/notation.hpp"

#include <algorithm>

#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

std::string_view without_sign(std::string_view text) {
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) text.remove_prefix(1);
  return text;
}

std::string_view leading_digits(std::string_view text) {
  const auto* const end = std::find_if_not(text.begin(), text.end(), is_digit);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

/// 12:30, and 20150617_17:34 as in Phobos' dates.
bool is_sexagesimal(std::string_view text) {
  text = without_sign(text);
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || text.front() < '1' || text.front() > '9') return false;
  const auto is_part = [](char c) { return is_digit(c) || c == '_'; };
  if (!std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(colon), is_part)) {
    return false;
  }
  std::string_view rest = text.substr(colon);
  while (rest.starts_with(':')) {
    const std::string_view part = leading_digits(rest.substr(1));
    if (part.empty() || part.size() > 2 || (part.size() == 2 && part.front() > '5')) return false;
    rest.remove_prefix(1 + part.size());
  }
  return rest.empty();
}

/// 2015-06-17.
bool is_date(std::string_view text) {
  constexpr std::string_view kPattern = "0000-00-00";
  return text.size() == kPattern.size() &&
         std::equal(text.begin(), text.end(), kPattern.begin(),
                    [](char c, char p) { return p == '0' ? is_digit(c) : c == p; });
}

/// Words that are booleans in YAML 1.1 only.
bool is_boolean(std::string_view text) {
  constexpr std::string_view kWords[] = {"yes", "Yes", "YES", "no",  "No",  "NO",
                                         "on",  "On",  "ON",  "off", "Off", "OFF"};
  return std::find(std::begin(kWords), std::end(kWords), text) != std::end(kWords);
}

std::string octal_value(std::string_view digits) {
  double value = 0;
  for (const char c : digits) value = value * 8 + (c - '0');
  return format_number(value);
}

}  // namespace

/// PyYAML reads a float only with a point, and an exponent only with a sign. A signed number
/// without a digit before the point is a text.
std::optional<std::string> number_by_yaml11(std::string_view text) {
  const std::string_view digits = without_sign(text);
  if (digits.starts_with("0x")) return std::nullopt;
  if (digits.starts_with("0o")) return "a text";
  bool has_point = false;
  for (std::size_t at = 0; at < digits.size(); ++at) {
    has_point = has_point || digits[at] == '.';
    if (digits[at] != 'e' && digits[at] != 'E') continue;
    const char sign = digits[at + 1];
    if (!has_point || (sign != '+' && sign != '-')) return "a text";
  }
  const bool is_signed = digits.size() != text.size();
  if (is_signed && digits.front() == '.' && is_digit(digits[1])) return "a text";  // not -.inf
  if (has_point || digits.size() == 1 || digits.front() != '0') return std::nullopt;
  const bool is_octal =
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '7'; });
  if (!is_octal) return "a text";
  const std::string value = octal_value(digits);
  if (value == "0") return std::nullopt;
  return (text.front() == '-' ? "-" : "") + value;
}

std::optional<std::string> text_by_yaml11(std::string_view text) {
  // All special values begin with one of these.
  constexpr std::string_view kStarts = "yYnNoO+-0123456789";
  if (text.empty() || kStarts.find(text.front()) == std::string_view::npos) return std::nullopt;
  if (is_boolean(text)) return "a boolean";
  if (is_sexagesimal(text)) return "a number to the base 60";
  if (is_date(text)) return "a date";
  return std::nullopt;
}

bool is_json(const yaml::Document& document) {
  const yaml::View root = document.view();
  if (!root || !root.is_mapping() || root.size() == 0) return false;
  const yaml::View first = *root.begin();
  return first.key_span().end - first.key_span().begin == first.key().size() + 2;
}

bool is_in_all_notations(std::string_view number, bool is_whole) {
  if (number.starts_with('-')) number.remove_prefix(1);
  if (number.empty() || !is_digit(number.front())) return false;
  const bool is_octal = number.front() == '0' && number.size() > 1 && number[1] != '.';
  return !is_octal && std::all_of(number.begin(), number.end(),
                                  [&](char c) { return is_digit(c) || (c == '.' && !is_whole); });
}

std::optional<std::string> read_by_scanf(std::string_view number, bool is_whole) {
  const std::string_view digits = without_sign(number);
  if (digits.starts_with("0o")) return "0";
  if (!is_whole) return std::nullopt;
  const std::string_view whole = leading_digits(digits);
  const std::string_view rest = digits.substr(whole.size());
  if (rest.find_first_not_of(".0") == std::string_view::npos && !whole.empty()) {
    return std::nullopt;
  }
  if (whole.empty()) return "undefined memory";
  const double read = parse_number(whole).value_or(0);
  return format_number(number.front() == '-' ? -read : read);
}

std::string in_all_notations(double number) {
  std::string text = format_number(number);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  if (text[exponent + 1] != '-' && text[exponent + 1] != '+') text.insert(exponent + 1, "+");
  if (text.find('.') == std::string::npos) text.insert(exponent, ".0");
  return text;
}

}  // namespace smurf
