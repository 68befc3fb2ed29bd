// SPDX-License-Identifier: BSD-3-Clause
// Sound bodies and axes in place of those that ODE refuses, so that the rest of a robot is checked.
#pragma once

#include "smurf-load-check/plan.hpp"

namespace smurf::load_check {

/// Whether a body can exist and ODE takes it.
bool is_sound(const MassProperties& mass);

/// Gives every other body the inertia of a ball of water, and the mean mass of the sound ones where
/// it has no mass; joints without an axis turn about x. Returns how many bodies and joints are not
/// as written.
std::size_t add_stand_ins(Plan& plan);

}  // namespace smurf::load_check
