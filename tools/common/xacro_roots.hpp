// SPDX-License-Identifier: BSD-3-Clause
// Which xacro files of a folder may be robots, and which are parts of others.
#pragma once

#include <string>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"

namespace smurf::tools {

/// The files that no other of them includes, in the same order. The text decides, so an include
/// with an expression in its path may mean any file that fits.
std::vector<std::string> xacro_roots(const std::vector<std::string>& files,
                                     const FileReader& reader, const Limits& limits);

}  // namespace smurf::tools
