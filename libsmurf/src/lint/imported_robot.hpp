// SPDX-License-Identifier: BSD-3-Clause
// Robots that are made from files of other languages.
#pragma once

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// Whether the file of the robot is MJCF or SDF, which have words that a URDF has not.
inline bool is_of_other_language(const LinkedModel& model) {
  return is_one_of(path::to_lower(path::extension(model.urdf_path)),
                   {".xml", ".mjcf", ".sdf", ".world"}) ||
         model.urdf_path.find(".sdf#") != std::string::npos ||
         model.urdf_path.find(".world#") != std::string::npos;
}

}  // namespace smurf
