// SPDX-License-Identifier: BSD-3-Clause
// Words and combinations that libsdformat refuses when it builds a model.
#pragma once

#include "sdf/reading.hpp"
#include "sdf/schema.hpp"

namespace smurf::sdformat {

/// Compares the words of an element, and the parts that need each other.
void check_meaning(View element, const Grammar& known, Reporter& reporter);

}  // namespace smurf::sdformat
