// SPDX-License-Identifier: BSD-3-Clause
// Where the joints of a robot start: as near to zero as their limits let them.
#pragma once

#include "smurf-load-check/plan.hpp"

namespace smurf::load_check {

/// The positions of `given`, and for every other joint the allowed position that is nearest to
/// zero. A joint that others mimic moves so far that they are within their limits as well, where
/// there is such a position. Joints that start at zero are left out.
JointPositions start_positions(const LinkedModel& model, const JointPositions& given);

/// How far a joint starts outside its limits; 0 when it is within, or has none.
double outside_limits(const JointPlan& joint);

/// A joint of the plan that starts within a millionth of one of its limits; null when none does.
const JointPlan* joint_at_stop(const Plan& plan);

}  // namespace smurf::load_check
