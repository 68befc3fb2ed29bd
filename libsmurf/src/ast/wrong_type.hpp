// SPDX-License-Identifier: BSD-3-Clause
// Values of the wrong kind (SML4001), with the expected and the found kind: readers treat, for
// example, a list and a text in place of a number differently.
#pragma once

#include <string>

#include "ast/keys.hpp"
#include "base/findings/cases.hpp"

namespace smurf {

/// Reports `message` at the value, with the expected (cases::kValueWanted, ...) and the actual
/// type.
Diagnostic& report_wrong_type(const Circumstance& wanted, yaml::View value, std::string message,
                              DiagnosticSink& sink);

}  // namespace smurf
