// SPDX-License-Identifier: BSD-3-Clause
// ROS packages around a file, by the names in their package.xml.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "smurf/load.hpp"

namespace smurf {

class PackageSearch {
 public:
  explicit PackageSearch(const LoadContext& context) : context_(context) {}

  /// The folder of a package: the one that was given for it; then the one nearest to the file at
  /// `near`, as far as files may be read; then one in the folders that contain packages.
  std::optional<std::string> find(const std::string& name, const std::string& near);

 private:
  using Packages = std::map<std::string, std::vector<std::string>>;

  /// The packages in a folder and all its subfolders.
  const Packages& packages_in(const std::string& folder);
  void search(const std::string& folder, int depth, Packages& found);
  static std::optional<std::string> best(const Packages& packages, const std::string& name);

  const LoadContext& context_;
  std::map<std::string, Packages> known_;
  std::uint64_t entries_ = 0;
};

}  // namespace smurf
