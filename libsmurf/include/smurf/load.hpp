// SPDX-License-Identifier: BSD-3-Clause
// From a path to a linked model or scene.
#pragma once

#include <optional>
#include <string>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/linked.hpp"
#include "smurf/mesh.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf {

/// What loading needs. Owns nothing; all of it must outlive what is loaded.
struct LoadContext {
  SourceMap& sources;
  const FileReader& files;
  DiagnosticSink& sink;
  Limits limits;
  std::map<std::string, std::string> packages;  ///< package:// names to folders
  /// Folders that hold packages: those of ROS_PACKAGE_PATH, and share/ of AMENT_PREFIX_PATH.
  std::vector<std::string> package_folders = {};
  MeshLibrary* meshes = nullptr;         ///< null: meshes are looked up, but not opened
  const UserSchemas* schemas = nullptr;  ///< of the user's own sections and entity types
};

/// Loads a .smurf, a .urdf, or an annotation file alone. Everything wrong is reported; what could
/// be read is returned, with `is_complete` telling whether that is all.
LinkedModel load_model(const std::string& path, LoadContext& context);

/// Loads a .smurfs, a .smurfa or a drawing (.svg) with all scenes and models it names.
LinkedScene load_scene(const std::string& path, LoadContext& context);

/// Reads any XML file, an SRDF for example. None when it is missing or broken; that was reported.
std::optional<xml::Document> load_xml(const std::string& path, LoadContext& context);

}  // namespace smurf
