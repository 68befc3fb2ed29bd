// SPDX-License-Identifier: BSD-3-Clause
// What a package installs into its share folder, read from CMakeLists.txt or setup.py.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/surroundings.hpp"

namespace smurf {

/// A folder or file of the sources, and where it is in the share folder of the package.
struct InstalledPart {
  std::string from, to;  ///< relative to the package; "" is the whole folder
  bool is_file = false;
  Span span;
};

struct Installation {
  bool is_known = false;  ///< false: parts are computed, and nothing can be said of what is missing
  bool installs_folders = false;
  std::vector<InstalledPart> parts;
  Span place;  ///< of the rule that installs folders

  /// What may be installed at a path of the share folder, relative to the package.
  std::vector<std::string> sources_of(std::string_view installed) const;
  /// Whether a file of the sources is installed somewhere.
  bool has(std::string_view source) const;
};

/// Reads the build file of a package, and appends its faults to those of the package.
Installation read_cmake(std::string_view text, SourceId source, SurroundingPackage& package,
                        const FileReader& files);
Installation read_setup_py(std::string_view text, SourceId source, SurroundingPackage& package,
                           const FileReader& files);

}  // namespace smurf
