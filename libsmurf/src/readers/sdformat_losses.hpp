// SPDX-License-Identifier: BSD-3-Clause
// What sdformat loses because it merges links that fixed joints connect.
#pragma once

#include <cstddef>
#include <vector>

#include "base/findings/readers.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// A part of the tree that sdformat leaves out, although what it hangs on has a mass.
struct LostLimb {
  LinkIndex mount;
  std::size_t links = 0;   ///< left out, each with its joint
  bool is_merged = false;  ///< the mount itself is not lost
  bool is_unread = false;  ///< the mount is on a movable joint, and its mass cannot be read
};

/// The limbs whose topmost link is on a fixed joint, or has a mass that urdfdom cannot read.
/// sdformat 12.3 leaves out what is below a link if the mass of the link, together with all that is
/// merged into it, is 0.
std::vector<LostLimb> limbs_lost_by_sdformat(const LinkedModel& model);

/// Two links of one body.
struct MasslessSum {
  LinkIndex link, parent;
};
/// For each body that is not left out: where sdformat merges an inertial without mass into a link
/// without mass, and so divides 0 by 0.
std::vector<MasslessSum> massless_sums_of_sdformat(const LinkedModel& model);

/// Findings about the inertials of links that sdformat before 12.7.2 leaves out unread.
inline constexpr Circumstance kLeftOut{"in a lost limb"};
inline constexpr Fact kGazeboLeavesOut{&readers::gazebo, Effect::takes,
                                       "leaves the link out, with the limb that it is part of",
                                       kRun, when(kLeftOut).before({12, 7, 2})};

/// Says in findings about inertials what sdformat does with their links. Computes it at the first
/// question.
class InertialsTogether {
 public:
  explicit InertialsTogether(const LinkedModel& model) : model_(model) {}

  /// Whether sdformat accepts what it merges the inertial into.
  bool is_sound(std::size_t link);
  void tell(std::size_t link, Diagnostic& diagnostic);

 private:
  const LinkedModel& model_;
  std::vector<bool> sound_, left_out_;  // by link
};

/// By link: the mass (kg) of the link and of all that sdformat merges into it.
std::vector<double> merged_masses(const LinkedModel& model);

}  // namespace smurf
