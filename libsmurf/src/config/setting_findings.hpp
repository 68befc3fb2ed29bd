// SPDX-License-Identifier: BSD-3-Clause
// Findings on values of a configuration that cannot be used.
#pragma once

#include <string>
#include <string_view>

#include "smurf/diagnostic.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

Diagnostic& wrong_setting(yaml::View value, Span place, std::string message, DiagnosticSink& sink);

/// "`file` must be ..., not a list"
void expect_setting(yaml::View value, std::string_view expected, DiagnosticSink& sink);

}  // namespace smurf
