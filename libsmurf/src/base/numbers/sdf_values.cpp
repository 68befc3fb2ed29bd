// SPDX-License-Identifier: BSD-3-Clause
// Sources: sdformat 12.3.0 src/Param.cc:380-780.
#include "base/numbers/sdf_values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <system_error>

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

/// Of a number that is out of range: "1e-999".
bool is_tiny(std::string_view word) {
  const std::size_t exponent = word.find_first_of("eE");
  return exponent != std::string_view::npos && word.substr(exponent + 1).starts_with('-');
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
  if (error == std::errc::result_out_of_range && !is_tiny(word)) return std::nullopt;
  text.remove_prefix(word.size());
  // The stream takes the letter, and then misses the exponent.
  if (text.starts_with('e') || text.starts_with('E')) return std::nullopt;
  return is_negative ? -value : value;
}

template <class Number>
std::optional<double> leading(std::string_view text) {
  const std::optional<double> value = leading_number(text);
  return value && is_in_range<Number>(*value) ? value : std::nullopt;
}

/// The number at the beginning of each word, by a function; none if a word has none, or if there
/// are more words than that.
template <class F>
std::optional<std::vector<double>> by_words(std::string_view text, std::size_t most,
                                            const F& read) {
  std::vector<double> numbers;
  std::size_t at = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    const std::optional<double> one = read(word);
    if (!one || numbers.size() == most) return std::nullopt;
    numbers.push_back(*one);
  }
  return numbers;
}

}  // namespace

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

std::vector<double> streamed_numbers(std::string_view text, std::size_t most) {
  std::vector<double> numbers;
  while (numbers.size() < most) {
    const std::optional<double> number = next_number(text);
    if (!number) break;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<std::array<double, 3>> read_vector(std::string_view text) {
  const std::vector<double> numbers = streamed_numbers(text, 3);
  if (numbers.size() < 3) return std::nullopt;
  return std::array<double, 3>{numbers[0], numbers[1], numbers[2]};
}

std::optional<bool> read_flag(std::string_view text) {
  const std::string lower = path::to_lower(text);
  if (is_one_of(lower, {"true", "1"})) return true;
  if (is_one_of(lower, {"false", "0"})) return false;
  return std::nullopt;
}

std::optional<std::vector<double>> read_color(std::string_view text) {
  auto numbers = by_words(text, 4, [](std::string_view word) {
    const std::optional<double> part = leading<float>(word);
    return part && (*part < 0 || *part > 1) ? std::nullopt : part;
  });
  return numbers && numbers->size() >= 3 ? numbers : std::nullopt;
}

std::optional<std::vector<double>> read_pose(std::string_view text, bool is_quaternion) {
  const std::size_t wanted = is_quaternion ? 7 : 6;
  auto numbers = by_words(text, wanted, [](std::string_view word) {
    const std::optional<double> part = leading_number(word);
    return part && !std::isfinite(*part) ? std::nullopt : part;
  });
  return numbers && numbers->size() == wanted ? numbers : std::nullopt;
}

std::optional<double> read_scalar(char type, std::string_view text) {
  const std::string lower = path::to_lower(text);
  if (lower == "true") return 1;
  if (lower == "false") return 0;
  if (type == 'd') return leading_number(text);
  if (type == 'f') return leading<float>(text);
  const auto whole = leading_integer(text, lower.starts_with("0x") ? 16 : 10);
  if (!whole) return std::nullopt;
  const bool is_int =
      *whole >= std::numeric_limits<int>::min() && *whole <= std::numeric_limits<int>::max();
  if (type == 'i' && !is_int) return std::nullopt;
  return static_cast<double>(*whole);
}

bool is_within(double value, std::string_view range) {
  if (range.empty()) return true;
  const std::size_t comma = range.find(',');
  const auto least = leading_number(range.substr(0, comma));
  const auto most = leading_number(range.substr(comma + 1));
  return !(least && value < *least) && !(most && value > *most);
}

}  // namespace smurf::sdf
