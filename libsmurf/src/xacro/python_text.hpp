// SPDX-License-Identifier: BSD-3-Clause
// Numbers as Python reads and prints them, and its texts in quotes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace smurf::xacro {

class Heap;
struct Value;

/// Decimal digits and the exponent of 10 of the first digit: 1.5 is "15", 0.
struct Decimal {
  bool is_negative = false;
  std::string digits;
  int exponent = 0;
};
/// The shortest digits that read back. Precondition: finite.
Decimal shortest_decimal(double value);
/// This number of digits, correctly rounded, without zeros at the end. Precondition: finite.
Decimal rounded_decimal(double value, int digits);
/// This number of digits behind the point. Precondition: finite.
std::string fixed_text(double value, int decimals);
/// The nearest number with this number of digits behind the point, as round() of Python.
double rounded(double value, int decimals);

/// As repr(): "0.1", "1e-05", "1e+16", "-0.0", "inf", "nan".
std::string float_text(double value);
/// As repr() of a text: with single quotes and escapes.
std::string quoted_text(std::string_view text);

/// The most digits of an integer in a text; xacro has no such limit.
constexpr std::size_t kMostIntegerDigits = 1300;
/// As int(): blanks around it, digits of any script, underscores; none if it is no integer, or has
/// more digits.
std::optional<Value> read_integer(std::string_view text, Heap& heap, unsigned base = 10);
/// As float().
std::optional<double> read_float(std::string_view text);
/// Without blanks in the sense of Python's str.strip().
std::string_view without_blanks(std::string_view text);
bool is_python_blank(char32_t code_point);
/// 0 to 9; negative if it is no decimal digit.
int decimal_digit(char32_t code_point);

}  // namespace smurf::xacro
