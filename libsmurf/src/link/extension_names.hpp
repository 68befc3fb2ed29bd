// SPDX-License-Identifier: BSD-3-Clause
// The names in the attributes of URDF extensions and of SRDF.
#pragma once

#include <string_view>

#include "smurf/names.hpp"

namespace smurf {

/// The kinds of things that the value of an attribute names, such as a link for `reference` of
/// <gazebo>. Empty if the element has no such attribute.
NameKinds names_in_extension(std::string_view parent, std::string_view element,
                             std::string_view attribute);

}  // namespace smurf
