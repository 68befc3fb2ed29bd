// SPDX-License-Identifier: BSD-3-Clause
// Addresses of the form package://NAME/REST.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "link/file_index.hpp"
#include "link/package_search.hpp"
#include "smurf/load.hpp"

namespace smurf {

/// How many folders above the URDF are searched for a file. Bullet and Isaac's converter look in
/// all of them (PyBullet 3.2.7 and urdf-usd-converter 0.3.4, run with ten).
constexpr std::size_t kFoldersAbove = 7;

class Packages {
 public:
  Packages(LoadContext& context, const LinkedModel& model, FileIndex& index);

  struct Place {
    std::string path;       ///< empty if the package is unknown
    bool is_given = false;  ///< the caller named the folder
    /// Whether the file was found in a folder above the URDF that does not have the name.
    bool is_guess = false;
    std::string package{};  ///< then the name in that folder's package.xml
    /// Whether neither the folder of the URDF nor one of kFoldersAbove has a file NAME/REST.
    bool is_elsewhere = false;
  };
  /// The file for NAME/REST. It is looked up in the folder given for the package; then in the
  /// nearest parent folder that is called NAME, that contains REST (Phobos uses the parent of
  /// urdf/, whatever its name), or whose package.xml has this name; then in the folders that
  /// contain packages. Of a xacro file, whose `$(find NAME)` finds them as well, it is also looked
  /// up in the packages beside it. If it is nowhere, the place where the folder of REST is in a
  /// folder NAME.
  Place find(const std::string& name_and_rest);

  /// package://NAME/REST of a file below the nearest package.xml above the URDF; "" for others.
  std::string address_of(const std::string& path);

 private:
  Place search(const std::string& name_and_rest);
  bool lies_elsewhere(const Place& place, const std::string& name_and_rest);
  bool is_called(const std::string& folder, const std::string& name);
  bool is_in_package();
  /// The package of this name in the folders that contain packages; empty if there is none.
  std::string installed(const std::string& name);
  /// The name in a folder's package.xml; empty if there is none.
  const std::string& package_name(const std::string& folder);

  LoadContext& context_;
  FileIndex& index_;
  std::string urdf_path_;
  bool is_xacro_;
  std::vector<std::string> folders_;            ///< the URDF's folder and its parents
  std::map<std::string, std::string> guessed_;  ///< by name: the folder in which a file was found
  /// The packages in the folders that contain packages, by name; earlier folders take precedence.
  /// Made at the first request.
  std::optional<std::map<std::string, std::vector<std::string>>> installed_;
};

}  // namespace smurf
