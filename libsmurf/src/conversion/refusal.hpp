// SPDX-License-Identifier: BSD-3-Clause
// What conversions have in common.
#pragma once

#include <span>
#include <string>

#include "smurf/conversion.hpp"

namespace smurf {

/// The refusal of a result because of findings; none with `force`, or if no finding makes it wrong.
Refusal refusal_for(std::span<const Diagnostic> findings, bool force, const LossOf& loss_of);

/// "" if it is gone.
std::string folder_of_process();

}  // namespace smurf
