// SPDX-License-Identifier: BSD-3-Clause
// The sink and the one table of rules.
#include "smurf/diagnostic.hpp"

#include <algorithm>

#include "base/rules.hpp"

namespace smurf {
namespace {

constexpr const Rule* kRules[] = {
#define SMURF_RULE(name) &rules::name,
#include "base/rules.def"
#undef SMURF_RULE
};

}  // namespace

std::string_view to_string(Severity severity) {
  switch (severity) {
  case Severity::info: return "info";
  case Severity::warning: return "warning";
  case Severity::error: return "error";
  }
  return "";
}

Diagnostic& DiagnosticSink::report(const Rule& rule, Span span, std::string message) {
  Diagnostic& diagnostic = diagnostics_.emplace_back();
  diagnostic.rule = &rule;
  diagnostic.severity = rule.severity;
  diagnostic.span = span;
  diagnostic.message = std::move(message);
  return diagnostic;
}

bool DiagnosticSink::has_errors() const {
  return std::any_of(diagnostics_.begin(), diagnostics_.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::span<const Rule* const> all_rules() { return kRules; }

const Rule* find_rule(std::string_view id_or_name) {
  for (const Rule* rule : kRules) {
    if (rule->id == id_or_name || rule->name == id_or_name) return rule;
  }
  return nullptr;
}

}  // namespace smurf
