// SPDX-License-Identifier: BSD-3-Clause
// What the attributes name that are in no table of URDF.
#pragma once

#include <string_view>

#include "smurf/names.hpp"

namespace smurf {

/// In an element of an extension (`reference` of <gazebo>) or of an SRDF; empty when its element
/// says nothing about it.
NameKinds names_in_extension(std::string_view parent, std::string_view element,
                             std::string_view attribute);

}  // namespace smurf
