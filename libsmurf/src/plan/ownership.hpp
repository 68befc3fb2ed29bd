// SPDX-License-Identifier: BSD-3-Clause
// Which robots a companion belongs to. Nothing is read here.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "smurf/companions.hpp"

namespace smurf {

/// What is known of a file and a robot that it may belong to.
struct Claim {
  CompanionKind kind{};
  Evidence evidence = Evidence::below;
  /// Names that the robot has, that are misspellings of its names, and all.
  std::size_t known = 0, near = 0, names = 0;
  bool has_hardware = false;  ///< the robot has elements `ros2_control`
  bool has_prefix = false;    ///< names are known but for a prefix that all of them lack
};
Claim claim_of(const Companion& companion, const LinkedModel& model);

/// The claims that count, in their order: those with a tie, if there are any; else those for which
/// the name of the robot in an SRDF speaks; of these, the ones with the most names. Names choose
/// between robots only: a file with one claim belongs to that robot. Several are returned when
/// nothing tells them apart.
std::vector<std::size_t> choose_owners(std::span<const Claim> claims);

}  // namespace smurf
