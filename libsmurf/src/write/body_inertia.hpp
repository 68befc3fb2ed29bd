// SPDX-License-Identifier: BSD-3-Clause
// Inertias as MuJoCo takes them.
#pragma once

#include <string>
#include <string_view>

#include "write/scene_parts.hpp"

namespace smurf {

struct MjcfInertia {
  std::string mass;
  std::string_view tensor_name;  ///< the attribute: "fullinertia" or "diaginertia"
  std::string tensor;
  std::string orientation;  ///< of the principal axes; empty with a full tensor
  bool is_changed = false;  ///< the nearest that MuJoCo takes
};

/// Of a body that moves by a joint of its own, or not.
MjcfInertia mjcf_inertia(const LinkInertial& mass, bool moves);

}  // namespace smurf
