// SPDX-License-Identifier: BSD-3-Clause
// Names that SDF accepts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// SDF reserves `world`, names like `__this__`, and the separator `::`. libsdformat refuses the
/// file for one of them.
std::string sdf_name(std::string_view name);

/// The names of the links of a model.
std::vector<std::string> sdf_names(const LinkedModel& model);

}  // namespace smurf
