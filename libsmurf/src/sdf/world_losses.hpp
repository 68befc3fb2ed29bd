// SPDX-License-Identifier: BSD-3-Clause
// What a world says besides its models that a scene of SMURF has no key for.
#pragma once

#include <string>
#include <vector>

#include "sdf/reading.hpp"

namespace smurf::sdformat {

struct LostSetting {
  Span place;
  std::string what;         ///< "`wind`"
  bool is_of_look = false;  ///< or of the speed of the computation: nothing moves differently
};

/// In the order of the file. A value that Gazebo has without it is no loss.
std::vector<LostSetting> lost_settings(View world);

}  // namespace smurf::sdformat
