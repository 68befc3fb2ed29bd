// SPDX-License-Identifier: BSD-3-Clause
// The start positions of the joints of a robot: as close to zero as their limits allow.
#pragma once

#include "smurf-load-check/body_plan.hpp"

namespace smurf::load_check {

/// The positions of `given`, and for every other joint the allowed position nearest to zero. If
/// possible, leaders start where their followers are within their limits as well. Omits joints that
/// start at zero.
JointPositions start_positions(const LinkedModel& model, const JointPositions& given);

/// The distance of a joint from its limits at the start; 0 if it is within them, or has none.
double outside_limits(const JointPlan& joint);

/// A joint of the plan that starts within a millionth of one of its limits; null if there is none.
const JointPlan* joint_at_stop(const Plan& plan);

}  // namespace smurf::load_check
