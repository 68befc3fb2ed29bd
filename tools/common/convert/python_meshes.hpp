// SPDX-License-Identifier: BSD-3-Clause
// Meshes by Python modules that users install: convex parts by CoACD, fewer triangles by
// meshoptimizer. They run in the `python3` on the PATH, each mesh in a process of its own, which
// may take `seconds` of processor time; 0: no end. Results are the same in every run.
#pragma once

#include <cstdint>

#include "smurf/conversion.hpp"

namespace smurf::tools {

ConvexParts divide_with_coacd(const DividedMesh& mesh, std::uint64_t seconds);

LighterMesh lighten_with_meshoptimizer(const HeavyMesh& mesh, std::uint64_t seconds);

}  // namespace smurf::tools
