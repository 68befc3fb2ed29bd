// SPDX-License-Identifier: BSD-3-Clause
// Robots that are made from files of other languages.
#pragma once

#include "base/files/path.hpp"
#include "link/imported_world.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// Whether the file of the robot is MJCF or SDF, which have words that a URDF has not.
inline bool is_of_other_language(const LinkedModel& model) {
  return has_name_of_world(model.urdf_path) || !name_in_world(model.urdf_path).empty() ||
         path::to_lower(path::extension(model.urdf_path)) == ".mjcf";
}

}  // namespace smurf
