// SPDX-License-Identifier: BSD-3-Clause
// Floating-point numbers as text, as std::from_chars and std::to_chars do it. Those of doubles are
// absent from libc++; there, and in the test that compares the two, `portable` does the same.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

namespace smurf {

enum class Notation { shorter, fixed, scientific };

/// The number that `text` begins with. Not changed when there is none, or when it is out of range,
/// as are numbers so small that they would become 0.
std::from_chars_result read_floating(std::string_view text, double& value);
/// The same for a number in base 16 without "0x".
std::from_chars_result read_hexadecimal(std::string_view text, double& value);

/// The shortest text that reads back as the same number. Precondition: finite.
std::string shortest(double value, Notation notation);
std::string shortest(float value);
/// As "%.*g" of printf, independent of the locale.
std::string general(double value, int digits);

namespace portable {

std::from_chars_result read_floating(std::string_view text, double& value);
std::from_chars_result read_hexadecimal(std::string_view text, double& value);
std::string shortest(double value, Notation notation);
std::string shortest(float value);
std::string general(double value, int digits);

}  // namespace portable
}  // namespace smurf
