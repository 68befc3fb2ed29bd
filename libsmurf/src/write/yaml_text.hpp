// SPDX-License-Identifier: BSD-3-Clause
// Values as the YAML text a person would have written.
#pragma once

#include <string>
#include <string_view>

#include "smurf/new_model.hpp"

namespace smurf {

/// "key: value" with everything inside, in block style.
std::string yaml_text(const NewValue& member);

/// A scalar that YAML 1.1 (PyYAML, yaml-cpp) and 1.2 readers take as this text: plain where that
/// is certain, else quoted.
std::string yaml_scalar(std::string_view text);

/// A number that both versions take as a number: 1.1 wants a point before an exponent.
std::string yaml_number(double number);

/// A line "# text" for each line.
std::string yaml_comment(std::string_view text);

}  // namespace smurf
