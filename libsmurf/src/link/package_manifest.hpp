// SPDX-License-Identifier: BSD-3-Clause
// What the package.xml of a ROS package says.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "smurf/file_reader.hpp"

namespace smurf {

inline constexpr std::string_view kPackageFile = "package.xml";

struct PackageManifest {
  bool exists = false;
  std::string name;
  std::set<std::string, std::less<>> dependencies;
  bool is_ament = false;  ///< built as packages of ROS 2 are
};

/// Empty if the text is not XML.
PackageManifest read_manifest(std::string_view text);
/// That of a folder.
PackageManifest manifest_in(const std::string& folder, const FileReader& files);

}  // namespace smurf
