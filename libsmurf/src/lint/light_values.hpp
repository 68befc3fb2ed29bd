// SPDX-License-Identifier: BSD-3-Clause
// Lights, which scenes and models have alike.
#pragma once

#include "smurf/lint.hpp"

namespace smurf {

/// Reports the values that a light leaves out and that have no default in MARS.
void report_incomplete_light(const Light& light, yaml::View mapping, Findings& findings);

}  // namespace smurf
