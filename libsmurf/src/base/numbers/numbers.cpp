// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/numbers/floating.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

/// Length of the longest prefix of the decimal grammar, 0 when there is none.
std::size_t decimal_prefix(std::string_view text) {
  std::size_t at = 0;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
  std::size_t digits = 0;
  while (at < text.size() && is_digit(text[at])) ++at, ++digits;
  if (at < text.size() && text[at] == '.') {
    ++at;
    while (at < text.size() && is_digit(text[at])) ++at, ++digits;
  }
  if (digits == 0) return 0;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t exponent = at + 1;
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
    if (exponent < text.size() && is_digit(text[exponent])) {
      at = exponent;
      while (at < text.size() && is_digit(text[at])) ++at;
    }
  }
  return at;
}

/// A number of few digits without an exponent, as nearly all are: its digits and the power of ten
/// are exact in a double, so their quotient is the nearest double.
std::optional<double> parse_short(std::string_view text) {
  constexpr std::array<double, 16> kPowersOfTen = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                   1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.size() >= kPowersOfTen.size()) return std::nullopt;
  std::uint64_t digits = 0;
  std::size_t at = 0;
  const auto read_digits = [&] {
    for (; at < text.size() && is_digit(text[at]); ++at) {
      digits = 10 * digits + static_cast<std::uint64_t>(text[at] - '0');
    }
  };
  read_digits();
  std::size_t count = at;
  std::size_t decimals = 0;
  if (at < text.size() && text[at] == '.') {
    const std::size_t point = at++;
    read_digits();
    decimals = at - point - 1;
    count += decimals;
  }
  if (at != text.size() || count == 0) return std::nullopt;
  auto value = static_cast<double>(digits);
  if (decimals > 0) value /= kPowersOfTen[decimals];
  return is_negative ? -value : value;
}

/// Reads a number like `>>` of a C++ stream, which stops at the first character that cannot be part
/// of one, does not read "nan" and "inf", and reads 0 for what is too small.
bool read_number(std::string_view& text, double& value) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\v\f"), text.size()));
  std::string_view digits = text;
  const bool has_plus = digits.starts_with('+');
  if (has_plus) digits.remove_prefix(1);
  const std::size_t first = !has_plus && digits.starts_with('-') ? 1 : 0;
  const char c = first < digits.size() ? digits[first] : '\0';
  if (c != '.' && (c < '0' || c > '9')) return false;
  const auto [end, error] = read_floating(digits, value);
  const std::string_view read = digits.substr(0, static_cast<std::size_t>(end - digits.data()));
  const std::size_t exponent = std::min(read.find_first_of("eE"), read.size());
  const bool is_too_small = error == std::errc::result_out_of_range &&
                            read.substr(exponent).find('-') != std::string_view::npos;
  if (is_too_small) value = 0;
  if (error != std::errc() && !is_too_small) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return !text.starts_with('e') && !text.starts_with('E');
}

}  // namespace

std::vector<double> read_leading_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (double value = 0; read_number(text, value);) numbers.push_back(value);
  return numbers;
}

std::optional<double> parse_number(std::string_view text) {
  if (const std::optional<double> value = parse_short(text)) return value;
  if (text.empty() || decimal_prefix(text) != text.size()) return std::nullopt;
  if (text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = read_floating(text, value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string format_number(double value) {
  if (value == 0) return "0";  // also -0
  const double magnitude = std::fabs(value);
  const bool is_fixed = magnitude >= 1e-5 && magnitude < 1e15;
  return shortest(value, is_fixed ? Notation::fixed : Notation::scientific);
}

std::string format_rounded(double value, int digits) {
  const std::string text = general(value, digits);
  constexpr double kReadable = 1e7;  // "2100 times" instead of "2.1e+03 times"
  if (std::abs(value) >= kReadable || text.find("e+") == std::string::npos) return text;
  return format_number(parse_number(text).value_or(value));
}

}  // namespace smurf
