// SPDX-License-Identifier: BSD-3-Clause
// COLLADA files that express the same things in many ways.
#pragma once

#include <string>

#include "unit/random.hpp"

namespace smurf::test {

/// With nodes, transforms, units, axes, strides and all primitives that have triangles.
std::string random_collada(Random& random);

}  // namespace smurf::test
