// SPDX-License-Identifier: BSD-3-Clause
// How readers with other scalar grammars read a plain scalar.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "smurf/yaml.hpp"

namespace smurf {

/// Whether a document is written as JSON, in which readers agree about numbers.
bool is_json(const yaml::Document& document);

/// True for digits and a point, as in nearly all numbers: all readers agree about them. A whole
/// number must not have a point.
bool is_in_all_notations(std::string_view number, bool is_whole);

/// The number that scanf reads with %lf, or with %d for whole numbers; none if it is the
/// same.
std::optional<std::string> read_by_scanf(std::string_view number, bool is_whole);

/// The type that PyYAML reads for a number of the YAML 1.2 core schema: "a text", "8"; none if it
/// reads the same number.
std::optional<std::string> number_by_yaml11(std::string_view number);

/// The type that PyYAML reads for a plain text of the core schema: "a boolean"; none if it reads a
/// text.
std::optional<std::string> text_by_yaml11(std::string_view text);

/// A number in a form that all readers understand: 1.0e-07.
std::string in_all_notations(double number);

}  // namespace smurf
