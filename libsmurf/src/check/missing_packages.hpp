// SPDX-License-Identifier: BSD-3-Clause
// Packages that robots of a run need, and that are not here.
#pragma once

#include <vector>

#include "check/pipeline.hpp"

namespace smurf {

/// Leaves one finding for each package, and says how to get it. A package that the package.xml of
/// the robot names is only a warning: it is on other machines.
void join_missing_packages(std::vector<Judged>& found, const SourceMap& sources,
                           const FileReader& files);

}  // namespace smurf
