// SPDX-License-Identifier: BSD-3-Clause
// Converts floating-point numbers from and to text, as std::from_chars and std::to_chars do. libc++
// lacks these for doubles; there, `portable` replaces them. A test compares the two.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

namespace smurf {

enum class Notation { shorter, fixed, scientific };

/// Reads the number at the beginning of `text`. The result is unchanged if there is none, or if it
/// is out of range; numbers that would become 0 are out of range.
std::from_chars_result read_floating(std::string_view text, double& value);
/// Reads a number in base 16 without "0x" in the same way.
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
