// SPDX-License-Identifier: BSD-3-Clause
// Values in `<gazebo>` as sdformat reads them.
#pragma once

#include <string_view>

#include "base/numbers/sdf_values.hpp"
#include "readers/sdf_language.hpp"
#include "smurf/xml.hpp"

namespace smurf::sdf {

/// The attribute `value` of an element for Gazebo, or else its text: sdformat reads it so.
std::string_view given_value(xml::View element);
/// Without what sdformat takes off both ends.
std::string_view trimmed_text(std::string_view text);

/// False for a text that sdformat refuses as the value of `part` of this element.
bool is_readable(const Part& part, std::string_view text, xml::View element);
/// What sdformat reads for `part`: "a number".
std::string_view wanted(const Part& part);

}  // namespace smurf::sdf
