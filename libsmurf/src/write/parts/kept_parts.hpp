// SPDX-License-Identifier: BSD-3-Clause
// Links and joints that something names, so that a format must not write several as one.
#pragma once

#include <vector>

#include "write/parts/scene_parts.hpp"

namespace smurf {

/// By index.
struct KeptParts {
  std::vector<bool> links, joints;
};

/// What sensors, motors, elements of Gazebo, loops, followers and anchors of the scene refer to.
KeptParts kept_parts(const LinkedModel& model, const SceneExport& scene);
/// Whether a link is nothing but a frame.
bool is_bare(const LinkedModel& model, std::size_t link, const KeptParts& kept);

}  // namespace smurf
