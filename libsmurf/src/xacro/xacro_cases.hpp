// SPDX-License-Identifier: BSD-3-Clause
// What findings about xacro have in common.
#pragma once

#include "smurf/diagnostic.hpp"

namespace smurf::xacro {

/// The name of a file is an argument without a value.
inline constexpr Circumstance kEmptyFileName{"empty file name"};

/// The default of an argument stands below its first use.
inline constexpr Circumstance kLateDefault{"late default"};

}  // namespace smurf::xacro
