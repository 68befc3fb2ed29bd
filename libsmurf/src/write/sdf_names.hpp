// SPDX-License-Identifier: BSD-3-Clause
// Names that SDF takes.
#pragma once

#include <string>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// The names of the links of a model. SDF keeps `world`, names like `__this__` and the separator
/// `::` for itself.
std::vector<std::string> sdf_names(const LinkedModel& model);

}  // namespace smurf
