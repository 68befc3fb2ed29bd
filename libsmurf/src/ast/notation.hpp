// SPDX-License-Identifier: BSD-3-Clause
// How readers with other scalar grammars read a plain scalar.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "smurf/yaml.hpp"

namespace smurf {

/// True for a document that is written as JSON, which leaves no room for notations.
bool is_json(const yaml::Document& document);

/// True for digits and a point, as nearly all numbers are: every reader reads them alike. A number
/// that must be whole has no point either.
bool is_in_all_notations(std::string_view number, bool is_whole);

/// What scanf's %lf, or %d when the number is to be whole, reads from a YAML number; none when it
/// is the same number.
std::optional<std::string> read_by_scanf(std::string_view number, bool is_whole);

/// How PyYAML reads a number of the YAML 1.2 core schema: "a text", "8"; none when it is the same
/// number.
std::optional<std::string> number_by_yaml11(std::string_view number);

/// How PyYAML reads a plain scalar that is not a number in the core schema: "a boolean"; none when
/// it is a text for both.
std::optional<std::string> text_by_yaml11(std::string_view text);

/// A number as every reader understands it: 1.0e-07.
std::string in_all_notations(double number);

}  // namespace smurf
