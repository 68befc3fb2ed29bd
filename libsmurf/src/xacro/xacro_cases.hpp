// SPDX-License-Identifier: BSD-3-Clause
// What findings about xacro have in common.
#pragma once

#include "smurf/diagnostic.hpp"

namespace smurf::xacro {

/// The name of a file is an argument without a value.
inline constexpr Circumstance kEmptyFileName{"empty file name"};

}  // namespace smurf::xacro
