// SPDX-License-Identifier: BSD-3-Clause
// Declares every reader of readers.def.
#pragma once

#include "smurf/readers.hpp"

namespace smurf {

/// A construct of findings in visuals, where the file tells MuJoCo to keep them.
inline constexpr std::string_view kVisualsKept = "#visuals-kept";

}  // namespace smurf

namespace smurf::readers {

#define SMURF_READER(name) extern const Reader name;
#include "base/readers.def"
#undef SMURF_READER

}  // namespace smurf::readers
