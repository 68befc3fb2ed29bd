// SPDX-License-Identifier: BSD-3-Clause
// Uses strtod and snprintf, which round correctly in all current C libraries. They depend on the
// locale of the process. WebAssembly, for which this file exists, has only one locale.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "base/files/path.hpp"
#include "base/numbers/floating.hpp"
#include "base/text/words.hpp"

namespace smurf::portable {
namespace {

bool is_hexadecimal_digit(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

std::size_t skip(std::string_view text, std::size_t at, bool (*is_wanted)(char)) {
  while (at < text.size() && is_wanted(text[at])) ++at;
  return at;
}

/// Length of "inf", "infinity" and "nan", in any case, at the beginning of the text.
std::size_t length_of_word(std::string_view text) {
  const std::string word = path::to_lower(text.substr(0, 8));
  if (word == "infinity") return 8;
  return word.starts_with("inf") || word.starts_with("nan") ? 3 : 0;
}

/// Length of the number at the beginning of the text, without a sign; 0 when there is none.
std::size_t length_of_number(std::string_view text, bool (*is_wanted)(char),
                             std::string_view exponents) {
  std::size_t at = skip(text, 0, is_wanted);
  std::size_t digits = at;
  if (at < text.size() && text[at] == '.') {
    const std::size_t end = skip(text, at + 1, is_wanted);
    digits += end - at - 1;
    at = end;
  }
  if (digits == 0) return 0;
  if (at == text.size() || exponents.find(text[at]) == std::string_view::npos) return at;
  std::size_t exponent = at + 1;
  if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
  const std::size_t end = skip(text, exponent, is_digit);
  return end == exponent ? at : end;
}

/// Whether all digits of `text` before the exponent are 0.
bool is_written_as_zero(std::string_view text, std::string_view exponents) {
  return text.substr(0, text.find_first_of(exponents)).find_first_not_of("-.0") ==
         std::string_view::npos;
}

std::from_chars_result read(std::string_view text, bool is_hexadecimal, double& value) {
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  const std::string_view unsigned_text = text.substr(sign);
  const std::string_view exponents = is_hexadecimal ? "pP" : "eE";
  std::size_t length = length_of_word(unsigned_text);
  const bool is_word = length > 0;
  if (!is_word) {
    length = length_of_number(unsigned_text, is_hexadecimal ? is_hexadecimal_digit : is_digit,
                              exponents);
  }
  if (length == 0) return {text.data(), std::errc::invalid_argument};
  const std::string_view number = unsigned_text.substr(0, length);
  const std::string prefix = is_hexadecimal && !is_word ? "0x" : "";
  const double read = std::strtod((prefix + std::string(number)).c_str(), nullptr);
  const char* const end = number.data() + length;
  const bool is_lost =
      read == 0 ? !is_written_as_zero(number, exponents) : std::isinf(read) && !is_word;
  if (is_lost) return {end, std::errc::result_out_of_range};
  value = sign == 1 ? -read : read;
  return {end, std::errc()};
}

/// "d.ddde+dd", without trailing zeros of the fraction; at most 17 digits.
struct Decimal {
  std::string digits;
  int exponent = 0;  ///< of the first digit
};

Decimal rounded(double magnitude, int count) {
  std::array<char, 40> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.*e", count - 1, magnitude);
  const std::string_view text = buffer.data();
  const std::size_t e = text.find('e');
  Decimal decimal;
  for (const char c : text.substr(0, e)) {
    if (is_digit(c)) decimal.digits += c;
  }
  decimal.exponent = std::atoi(text.data() + e + 1);
  return decimal;
}

/// The digits as a whole number, and a power of ten.
std::string readable(const Decimal& decimal) {
  return decimal.digits + "e" +
         std::to_string(decimal.exponent - static_cast<int>(decimal.digits.size()) + 1);
}

void read_back(const std::string& text, double& value) {
  value = std::strtod(text.c_str(), nullptr);
}
void read_back(const std::string& text, float& value) {
  value = std::strtof(text.c_str(), nullptr);
}

template <class Float>
bool reads_back(const Decimal& decimal, Float magnitude) {
  Float again = 0;
  read_back(readable(decimal), again);
  return again == magnitude;
}

/// Numbers above a power of two are farther apart than those below it, so a text that is not the
/// nearest may still read back as this number.
template <class Float>
bool step_to_neighbour(Decimal& decimal, Float magnitude) {
  for (const int step : {1, -1}) {
    Decimal other = decimal;
    const long long digits = std::atoll(decimal.digits.c_str()) + step;
    other.digits = std::to_string(digits);
    if (digits <= 0 || other.digits.size() != decimal.digits.size()) continue;
    if (!reads_back(other, magnitude)) continue;
    decimal = other;
    return true;
  }
  return false;
}

/// A text of `digits10` digits survives the conversion to a number and back, so rounding to that
/// many digits finds a shorter text, except for the smallest numbers.
template <class Float>
Decimal shortest_decimal(Float magnitude) {
  using Limits = std::numeric_limits<Float>;
  const bool is_normal = magnitude >= Limits::min();
  Decimal decimal;
  for (int count = is_normal ? Limits::digits10 : 1; count <= Limits::max_digits10; ++count) {
    decimal = rounded(static_cast<double>(magnitude), count);
    if (reads_back(decimal, magnitude) || step_to_neighbour(decimal, magnitude)) break;
  }
  const std::size_t last = decimal.digits.find_last_not_of('0');
  decimal.digits.resize(last == std::string::npos ? 1 : last + 1);
  return decimal;
}

std::string scientific(const Decimal& decimal) {
  std::string text = decimal.digits.substr(0, 1);
  if (decimal.digits.size() > 1) text += "." + decimal.digits.substr(1);
  const std::string exponent = std::to_string(std::abs(decimal.exponent));
  return text + (decimal.exponent < 0 ? "e-" : "e+") + (exponent.size() < 2 ? "0" : "") + exponent;
}

std::string fixed(const Decimal& decimal, double magnitude) {
  const int before = decimal.exponent + 1;  // digits before the point
  const auto size = static_cast<int>(decimal.digits.size());
  if (before <= 0)
    return "0." + std::string(static_cast<std::size_t>(-before), '0') + decimal.digits;
  if (before < size) {
    const auto point = static_cast<std::size_t>(before);
    return decimal.digits.substr(0, point) + "." + decimal.digits.substr(point);
  }
  // All digits before the point are exact, even if fewer would be enough.
  std::array<char, 512> buffer;
  const int written = std::snprintf(buffer.data(), buffer.size(), "%.0f", magnitude);
  return {buffer.data(), static_cast<std::size_t>(written)};
}

template <class Float>
std::string write(Float value, Notation notation) {
  const Float magnitude = std::fabs(value);
  const std::string sign = std::signbit(value) ? "-" : "";
  const Decimal decimal = magnitude == 0 ? Decimal{"0", 0} : shortest_decimal(magnitude);
  if (notation == Notation::scientific) return sign + scientific(decimal);
  std::string text = fixed(decimal, static_cast<double>(magnitude));
  if (notation == Notation::shorter) {
    const std::string other = scientific(decimal);
    if (other.size() < text.size()) text = other;
  }
  return sign + text;
}

}  // namespace

std::from_chars_result read_floating(std::string_view text, double& value) {
  return read(text, false, value);
}

std::from_chars_result read_hexadecimal(std::string_view text, double& value) {
  return read(text, true, value);
}

std::string shortest(double value, Notation notation) { return write(value, notation); }

std::string shortest(float value) { return write(value, Notation::shorter); }

std::string general(double value, int digits) {
  std::array<char, 512> buffer;
  const int size = std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return {buffer.data(), static_cast<std::size_t>(size)};
}

}  // namespace smurf::portable
