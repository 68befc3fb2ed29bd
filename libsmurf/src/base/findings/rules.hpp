// SPDX-License-Identifier: BSD-3-Clause
// Declares every rule of rules.def. Each rule is defined beside the code that reports it, in a
// namespace for its file: a build compiles several rules as one unit, and their helpers may have
// the same names.
#pragma once

#include "smurf/diagnostic.hpp"

namespace smurf::rules {

#define SMURF_RULE(name)                                                                           \
  namespace name##_file {                                                                          \
    extern const Rule name;                                                                        \
  }                                                                                                \
  using name##_file::name;
#define SMURF_TEXTS(name) extern const Rule name;
#include "base/findings/rules.def"
#undef SMURF_RULE

}  // namespace smurf::rules
