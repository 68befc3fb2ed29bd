// SPDX-License-Identifier: BSD-3-Clause
// Sources: sdformat 12.3.0 src/Param.cc:380-780.
#include "readers/sdf_values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "ast/urdf_numbers.hpp"
#include "base/files/path.hpp"
#include "base/numbers/floating.hpp"
#include "base/text/words.hpp"

namespace smurf::sdf {
namespace {

constexpr std::string_view kSpace = " \t\r\n\v\f";

void skip_space(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
}

bool take_sign(std::string_view& text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  return is_negative;
}

/// strtod() sets ERANGE for numbers with fewer digits than the type has.
template <class Number>
bool is_in_range(double value) {
  const double size = std::fabs(value);
  if (size == 0 || !std::isfinite(value)) return true;
  return size >= static_cast<double>(std::numeric_limits<Number>::min()) &&
         size <= static_cast<double>(std::numeric_limits<Number>::max());
}

/// As a number read from a stream; `text` then begins behind it.
std::optional<double> next_number(std::string_view& text) {
  skip_space(text);
  const bool is_negative = take_sign(text);
  if (text.empty() || !(is_digit(text.front()) || text.front() == '.')) return std::nullopt;
  double value = 0;
  const auto [end, error] = read_floating(text, value);
  const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.data()));
  if (error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range && !is_underflow(word)) return std::nullopt;
  text.remove_prefix(word.size());
  // The stream takes the letter, and then misses the exponent.
  if (text.starts_with('e') || text.starts_with('E')) return std::nullopt;
  return is_negative ? -value : value;
}

bool is_vector(std::string_view text, int size) {
  for (int i = 0; i < size; ++i) {
    if (!next_number(text)) return false;
  }
  return true;
}

template <class Number>
std::optional<double> leading(std::string_view text) {
  const std::optional<double> value = leading_number(text);
  return value && is_in_range<Number>(*value) ? value : std::nullopt;
}

bool is_color(std::string_view text) {
  std::size_t at = 0, count = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    const std::optional<double> part = leading<float>(word);
    if (!part || *part < 0 || *part > 1) return false;
    ++count;
  }
  return count == 3 || count == 4;
}

bool is_flag(std::string_view text) {
  const std::string lower = path::to_lower(text);
  return is_one_of(lower, {"true", "false", "0", "1"});
}

bool is_set(std::string_view flag) {
  const std::string lower = path::to_lower(flag);
  return lower == "true" || lower == "1";
}

std::string_view attribute_of(xml::View element, std::string_view name) {
  const xml::Attribute* attribute = element.attribute(name);
  return attribute == nullptr ? std::string_view() : trimmed_text(attribute->value());
}

bool is_pose(std::string_view text, xml::View element) {
  const std::string_view format = attribute_of(element, "rotation_format");
  const bool is_quaternion = format == "quat_xyzw";
  if (!is_quaternion && !format.empty() && format != "euler_rpy") return false;
  if (is_quaternion && is_set(attribute_of(element, "degrees"))) return false;
  if (text.empty()) return true;
  std::size_t at = 0, count = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    const std::optional<double> number = leading_number(word);
    if (!number || !std::isfinite(*number)) return false;
    ++count;
  }
  return count == (is_quaternion ? 7 : 6);
}

bool is_within(double value, std::string_view range) {
  if (range.empty()) return true;
  const std::size_t comma = range.find(',');
  const auto least = leading_number(range.substr(0, comma));
  const auto most = leading_number(range.substr(comma + 1));
  return !(least && value < *least) && !(most && value > *most);
}

std::optional<double> read_scalar(char value, std::string_view text) {
  const std::string lower = path::to_lower(text);
  if (lower == "true") return 1;  // for numbers, too
  if (lower == "false") return 0;
  if (value == 'd') return leading_number(text);
  if (value == 'f') return leading<float>(text);
  const auto whole = leading_integer(text, lower.starts_with("0x") ? 16 : 10);
  if (!whole) return std::nullopt;
  const bool is_int =
      *whole >= std::numeric_limits<int>::min() && *whole <= std::numeric_limits<int>::max();
  if (value == 'i' && !is_int) return std::nullopt;
  return static_cast<double>(*whole);
}

}  // namespace

std::string_view given_value(xml::View element) {
  const xml::Attribute* value = element.attribute("value");
  return value != nullptr ? value->value() : element.text();
}

std::string_view trimmed_text(std::string_view text) {
  constexpr std::string_view kTrimmed = " \t\n";
  const std::size_t begin = text.find_first_not_of(kTrimmed);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kTrimmed) - begin + 1);
}

std::optional<double> leading_number(std::string_view text) {
  skip_space(text);
  const bool is_negative = take_sign(text);
  if (text.starts_with('-') || text.starts_with('+')) return std::nullopt;
  double value = 0;
  const std::string head = path::to_lower(text.substr(0, 3));
  const bool is_hexadecimal =
      head.starts_with("0x") && read_hexadecimal(text.substr(2), value).ec == std::errc();
  if (!is_hexadecimal && read_floating(text, value).ec != std::errc()) return std::nullopt;
  if (!is_in_range<double>(value)) return std::nullopt;
  return is_negative ? -value : value;
}

std::optional<long long> leading_integer(std::string_view text, int base) {
  skip_space(text);
  const bool is_negative = take_sign(text);
  if (base == 16 && path::to_lower(text.substr(0, 2)) == "0x") text.remove_prefix(2);
  if (text.starts_with('-')) return std::nullopt;
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc()) return std::nullopt;
  return is_negative ? -value : value;
}

std::optional<std::array<double, 3>> read_vector(std::string_view text) {
  std::array<double, 3> vector{};
  for (double& part : vector) {
    const std::optional<double> number = next_number(text);
    if (!number) return std::nullopt;
    part = *number;
  }
  return vector;
}

bool is_readable(const Part& part, std::string_view text, xml::View element) {
  text = trimmed_text(text);
  if (part.value == 'p') return is_pose(text, element);
  if (text.empty()) return !part.is_required;
  switch (part.value) {
  case 'b': return is_flag(text);
  case 'c': return is_color(text);
  case '2': return is_vector(text, 2);
  case '3': return is_vector(text, 3);
  case 's': return true;
  default: break;
  }
  const std::optional<double> number = read_scalar(part.value, text);
  return number && is_within(*number, part.range);
}

std::string_view wanted(const Part& part) {
  switch (part.value) {
  case 'p': return "six numbers: x y z in m, roll pitch yaw in rad";
  case 'b': return "`true` or `false`";
  case 'c': return "four numbers from 0 to 1: red green blue alpha";
  case '2': return "two numbers";
  case '3': return "three numbers";
  case 's': return "a text";
  case 'i': return "an integer";
  case 'u': return "an integer of at least 0";
  default: return part.range.empty() ? "a number" : "a number in the range that SDF allows";
  }
}

}  // namespace smurf::sdf
