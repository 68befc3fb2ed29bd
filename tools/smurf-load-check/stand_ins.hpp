// SPDX-License-Identifier: BSD-3-Clause
// Replaces bodies and axes that ODE refuses, so that the rest of a robot is checked.
#pragma once

#include "smurf-load-check/body_plan.hpp"

namespace smurf::load_check {

/// Whether a body is possible and ODE accepts it.
bool is_sound(const MassProperties& mass);

/// Gives other bodies the inertia of a ball of water; bodies without mass get the mean mass of the
/// sound bodies. Joints without an axis turn about x. Returns the number of changed bodies and
/// joints.
std::size_t add_stand_ins(Plan& plan);

}  // namespace smurf::load_check
