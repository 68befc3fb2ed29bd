// SPDX-License-Identifier: BSD-3-Clause
// Finds the models to which a file belongs.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"

namespace smurf {

/// Finds the models around files, and reads each of them once. Ignores files above the limit for
/// such searches (docs/limits.md).
class ModelsAround {
 public:
  explicit ModelsAround(const FileReader& files) : files_(files) {}

  /// The .smurf files that list a file, in its folder, the parent folder, and the `smurf` folders
  /// in both; sorted.
  std::vector<std::string> listing(const std::string& path);

  /// The .smurf files, and the .urdf files that none of them lists, whose meshes or textures
  /// include a file; in its three nearest folders and the `smurf` and `urdf` folders there;
  /// sorted.
  std::vector<std::string> using_resource(const std::string& path);

  /// Whether there were too many files to read all of them.
  bool is_exhausted() const { return bytes_ > kMost; }

 private:
  /// A model that uses a file. All identities are results of identity().
  struct User {
    std::string path, identity;
    std::string urdf;  ///< identity
    bool is_model = false;
  };
  /// The models that use each file, by its identity.
  using Users = std::map<std::string, std::vector<User>>;

  const Users& listing_in(const std::string& folder);
  const Users& using_in(const std::string& folder);

  static constexpr std::uint64_t kMost = 64'000'000;  // bytes, a second

  const FileReader& files_;
  std::uint64_t bytes_ = 0;                       ///< bytes of all files looked at
  std::map<std::string, Users> listing_, using_;  ///< by the folder that contains the models
};

}  // namespace smurf
