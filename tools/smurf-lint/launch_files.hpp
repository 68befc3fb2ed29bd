// SPDX-License-Identifier: BSD-3-Clause
// Launch and xacro files that still contain a name after it was renamed elsewhere.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/rename.hpp"

namespace smurf::tools {

/// Sentences about launch and xacro files in the packages of the changed files. Launch files are
/// programs, and xacro files may belong to robots that were not loaded, so they are searched for
/// the names in quotes, and not changed.
std::vector<std::string> launch_files_with(std::span<const Rename> renames,
                                           std::span<const std::string> changed,
                                           const FileReader& files);

}  // namespace smurf::tools
