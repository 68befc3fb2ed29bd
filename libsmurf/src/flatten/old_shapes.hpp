// SPDX-License-Identifier: BSD-3-Clause
// The contents of MARS scenes from before SMURF.
#pragma once

#include <string>
#include <vector>

#include "smurf/flatten.hpp"
#include "smurf/old_scene.hpp"

namespace smurf {

struct OldSceneContent {
  std::vector<FlatShape> shapes;  ///< mesh files as MARS finds them
  FlatOldScene rest;
};

/// The nodes of an old scene, seen from the entity that names it: a named entity moves the node of
/// index 1, and all others with it (MARS SMURFLoader.cpp:337-349).
OldSceneContent old_scene_content(const OldSceneFile& file, const Instance& instance);

}  // namespace smurf
