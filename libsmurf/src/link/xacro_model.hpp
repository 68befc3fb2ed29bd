// SPDX-License-Identifier: BSD-3-Clause
// Expands xacro files with the files, packages and arguments of a load.
#pragma once

#include "smurf/load.hpp"

namespace smurf {

/// Expands a file that has been read.
xacro::Expansion expand_xacro(SourceId root, LoadContext& context);

}  // namespace smurf
