// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/xml_lenient.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/findings/cases.hpp"
#include "base/findings/file_cases.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "syntax/xml_bytes.hpp"
#include "syntax/xml_references.hpp"

namespace smurf {

std::optional<std::size_t> end_of_bare_value(std::string_view text, std::size_t begin) {
  const std::size_t end = text.find_first_of(" \t\n\r\"'/<>&", begin);
  if (end == std::string_view::npos || end == begin) return std::nullopt;
  const bool is_ended =
      is(text[end], blank) || text[end] == '>' || text.substr(end).starts_with("/>");
  const bool is_plain = static_cast<unsigned char>(text[begin]) < 0x80;
  return is_ended && is_plain ? std::optional(end) : std::nullopt;
}

std::optional<std::size_t> end_of_value_with_less_than(std::string_view text, std::size_t begin,
                                                       char quote) {
  const std::size_t end = text.find_first_of(std::string{quote, '>', '\n'}, begin);
  const bool is_closed = end != std::string_view::npos && text[end] == quote;
  return is_closed ? std::optional(end) : std::nullopt;
}

Diagnostic& report_malformed(Span place, std::string message, const Circumstance& fault,
                             DiagnosticSink& sink) {
  Diagnostic& diagnostic = sink.report(rules::sml1001_xml_malformed, place, std::move(message));
  diagnostic.when(fault);
  return diagnostic;
}

void explain_open(Span place, std::string_view open, std::string_view written,
                  Diagnostic& diagnostic) {
  constexpr std::size_t kLongest = 80;  // of a name that a help repeats
  diagnostic.label(place, written.empty() ? "opened here and never closed" : "opened here");
  if (std::max(open.size(), written.size()) > kLongest) return;
  const std::string end = "`</" + std::string(open) + ">`";
  if (written.empty()) {
    diagnostic.help("add " + end + " where the element ends");
  } else if (edit_distance(written, open, 1) <= 1) {
    diagnostic.help("write the same name in both tags");
  } else {
    diagnostic.help("add " + end + " before `</" + std::string(written) +
                    ">`, or where the element ends");
  }
}

void report_no_element(Span place, std::string_view text, const Circumstance& fault,
                       DiagnosticSink& sink) {
  constexpr std::string_view kMergeMark = "<<<<<<<";
  if (text.starts_with(kMergeMark)) {
    place.end = place.begin + static_cast<std::uint32_t>(kMergeMark.size());
    report_malformed(place, "a merge conflict left its markers here", fault, sink)
        .help("keep one of the two versions, and delete the markers");
    return;
  }
  report_malformed(place, "`<` does not begin an element here", fault, sink)
      .help("write `&lt;` for the character itself");
}

void report_second_declaration(Span place, DiagnosticSink& sink) {
  sink.report(rules::sml1005_xml_junk_before_prolog, place, "a second XML declaration")
      .when(cases::kSecond)
      .fixes.push_back({Applicability::safe, {{place, ""}}});
}

bool report_second_root(Span place, std::string_view name, Span first, DiagnosticSink& sink) {
  Diagnostic& diagnostic =
      sink.report(rules::sml1006_xml_several_roots, place,
                  "a second root element " + quoted(name) + " begins after the first has ended");
  diagnostic.label(first, "the root element");
  // Such an element was a part of the first one, which is not whole without it.
  const bool is_part = is_one_of(name, {"link", "joint"});
  if (is_part) diagnostic.when(kUncertain);
  return !is_part;
}

void report_late_instruction(Span place, std::string_view text, DiagnosticSink& sink) {
  Diagnostic& found = sink.report(rules::sml1015_xml_late_instruction, place,
                                  "this processing instruction is not at the start of the file");
  if (text.starts_with("<?xml ")) found.when(cases::kLateDeclaration);
}

void report_missing_blank(Span place, std::string_view name, DiagnosticSink& sink) {
  sink.report(rules::sml1014_xml_missing_blank, place,
              "a space is missing before the attribute " + quoted(name))
      .fixes.push_back({Applicability::safe, {{{place.source, place.begin, place.begin}, " "}}});
}

void report_missing_quotes(Span value, std::string_view name, DiagnosticSink& sink) {
  sink.report(rules::sml1016_xml_missing_quotes, value,
              "the value of the attribute " + quoted(name) + " has no quotes")
      .help("put the value in quotes")
      .fixes.push_back({Applicability::safe,
                        {{{value.source, value.begin, value.begin}, "\""},
                         {{value.source, value.end, value.end}, "\""}}});
}

void report_less_than(Span place, DiagnosticSink& sink) {
  sink.report(rules::sml1017_xml_less_than_in_value, place,
              "this `<` is in the value of an attribute")
      .fixes.push_back({Applicability::safe, {{place, "&lt;"}}});
}

void report_unknown_entity(Span place, std::string_view entity, DiagnosticSink& sink) {
  sink.report(rules::sml1013_dtd_or_xinclude, place,
              "URDF readers do not expand the entity `" + std::string(entity) + "`")
      .help("write the text out");
}

void report_bare_ampersand(Span place, std::string_view text, DiagnosticSink& sink) {
  Diagnostic& diagnostic = sink.report(rules::sml1003_xml_bare_ampersand, place,
                                       "`&` does not begin a character reference");
  if (is_broken_character(text)) diagnostic.when(cases::kCharacter);
  diagnostic.fixes.push_back({Applicability::safe, {{place, "&amp;"}}});
}

}  // namespace smurf
