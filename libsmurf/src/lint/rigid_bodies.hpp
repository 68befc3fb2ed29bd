// SPDX-License-Identifier: BSD-3-Clause
// The bodies that fixed joints make of links.
#pragma once

#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// By link: is it part of a body that moves and has no mass, nor collisions that a reader could
/// compute one from?
std::vector<bool> massless_bodies(const LinkedModel& model);

/// True when the link, or a link fixed to it, has an inertial.
bool has_fixed_mass(const LinkedModel& model, LinkIndex link);

/// By link: does it hang by a fixed joint on others that weigh at least as much? Readers can take
/// them for one body then, whatever its own mass and inertia are.
std::vector<bool> fixed_to_heavier(const LinkedModel& model);

/// By link: the mass (kg) of the body that sdformat makes of it and other links: those that fixed
/// joints connect, except for joints that a Gazebo element keeps.
std::vector<double> masses_of_bodies(const LinkedModel& model);

/// By link: is it the only one with an inertial in a body that moves?
std::vector<bool> alone_in_motion(const LinkedModel& model);

/// By link: do the inertials that sdformat makes one body of come to one that it takes,
/// whatever each of them is? Like gz-math, it takes a moment of 0.
std::vector<bool> sound_together(const LinkedModel& model);

}  // namespace smurf
