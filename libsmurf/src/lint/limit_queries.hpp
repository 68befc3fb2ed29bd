// SPDX-License-Identifier: BSD-3-Clause
// What several rules ask about the limit of a joint.
#pragma once

#include "lint/queries.hpp"

namespace smurf {

/// A limit with none of its attributes, on a joint that needs one: reported as a whole.
bool is_empty_limit(const LinkedModel& model, const urdf::Joint& joint);
/// A joint that its bounds lock (SML1408), whatever else its limit says.
bool has_equal_bounds(const urdf::Joint& joint);

}  // namespace smurf
