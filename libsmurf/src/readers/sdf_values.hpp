// SPDX-License-Identifier: BSD-3-Clause
// Values as sdformat reads them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "readers/sdf_language.hpp"
#include "smurf/xml.hpp"

namespace smurf::sdf {

/// As std::stod, which throws for other texts, and for numbers that a double cannot hold.
std::optional<double> leading_number(std::string_view text);
/// As std::stoi. `base` is 10 or 16.
std::optional<long long> leading_integer(std::string_view text, int base);
/// As three numbers read from a stream.
std::optional<std::array<double, 3>> read_vector(std::string_view text);
/// The attribute `value` of an element for Gazebo, or else its text: sdformat reads it so.
std::string_view given_value(xml::View element);
/// Without what sdformat takes off both ends.
std::string_view trimmed_text(std::string_view text);

/// False for a text that sdformat refuses as the value of `part` of this element.
bool is_readable(const Part& part, std::string_view text, xml::View element);
/// What sdformat reads for `part`: "a number".
std::string_view wanted(const Part& part);

}  // namespace smurf::sdf
