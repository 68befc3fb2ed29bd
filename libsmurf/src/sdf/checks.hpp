// SPDX-License-Identifier: BSD-3-Clause
// What libsdformat refuses or ignores in an element by itself, whatever stands elsewhere.
#pragma once

#include "sdf/reading.hpp"

namespace smurf::sdformat {

/// Compares a file, whose root is `<sdf>`, with the elements that SDF has. `version`: its minor
/// version.
void check_elements(View root, int version, Reporter& reporter);

}  // namespace smurf::sdformat
