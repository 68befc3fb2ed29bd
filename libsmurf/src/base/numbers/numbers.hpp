// SPDX-License-Identifier: BSD-3-Clause
// Reads and prints numbers, independent of the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace smurf {

/// Decimal grammar [+-]?(digits[.digits]|.digits)([eE][+-]?digits)? for the whole text; spaces,
/// hex, inf, nan and numbers out of range are not accepted.
std::optional<double> parse_number(std::string_view text);
std::optional<std::int64_t> parse_integer(std::string_view text);

/// The numbers at the beginning of a text that `stream >> number` of C++ reads, before any other
/// word, even "nan" and "inf".
std::vector<double> read_leading_numbers(std::string_view text);

/// The shortest text that reads back as the same double. "-0" becomes "0"; 1e-5 <= |v| < 1e15 is
/// written without exponent. Precondition: finite.
std::string format_number(double value);

/// For messages: at most `digits` significant digits, no trailing zeros.
std::string format_rounded(double value, int digits = 6);

}  // namespace smurf
