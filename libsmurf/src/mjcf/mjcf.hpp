// SPDX-License-Identifier: BSD-3-Clause
// MJCF, the language of MuJoCo: makes a URDF and SMURF annotations of a model, and remembers where
// every byte of them was written.
#pragma once

#include <string_view>

#include "imports/imports.hpp"

namespace smurf::mjcf {

/// Reads a file that has been read, with all that it includes, and adds the results to the sources.
imports::Imported expand(SourceId root, imports::Context& context);

/// Whether the root element of a text is one of MJCF. Reads the beginning only.
bool is_mjcf(std::string_view text);
/// Whether it is a part of a model that others include.
bool is_part(std::string_view text);

}  // namespace smurf::mjcf
