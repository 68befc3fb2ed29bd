// SPDX-License-Identifier: BSD-3-Clause
// Numbers in URDF attributes: one grammar, and a name for every way readers disagree about a text.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Reads as many numbers, separated by blanks, as `out` takes; false when it cannot. Reports
/// SML18xx, SML1009 or SML1012 at the attribute's value. A text whose meaning is clear although
/// some reader refuses it (a trailing blank, tabs) still gives values.
bool read_numbers(const xml::Attribute& attribute, std::span<double> out, DiagnosticSink& sink);

/// As C programs read it: "0x1F", "-0x1p-3". None for other texts.
std::optional<double> parse_hexadecimal(std::string_view text);

/// True for a decimal number that is too small for a double.
bool is_underflow(std::string_view text);

/// True when a value holds an expression of xacro, "${...}" or "$(...)".
bool is_xacro(std::string_view value);

/// Reports SML1012 for a value that holds `%`.
void report_percent(Span place, std::string_view value, DiagnosticSink& sink);

}  // namespace smurf
