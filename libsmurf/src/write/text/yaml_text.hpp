// SPDX-License-Identifier: BSD-3-Clause
// Writes values as YAML text in the style of a person.
#pragma once

#include <string>
#include <string_view>

#include "smurf/new_model.hpp"

namespace smurf {

/// "key: value" with all nested values, in block style.
std::string yaml_text(const NewValue& member);

/// A scalar that readers of YAML 1.1 (PyYAML, yaml-cpp) and 1.2 read as this text: plain where that
/// is certain, otherwise quoted.
std::string yaml_scalar(std::string_view text);

/// A number that both versions read as a number: YAML 1.1 requires a point before an exponent.
std::string yaml_number(double number);

/// A line "# text" for each line.
std::string yaml_comment(std::string_view text);

}  // namespace smurf
