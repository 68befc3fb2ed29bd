// SPDX-License-Identifier: BSD-3-Clause
// Addresses of the form package://NAME/REST.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "link/file_index.hpp"
#include "smurf/load.hpp"

namespace smurf {

class Packages {
 public:
  Packages(const LoadContext& context, std::string_view urdf_folder, FileIndex& index);

  /// The file that NAME/REST means: in the folder given for the package; else in the nearest
  /// folder upward that is called NAME, that holds REST itself (Phobos takes the parent of the
  /// urdf/ folder, whatever its name) or whose package.xml says NAME; else in the folders that hold
  /// packages. Empty when the package is unknown.
  std::string find(const std::string& name_and_rest);

 private:
  /// The package of this name in the folders that hold packages; empty when there is none.
  std::string installed(const std::string& name);
  /// The name in a folder's package.xml, empty when it has none.
  const std::string& package_name(const std::string& folder);

  const LoadContext& context_;
  FileIndex& index_;
  std::vector<std::string> folders_;  ///< the URDF's and those above it
  std::map<std::string, std::string> names_;
  /// The packages in the folders that contain packages, by name; earlier folders take precedence.
  /// Made when it is first asked for.
  std::optional<std::map<std::string, std::vector<std::string>>> installed_;
};

}  // namespace smurf
