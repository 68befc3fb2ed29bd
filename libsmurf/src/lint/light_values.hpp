// SPDX-License-Identifier: BSD-3-Clause
// Values of the lights of scenes and models.
#pragma once

#include "smurf/lint.hpp"

namespace smurf {

/// Reports the absent values of a light that have no default in MARS.
void report_incomplete_light(const Light& light, yaml::View mapping, Findings& findings);

}  // namespace smurf
