// SPDX-License-Identifier: BSD-3-Clause
// Declares the rules of robots that are made from files of other languages. They are reported while
// such a file is read, so no check of a robot needs them.
#pragma once

#include "smurf/diagnostic.hpp"

namespace smurf::rules {

#define SMURF_RULE(name) extern const Rule name;
#include "base/findings/import_rules.def"
#undef SMURF_RULE

}  // namespace smurf::rules
