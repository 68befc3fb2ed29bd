// SPDX-License-Identifier: BSD-3-Clause
#include "ast/wrong_type.hpp"

#include <utility>

#include "ast/notation.hpp"
#include "base/ranges.hpp"
#include "base/rules.hpp"

namespace smurf {
namespace {

/// MARS reads quoted numbers and booleans as if they were not quoted.
bool is_quoted_value(yaml::View value) {
  if (value.style() == yaml::Style::plain) return false;
  const yaml::ScalarType type = type_without_quotes(value);
  return type != yaml::ScalarType::text && type != yaml::ScalarType::null;
}

std::string_view kind_of(yaml::View value) {
  if (value.is_null()) return "nothing";
  if (value.is_mapping()) return "mapping";
  if (value.is_sequence()) {
    return value.size() == 0 ? "empty" : value.size() == 1 ? "single" : "list";
  }
  if (value.text().empty()) return "blank";
  return is_quoted_value(value) ? "quoted" : "text";
}

}  // namespace

Diagnostic& report_wrong_type(std::string_view wanted, yaml::View value, std::string message,
                              DiagnosticSink& sink) {
  Diagnostic& diagnostic =
      sink.report(rules::sml4001_wrong_type, value.place(), std::move(message));
  const bool has_null = wanted == wanted::kNumbers && value.is_sequence() &&
                        ranges::any_of(value, [](yaml::View item) { return item.is_null(); });
  diagnostic.construct.append(wanted).append("-").append(has_null ? "null" : kind_of(value));
  return diagnostic;
}

}  // namespace smurf
