// SPDX-License-Identifier: BSD-3-Clause
// The pairs of links whose contacts an SRDF disables.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/linked.hpp"

namespace smurf {

struct DisabledPairs {
  std::string file;                                     ///< the SRDF; "": none was found
  std::set<std::pair<std::size_t, std::size_t>> pairs;  ///< links, the smaller index first
};

/// Those of the SRDF `given`. If it is "": of the one beside the URDF, or in srdf/ or config/ there
/// or one folder up, that has the name of the robot, and the name of the URDF file if there are
/// several.
DisabledPairs disabled_pairs(const LinkedModel& model, const std::string& given,
                             const FileReader& files, const Limits& limits);

}  // namespace smurf
