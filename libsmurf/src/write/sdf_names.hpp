// SPDX-License-Identifier: BSD-3-Clause
// Names that SDF accepts.
#pragma once

#include <string>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// The names of the links of a model. SDF reserves `world`, names like `__this__`, and the
/// separator `::`.
std::vector<std::string> sdf_names(const LinkedModel& model);

}  // namespace smurf
