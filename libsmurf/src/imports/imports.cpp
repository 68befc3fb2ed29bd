// SPDX-License-Identifier: BSD-3-Clause
#include "imports/imports.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "base/text/did_you_mean.hpp"
#include "base/text/words.hpp"
#include "syntax/xml_reader.hpp"

namespace smurf::imports {

namespace {

/// Removes what comes before an element, comments, declarations and blanks, and its "<".
void to_element(std::string_view& text) {
  while (true) {
    text = text.substr(std::min(text.find('<'), text.size()));
    const std::string_view end = text.starts_with("<!--") ? "-->"
                                 : text.starts_with("<?") ? "?>"
                                 : text.starts_with("<!") ? ">"
                                                          : "";
    if (end.empty()) break;
    const std::size_t at = text.find(end, 2);
    text.remove_prefix(at == std::string_view::npos ? text.size() : at + end.size());
  }
  if (!text.empty()) text.remove_prefix(1);
}

std::string_view name_at(std::string_view text) {
  return text.substr(0, std::min(text.find_first_of(" \t\r\n/>"), text.size()));
}

}  // namespace

std::string_view root_tag(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  to_element(text);
  return text.substr(0, text.find('>'));
}

std::string_view root_name(std::string_view text) { return name_at(root_tag(text)); }

std::string_view first_name(std::string_view text) {
  to_element(text);
  text = text.substr(std::min(text.find('>'), text.size()));
  to_element(text);
  return name_at(text);
}

std::optional<xml::Document> parse_lenient_xml(SourceId source, Context& context) {
  // MuJoCo 4.0 and libsdformat 12 were run on each of them.
  constexpr std::array kRead = {
      &rules::sml1003_xml_bare_ampersand,     &rules::sml1004_xml_comment_dashes,
      &rules::sml1005_xml_junk_before_prolog, &rules::sml1006_xml_several_roots,
      &rules::sml1013_dtd_or_xinclude,        &rules::sml1014_xml_missing_blank,
      &rules::sml1017_xml_less_than_in_value};
  DiagnosticSink found(context.limits);
  auto document = parse_xml(context.sources, source, context.limits, found);
  for (Diagnostic& one : found.take()) {
    if (one.rule == &rules::sml1002_xml_undeclared_prefix) continue;
    if (ranges::contains(kRead, one.rule)) one.severity = Severity::warning;
    context.sink.report(*one.rule, one.span, {}) = std::move(one);
  }
  return document;
}

bool is_made(const xacro::Expansion& result, Span part) {
  const auto after =
      std::upper_bound(result.leaves.begin(), result.leaves.end(), part.begin,
                       [](std::uint32_t at, const xacro::Leaf& leaf) { return at < leaf.begin; });
  if (after == result.leaves.begin()) return false;
  return std::prev(after)->first_input == kMade && std::prev(after)->inputs == 0;
}

Diagnostic& Reporter::report(const Rule& rule, Span place, std::string message) {
  if (!known_.insert({&rule, place.source, place.begin}).second) return ignored_ = {};
  return context_.sink.report(rule, place, std::move(message));
}

Diagnostic& Reporter::lose(Span place, std::string message, std::string_view others) {
  Diagnostic& found = report(rules::sml9304_lost_in_urdf, place, std::move(message));
  found.others_are = others;
  // FNV-1a: the same text is the same habit.
  found.habit = 2166136261U;
  for (const char c : others)
    found.habit = (found.habit ^ static_cast<unsigned char>(c)) * 16777619U;
  return found;
}

Diagnostic& Reporter::refuse(Span place, std::string message, std::string help) {
  has_refused_ = true;
  return report(family_.refused, place, std::string(family_.refusal) + std::move(message))
      .help(std::move(help));
}

Diagnostic& Reporter::refuse_name(Span place, std::string message, std::string help) {
  if (!lacks_file_) return refuse(place, std::move(message), std::move(help));
  has_refused_ = true;
  return ignored_ = {};
}

Diagnostic& Reporter::exceed(Span place, std::string message, std::string_view name) {
  has_refused_ = true;
  return report(family_.limit, place, std::move(message)).help(raise_limit(name));
}

Diagnostic& Reporter::miss(Span place, std::string message, std::string help) {
  return report(family_.missing, place, std::move(message)).help(std::move(help));
}

std::string words_of(const Vector3& numbers) {
  return format_number(numbers[0]) + " " + format_number(numbers[1]) + " " +
         format_number(numbers[2]);
}

}  // namespace smurf::imports
