// SPDX-License-Identifier: BSD-3-Clause
// What the package.xml of a ROS package says.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "smurf/file_reader.hpp"
#include "smurf/source.hpp"
#include "smurf/xml.hpp"

namespace smurf {

inline constexpr std::string_view kPackageFile = "package.xml";

struct PackageManifest {
  bool exists = false;
  std::string name;
  std::map<std::string, Span, std::less<>> dependencies;  ///< where they are first named
  bool is_ament = false;                                  ///< built as packages of ROS 2 are
  bool has_model_path = false;                            ///< exports a path of models to Gazebo
  Span name_span, root_span, export_span;
};

/// Empty if the document is not a package.xml.
PackageManifest read_manifest(const xml::Document& document);
/// Empty if the text is not XML.
PackageManifest read_manifest(std::string_view text);
/// That of a folder.
PackageManifest manifest_in(const std::string& folder, const FileReader& files);

}  // namespace smurf
