// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/reading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/numbers/floating.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"

namespace smurf::mjcf {
namespace {

constexpr std::string_view kSeparators = " \t\r\n\v\f";

std::vector<std::string_view> words_in(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = text.find_first_not_of(kSeparators);
    if (begin == std::string_view::npos) return words;
    text.remove_prefix(begin);
    const std::size_t end = std::min(text.find_first_of(kSeparators), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

/// As strtod(): with a sign, in base 16, "inf" and "nan".
std::optional<double> number_in(std::string_view word) {
  const bool is_negative = word.starts_with('-');
  if (is_negative || word.starts_with('+')) word.remove_prefix(1);
  if (word.empty() || word.front() == '-' || word.front() == '+') return std::nullopt;
  const double sign = is_negative ? -1 : 1;
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (lower == "inf" || lower == "infinity") return sign * std::numeric_limits<double>::infinity();
  if (lower == "nan") return std::numeric_limits<double>::quiet_NaN();
  double value = 0;
  const bool is_hexadecimal = lower.starts_with("0x");
  const std::string_view digits = is_hexadecimal ? std::string_view(lower).substr(2) : word;
  const auto result =
      is_hexadecimal ? read_hexadecimal(digits, value) : read_floating(digits, value);
  const bool is_whole = result.ptr == digits.data() + digits.size();
  if (!is_whole || result.ec == std::errc::invalid_argument) return std::nullopt;
  if (result.ec != std::errc::result_out_of_range) return sign * value;
  // "1e-999" is 0, and "1e999" is refused.
  const std::size_t exponent = lower.find(is_hexadecimal ? 'p' : 'e');
  const bool is_tiny = exponent != std::string::npos && lower.substr(exponent + 1).starts_with('-');
  return is_tiny ? std::optional(0.0) : std::nullopt;
}

}  // namespace

std::vector<double> numbers_of(const Attribute& attribute, std::size_t least, std::size_t most,
                               Reporter& reporter) {
  std::vector<double> numbers;
  for (const std::string_view word : words_in(attribute.value())) {
    auto number = number_in(word);
    // MuJoCo has single precision for colours.
    const bool is_colour = attribute.name().find("rgb") != std::string_view::npos;
    if (number && is_colour && std::isfinite(*number) &&
        std::fabs(*number) > std::numeric_limits<float>::max())
      number.reset();
    if (!number) {
      reporter.refuse(attribute.value_span(),
                      quoted(word) + " in " + quoted(attribute.name()) + " is not a number",
                      "write a number such as `0.5`");
      return numbers;
    }
    if (numbers.size() == most) {
      reporter.refuse(attribute.value_span(),
                      quoted(attribute.name()) + " has more than " + std::to_string(most) +
                          (most == 1 ? " number" : " numbers"),
                      "delete the others");
      return numbers;
    }
    numbers.push_back(*number);
  }
  if (numbers.empty()) return numbers;  // as if it were not written
  if (numbers.size() < least) {
    reporter.refuse(attribute.value_span(),
                    quoted(attribute.name()) + " has " + std::to_string(numbers.size()) + " of " +
                        std::to_string(least) + " numbers",
                    "write all of them");
  }
  return numbers;
}

void integers_of(const Attribute& attribute, std::size_t least, std::size_t most,
                 Reporter& reporter) {
  for (const std::string_view word : words_in(attribute.value())) {
    std::string_view digits = word;
    if (digits.starts_with('-') || digits.starts_with('+')) digits.remove_prefix(1);
    const bool is_integer =
        !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
    if (is_integer && std::fabs(number_in(word).value_or(0)) <= kLargestInteger) continue;
    reporter.refuse(attribute.value_span(),
                    quoted(word) + " in " + quoted(attribute.name()) + " is " +
                        (is_integer ? "too large" : "not an integer"),
                    is_integer ? "write a smaller number" : "write an integer such as `1`");
    return;
  }
  numbers_of(attribute, least, most, reporter);
}

std::optional<std::size_t> word_of(const Attribute& attribute,
                                   std::span<const std::string_view> words, Reporter& reporter) {
  const auto found = std::find(words.begin(), words.end(), attribute.value());
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string known;
  for (const std::string_view word : words)
    known += (known.empty() ? "`" : ", `") + std::string(word) + "`";
  reporter.refuse(attribute.value_span(),
                  quoted(attribute.value()) + " is no value of " + quoted(attribute.name()),
                  "write one of " + known);
  return std::nullopt;
}

std::optional<bool> truth_of(const Attribute& attribute, Reporter& reporter) {
  constexpr std::string_view kWords[] = {"false", "true"};
  const auto word = word_of(attribute, kWords, reporter);
  return word ? std::optional(*word == 1) : std::nullopt;
}

Auto auto_of(const Attribute& attribute, Reporter& reporter) {
  constexpr std::string_view kWords[] = {"false", "true", "auto"};
  return static_cast<Auto>(word_of(attribute, kWords, reporter).value_or(2));
}

}  // namespace smurf::mjcf
