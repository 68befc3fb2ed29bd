// SPDX-License-Identifier: BSD-3-Clause
#include "ast/wrong_type.hpp"

#include <utility>

#include "ast/notation.hpp"
#include "base/findings/rules.hpp"
#include "base/ranges.hpp"

namespace smurf {
namespace {

/// MARS reads quoted numbers and booleans as if they were not quoted.
bool is_quoted_value(yaml::View value) {
  if (value.style() == yaml::Style::plain) return false;
  const yaml::ScalarType type = type_without_quotes(value);
  return type != yaml::ScalarType::text && type != yaml::ScalarType::null;
}

const Circumstance& kind_of(yaml::View value) {
  if (value.is_null()) return cases::kIsNothing;
  if (value.is_mapping()) return cases::kIsMapping;
  if (value.is_sequence()) {
    return value.size() == 0   ? cases::kIsEmptyList
           : value.size() == 1 ? cases::kIsSingle
                               : cases::kIsList;
  }
  if (value.text().empty()) return cases::kIsBlank;
  return is_quoted_value(value) ? cases::kIsQuoted : cases::kIsText;
}

}  // namespace

Diagnostic& report_wrong_type(const Circumstance& wanted, yaml::View value, std::string message,
                              DiagnosticSink& sink) {
  Diagnostic& diagnostic =
      sink.report(rules::sml4001_wrong_type, value.place(), std::move(message));
  const bool has_null = &wanted == &cases::kNumbersWanted && value.is_sequence() &&
                        ranges::any_of(value, [](yaml::View item) { return item.is_null(); });
  return diagnostic.when(wanted).when(has_null ? cases::kHasNull : kind_of(value));
}

}  // namespace smurf
