// SPDX-License-Identifier: BSD-3-Clause
// Advice about xacro files where only a URDF is read.
#pragma once

#include <string>
#include <string_view>

#include "base/files/path.hpp"

namespace smurf {

/// "make a URDF with `smurf2urdf arm.urdf.xacro -o arm.urdf`".
inline std::string how_to_expand(std::string_view path) {
  std::string urdf(path.substr(0, path.size() - path::extension(path).size()));
  if (path::to_lower(path::extension(urdf)) != ".urdf") urdf += ".urdf";
  return "make a URDF with `smurf2urdf " + std::string(path) + " -o " + urdf + "`";
}

}  // namespace smurf
