// SPDX-License-Identifier: BSD-3-Clause
// From a path to a linked model or scene.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/linked.hpp"
#include "smurf/mesh.hpp"
#include "smurf/user_schemas.hpp"
#include "smurf/xacro.hpp"

namespace smurf {

/// Remembers files, to limit repeated reading: thousands of models may share one large
/// URDF, and each keeps a copy.
struct ReadFiles {
  std::set<std::string> known;  ///< by identity
  std::uint64_t repeated = 0;   ///< bytes
  /// Names in the folders of models, sorted: thousands of models may lie in one.
  std::map<std::string, std::vector<std::string>> lists = {};
};

class ParsedFiles;
class PackageSearch;

/// What a user decides about xacro files.
struct XacroSettings {
  std::map<std::string, std::string> arguments;  ///< `name:=value`
  std::set<std::string> environment;             ///< variables that `$(env ...)` may read
  bool needs_origins = true;  ///< false: nobody asks where the parts of the result come from
  friend bool operator==(const XacroSettings&, const XacroSettings&) = default;
};

/// Files that a user names as companions of a robot.
struct CompanionTie {
  std::string robot;
  std::vector<std::string> files;
};

/// The input of loading. All of it must outlive the result.
struct LoadContext {
  SourceMap& sources;
  const FileReader& files;
  DiagnosticSink& sink;
  Limits limits;
  std::map<std::string, std::string> packages;  ///< package:// names to folders
  /// Folders that contain packages: those of ROS_PACKAGE_PATH, and share/ of AMENT_PREFIX_PATH.
  std::vector<std::string> package_folders = {};
  MeshLibrary* meshes = nullptr;         ///< null: mesh files are looked up, but not opened
  const UserSchemas* schemas = nullptr;  ///< for custom sections and entity types
  /// Shared by all models in memory at the same time.
  std::shared_ptr<ReadFiles> read = std::make_shared<ReadFiles>();
  ParsedFiles* parsed = nullptr;  ///< results of an earlier load; may be null
  XacroSettings xacro = {};
  /// Of the xacro files that were loaded, for their findings.
  std::shared_ptr<xacro::Expansions> expansions = std::make_shared<xacro::Expansions>();
  std::vector<CompanionTie> ties = {};
  /// Finds ROS packages. Loads may share it while no file changes; null: made at the first search.
  std::shared_ptr<PackageSearch> package_search = nullptr;
};

/// Loads a .smurf, a .urdf, or an annotation file alone. Reports all mistakes and returns
/// everything readable; `is_complete` is false when something is missing.
LinkedModel load_model(const std::string& path, LoadContext& context);

/// Loads a .smurfs, a .smurfa or a drawing (.svg) with all scenes and models it names.
LinkedScene load_scene(const std::string& path, LoadContext& context);

/// Reads and expands a xacro file. Reports why that is not possible.
xacro::Expansion load_xacro(const std::string& path, LoadContext& context);

/// Reads any XML file, for example an SRDF. Reports a missing or broken file and returns none.
std::optional<xml::Document> load_xml(const std::string& path, LoadContext& context);

}  // namespace smurf
