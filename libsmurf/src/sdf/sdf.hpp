// SPDX-License-Identifier: BSD-3-Clause
// SDF, the language of Gazebo: makes a URDF of a model or a world, or a scene of a world, and
// remembers where every byte of it was written.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "imports/imports.hpp"

namespace smurf::sdformat {

/// Reads a file that has been read, with all that it includes, and adds the result to the sources.
imports::Imported expand(SourceId root, imports::Context& context);

/// A world as a scene.
struct World {
  xacro::Expansion scene;  ///< a YAML file as a .smurfs
  /// URDFs, by the file that the scene names: "hall.sdf#table". Models that are included several
  /// times share one.
  std::map<std::string, xacro::Expansion> models;
};

/// Reads a file with a world that has been read, and adds the results to the sources.
World expand_world(SourceId root, imports::Context& context);

/// Whether the root element of a text is `<sdf>`. Reads the beginning only.
bool is_sdf(std::string_view text);
/// Whether the first element in it is a `<world>`, too.
bool is_world(std::string_view text);

}  // namespace smurf::sdformat
