// SPDX-License-Identifier: BSD-3-Clause
// Declares every reader of readers.def.
#pragma once

#include "smurf/readers.hpp"

namespace smurf::readers {

#define SMURF_READER(name) extern const Reader name;
#include "base/readers.def"
#undef SMURF_READER

}  // namespace smurf::readers
