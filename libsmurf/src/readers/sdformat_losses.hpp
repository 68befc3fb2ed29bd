// SPDX-License-Identifier: BSD-3-Clause
// What sdformat loses because it merges links that fixed joints connect.
#pragma once

#include <cstddef>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// A part of the tree that sdformat leaves out, although what it hangs on has a mass.
struct LostLimb {
  LinkIndex mount;
  std::size_t links = 0;   ///< left out, each with its joint
  bool is_merged = false;  ///< the mount itself is not lost
};

/// The limbs whose topmost link is on a fixed joint. sdformat 12.3 leaves out what is below a link
/// if the mass of the link, together with all that is merged into it, is 0.
std::vector<LostLimb> limbs_lost_by_sdformat(const LinkedModel& model);

/// Two links of one body.
struct MasslessSum {
  LinkIndex link, parent;
};
/// For each body that is not left out: where sdformat merges an inertial without mass into a link
/// without mass, and so divides 0 by 0.
std::vector<MasslessSum> massless_sums_of_sdformat(const LinkedModel& model);

/// By link: the mass (kg) of the link and of all that sdformat merges into it.
std::vector<double> merged_masses(const LinkedModel& model);

}  // namespace smurf
