// SPDX-License-Identifier: BSD-3-Clause
// The pairs of links whose collisions a motion planner need not check: MoveIt's setup assistant
// finds them in the same way (moveit_setup_srdf_plugins, compute_default_collisions.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// Why the contact of a pair of links is of no interest. The names are those of SRDF.
enum class PairReason : std::uint8_t {
  adjacent,  ///< a joint connects them, or only links without shapes are between them
  at_start,  ///< they touch while all joints are at zero, or at the bound that is nearest to it
  always,    ///< they touch in nearly all samples
  never      ///< they touch in no sample
};
std::string_view name_of(PairReason reason);

struct LinkPair {
  std::size_t link = 0, other = 0;  ///< the smaller index first
  PairReason reason = PairReason::adjacent;
};

struct CollisionMatrix {
  std::vector<LinkPair> pairs;  ///< sorted; they are of no interest
  std::size_t all = 0;          ///< number of pairs of links with shapes
  std::size_t samples = 0;      ///< joint positions that were tried
  std::size_t unknown = 0;      ///< links with a shape that could not be read: not in the pairs
  std::size_t floating = 0;  ///< pairs that nothing but floating joints connects: not in the pairs
  bool is_complete = true;   ///< false: there are too many shapes; `pairs` is empty
};

/// Samples the whole range of all joints evenly; continuous joints make one turn. Each call gives
/// the same result. Shapes count as their convex hulls; a pair that never touches keeps a distance
/// of about a hundredth of its shapes.
CollisionMatrix collision_matrix(const LinkedModel& model, std::size_t samples);

}  // namespace smurf
