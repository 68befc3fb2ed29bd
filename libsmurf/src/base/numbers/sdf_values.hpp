// SPDX-License-Identifier: BSD-3-Clause
// Values as sdformat reads them, in SDF files and in `<gazebo>`.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace smurf::sdf {

/// As std::stod, which throws for other texts, and for numbers that a double cannot hold.
std::optional<double> leading_number(std::string_view text);
/// As std::stoi. `base` is 10 or 16.
std::optional<long long> leading_integer(std::string_view text, int base);
/// As numbers read from a stream, at most so many.
std::vector<double> streamed_numbers(std::string_view text, std::size_t most);
/// As three numbers read from a stream.
std::optional<std::array<double, 3>> read_vector(std::string_view text);
/// "1", "0", "true" and "false" in any case.
std::optional<bool> read_flag(std::string_view text);
/// The three or four numbers of a colour, which are 0 to 1, or NaN.
std::optional<std::vector<double>> read_color(std::string_view text);
/// The six or seven numbers of a pose, which are finite.
std::optional<std::vector<double>> read_pose(std::string_view text, bool is_quaternion);

/// A number: d(ouble), f(loat), i(nt), u(nsigned). Flags are numbers, too.
std::optional<double> read_scalar(char type, std::string_view text);
/// `range` is "least,most"; either may be absent.
bool is_within(double value, std::string_view range);

}  // namespace smurf::sdf
