// SPDX-License-Identifier: BSD-3-Clause
// Questions that several rules ask about the limit of a joint.
#pragma once

#include "lint/queries.hpp"

namespace smurf {

/// A limit without any attribute, on a joint that needs one: reported as one finding.
bool is_empty_limit(const LinkedModel& model, const urdf::Joint& joint);
/// A joint that is locked by its bounds (SML1408).
bool has_equal_bounds(const urdf::Joint& joint);

}  // namespace smurf
