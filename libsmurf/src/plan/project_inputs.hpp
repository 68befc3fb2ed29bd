// SPDX-License-Identifier: BSD-3-Clause
// The files in the project around a file.
#pragma once

#include <string>

#include "smurf/found_inputs.hpp"
#include "smurf/limits.hpp"

namespace smurf {

/// Empty if the file is in no project. Paths in the current folder are relative to it; others begin
/// like `path`.
FoundInputs inputs_around(const std::string& path, const Limits& limits,
                          const LeftOut& is_left_out = nullptr);

}  // namespace smurf
