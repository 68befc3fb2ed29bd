// SPDX-License-Identifier: BSD-3-Clause
// Numbers in URDF attributes: a strict grammar, and names for the deviations of readers.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Reads numbers separated by spaces into `out`; false if this fails. Reports SML18xx, SML1009 or
/// SML1012 at the attribute's value. A text whose meaning is clear although some readers refuse it
/// (trailing space, tabs) still gives values.
bool read_numbers(const xml::Attribute& attribute, std::span<double> out, DiagnosticSink& sink);

/// Reads a number as C programs do: "0x1F", "-0x1p-3". None for other texts.
std::optional<double> parse_hexadecimal(std::string_view text);

/// True for a decimal number that is too small for a double.
bool is_underflow(std::string_view text);

/// Whether white space follows a number where urdfdom does not skip it: anything after a single
/// number, a tab or line break after one of a vector.
bool has_blank_behind(std::string_view text, bool is_vector);

/// Whether a value contains a xacro expression, "${...}" or "$(...)".
bool is_xacro(std::string_view value);

/// Reports SML1012 for a value that contains `%`.
void report_percent(Span place, std::string_view value, DiagnosticSink& sink);

}  // namespace smurf
