// SPDX-License-Identifier: BSD-3-Clause
// Files that still contain a name after it was renamed elsewhere.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/rename.hpp"

namespace smurf::tools {

/// Sentences about files in the packages of the changed files and in those that depend on them.
struct LeftNames {
  /// One for each name: launch files, which are programs, files of RViz and of other programs, and
  /// xacro files of other robots.
  std::vector<std::string> mentions;
  /// Files that no longer fit: SRDFs and parameter files that were not loaded, and robots that were
  /// not loaded and include a changed file.
  std::vector<std::string> misfits;
};

/// The files that a xacro file includes when it is expanded, by identity; none if that fails.
using IncludedBy = std::function<std::optional<std::set<std::string>>(const std::string& path)>;

/// `loaded` are the identities of the files that were loaded, `changed` the paths of those that
/// were changed, `texts` the new texts of surrounding files, by identity.
LeftNames names_left(std::span<const Rename> renames, std::span<const std::string> changed,
                     const std::set<std::string>& loaded, const FileReader& files,
                     const Limits& limits, const IncludedBy& included_by,
                     const std::map<std::string, std::string_view>& texts = {});

}  // namespace smurf::tools
