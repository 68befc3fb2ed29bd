// SPDX-License-Identifier: BSD-3-Clause
// The verdict on a target as text.
#pragma once

#include <string>

#include "render/paint.hpp"
#include "smurf/verdict.hpp"

namespace smurf::render {

/// "fails to load (2, 1 in the baseline)"
std::string verdict_of(const TargetVerdict& target, const Painter& paint);

}  // namespace smurf::render
