// SPDX-License-Identifier: BSD-3-Clause
// Reports of malformed text and attributes, which some readers accept.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// The end of a value without quotes, as TinyXML reads it: at a space or at the end of the tag.
/// None if TinyXML does not read it either, or if the value begins with a typographic quote.
std::optional<std::size_t> end_of_bare_value(std::string_view text, std::size_t begin);
/// The closing quote of a value that contains `<`. None if a line or a tag ends before it, because
/// then the closing quote is missing.
std::optional<std::size_t> end_of_value_with_less_than(std::string_view text, std::size_t begin,
                                                       char quote);

/// `fault` is a case of SML1001: what readers make of it.
Diagnostic& report_malformed(Span place, std::string message, const Circumstance& fault,
                             DiagnosticSink& sink);
/// Says where an element is opened that is not closed, and what to write instead of the end tag
/// `written`; "": the file ends.
void explain_open(Span place, std::string_view open, std::string_view written,
                  Diagnostic& diagnostic);
/// `text` begins with a `<` that begins no element.
void report_no_element(Span place, std::string_view text, const Circumstance& fault,
                       DiagnosticSink& sink);
void report_second_declaration(Span place, DiagnosticSink& sink);
/// Whether the first root element is whole without it.
bool report_second_root(Span place, std::string_view name, Span first, DiagnosticSink& sink);
/// Nothing separates the attribute from the one before it.
void report_late_instruction(Span place, std::string_view text, DiagnosticSink& sink);
void report_missing_blank(Span place, std::string_view name, DiagnosticSink& sink);
void report_missing_quotes(Span value, std::string_view name, DiagnosticSink& sink);
void report_less_than(Span place, DiagnosticSink& sink);
void report_unknown_entity(Span place, std::string_view entity, DiagnosticSink& sink);
/// `text` begins with the `&`.
void report_bare_ampersand(Span place, std::string_view text, DiagnosticSink& sink);

}  // namespace smurf
