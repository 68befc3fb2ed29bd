// SPDX-License-Identifier: BSD-3-Clause
// Which mimic joint follows which joint.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf {

/// Index of the joint that this joint mimics; none if it mimics no joint or an unknown one.
std::optional<std::uint32_t> mimic_leader(const LinkedModel& model, std::uint32_t joint);

/// For each joint, whether its chain of leaders ends in a cycle.
std::vector<bool> endless_mimics(const LinkedModel& model);

/// The names of joints that others mimic, and of those that simple transmissions drive.
std::set<std::string_view> followed_joints(const LinkedModel& model);

inline constexpr Circumstance kFollowed{"mimicked or driven"};
constexpr Fact drake_misses_leader(Where where) {
  return {&readers::drake, Effect::refuses,
          "leaves out the joint, and then does not find what is mimicked or driven", kRun, where};
}

}  // namespace smurf
