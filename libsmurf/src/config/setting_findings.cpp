// SPDX-License-Identifier: BSD-3-Clause
#include "config/setting_findings.hpp"

#include <utility>

#include "ast/keys.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"

namespace smurf {

Diagnostic& wrong_setting(yaml::View value, Span place, std::string message, DiagnosticSink& sink) {
  Diagnostic& diagnostic = sink.report(rules::sml9002_wrong_setting, place, std::move(message));
  diagnostic.pointer = yaml::pointer(value.document(), value.id());
  return diagnostic;
}

void expect_setting(yaml::View value, std::string_view expected, DiagnosticSink& sink) {
  const std::string subject = value.key().empty() ? "an item" : quoted(value.key());
  wrong_setting(value, value.place(),
                subject + " must be " + std::string(expected) + ", not " + describe(value), sink);
}

}  // namespace smurf
