// SPDX-License-Identifier: BSD-3-Clause
// Which XML files are robots or worlds in MJCF or SDF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"

namespace smurf {

/// Those of some files that are, without the parts of MJCF that others of them include; in the same
/// order.
std::vector<std::string> imported_robots(const std::vector<std::string>& files,
                                         const FileReader& reader, const Limits& limits);

}  // namespace smurf
