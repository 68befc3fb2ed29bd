// SPDX-License-Identifier: BSD-3-Clause
// An expansion whose work is counted, for runs of many.
#pragma once

#include <cstdint>

#include "smurf/xacro.hpp"

namespace smurf::xacro {

/// As expand(); adds the steps that it took.
Expansion expand(SourceId root, const Settings& settings, Context& context, std::uint64_t& steps);

}  // namespace smurf::xacro
