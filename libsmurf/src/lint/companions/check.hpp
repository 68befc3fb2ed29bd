// SPDX-License-Identifier: BSD-3-Clause
// Rules about a robot with its companions, and the readers that their facts are about.
#pragma once

#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "lint/queries.hpp"
#include "smurf/companions.hpp"

namespace smurf {

/// The check of one rule. The model has no robot if none was found for a companion.
using CompanionCheck = void (*)(const LinkedModel& model, const Companions& companions,
                                Findings& findings);

/// By the name of the rule.
namespace companion_checks {

#define SMURF_RULE(name) extern const CompanionCheck name;
#include "base/findings/companion_rules.def"
#undef SMURF_RULE

}  // namespace companion_checks

}  // namespace smurf
