// SPDX-License-Identifier: BSD-3-Clause
// Declares every rule of xacro_rules.def. Each rule is defined beside the code that reports it.
#pragma once

#include "base/rules.hpp"

namespace smurf::rules {

#define SMURF_RULE(name) extern const Rule name;
#include "base/xacro_rules.def"
#undef SMURF_RULE

}  // namespace smurf::rules
