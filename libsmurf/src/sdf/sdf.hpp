// SPDX-License-Identifier: BSD-3-Clause
// SDF, the language of Gazebo: makes a URDF of a model or a world, and remembers where every byte
// of it was written.
#pragma once

#include <string_view>

#include "imports/imports.hpp"

namespace smurf::sdformat {

/// Reads a file that has been read, with all that it includes, and adds the result to the sources.
imports::Imported expand(SourceId root, imports::Context& context);

/// Whether the root element of a text is `<sdf>`. Reads the beginning only.
bool is_sdf(std::string_view text);

}  // namespace smurf::sdformat
