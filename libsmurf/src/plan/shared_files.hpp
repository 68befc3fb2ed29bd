// SPDX-License-Identifier: BSD-3-Clause
// Files around several robots that have the same name: whose name they mean is not known.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/references.hpp"
#include "smurf/rename.hpp"
#include "smurf/source.hpp"

namespace smurf {

struct SharedFiles {
  std::set<std::string> paths;
  /// Why a rename must not change them; none for a file that only remembers the names.
  std::vector<std::string> problems;
};

/// The surrounding files that name what is renamed, and that belong to another robot with a thing
/// of this name as well, whether it was loaded or not. `loaded` are the names of each loaded robot;
/// `is_loaded` says whether a file is one of them.
SharedFiles shared_files(std::span<const std::vector<Reference>> loaded,
                         std::span<const Rename> renames, const SourceMap& sources,
                         const FileReader& files,
                         const std::function<bool(const std::string& path)>& is_loaded);

}  // namespace smurf
