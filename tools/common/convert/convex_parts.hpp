// SPDX-License-Identifier: BSD-3-Clause
// Convex parts of meshes by CoACD, a Python module that users install.
#pragma once

#include <cstdint>

#include "smurf/conversion.hpp"

namespace smurf::tools {

/// Divides a mesh with the CoACD of the `python3` on the PATH, which may take `seconds` of
/// processor time; 0: no end. The result is the same in every run.
ConvexParts divide_with_coacd(const DividedMesh& mesh, std::uint64_t seconds);

}  // namespace smurf::tools
