// SPDX-License-Identifier: BSD-3-Clause
// The files in the project around a file.
#pragma once

#include <string>

#include "smurf/found_inputs.hpp"
#include "smurf/limits.hpp"

namespace smurf {

/// The inputs of the project that contains the file; none if it is in no project. Paths below the
/// current folder are relative to it; all others start as `path` does.
FoundInputs inputs_around(const std::string& path, const Limits& limits,
                          const LeftOut& is_left_out = nullptr);

}  // namespace smurf
