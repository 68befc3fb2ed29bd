// SPDX-License-Identifier: BSD-3-Clause
// Which files a check of files and folders loads, with their kinds and configurations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"

namespace smurf {

/// The kind of a file. A resource is a mesh or an image that models refer to. A drawing (.svg) is a
/// scene only when a user names it.
enum class InputKind : std::uint8_t { model, scene, drawing, urdf, annotation, resource, other };

/// Decided by the extension.
InputKind input_kind(std::string_view path);
/// Whether a file is a scene: one of SMURF, a drawing, or a world of SDF.
bool is_scene_file(const std::string& path, const FileReader& files, const Limits& limits);

/// The arguments with which a xacro file is checked, from a configuration.
struct PlannedArguments {
  std::map<std::string, std::string> values;
  std::string shown;  ///< those that have several values: "ur_type:=ur5e"
};

/// A file to check with all files that it loads, and its configuration. Small, because a data set
/// has many thousands of them.
struct PlannedFile {
  std::string path;
  std::uint32_t config = 0;  ///< index into Plan::configs
  /// A xacro file that was found in a folder. It may be a part of a robot; then it has no findings.
  bool may_be_part = false;
  bool is_named = false;   ///< by the user, and not found in a folder
  bool is_helper = false;  ///< a robot that is loaded only for companions
  /// Of a xacro file; set by the session. Null: none.
  std::shared_ptr<const PlannedArguments> arguments = {};
};

/// The files to load, their kinds, and their configurations.
struct Plan {
  std::vector<PlannedFile> scenes;
  std::vector<PlannedFile> models;
  std::vector<PlannedFile> others;  ///< alone, unless a model reads them: .urdf, .yml, SRDFs
  /// Files that are companions of robots if their content says so; they are read with the robots.
  std::vector<PlannedFile> companions;
  std::vector<std::string> configs;   ///< files; "": none. The first is that of the first path.
  std::vector<std::string> problems;  ///< "cannot read 'arm.smurf': No such file or directory"
};

/// What is searched, and how.
struct PlanSettings {
  std::vector<std::string> paths;  ///< files and folders; none: the current folder
  std::string config;              ///< a file; "": the nearest configuration above each file
  bool is_isolated = false;        ///< read no configuration
  bool excludes_named = false;     ///< `exclude` also leaves out files that are named
  bool heeds_ignore_files = true;  ///< .gitignore and .smurf-lintignore
  /// A named annotation file, mesh or xacro file stands for the models and robots that use it; if
  /// there are none, it is ignored, as a hook of pre-commit needs it.
  bool stands_for_users = false;
  std::string given;  ///< one of the paths whose text the caller has, such as standard input
  Limits limits;
  /// Added to the problem of a path that cannot be read.
  std::function<std::string(std::string_view path)> advice;
};

/// The result of make_plan().
struct FoundPlan : Plan {
  std::size_t links = 0;  ///< links that lead out of the folders, which are not followed
};

/// Looks for the files on disk, and reads configurations, ignore files and models through `files`.
/// `tell` gets each problem as it is found.
FoundPlan make_plan(const PlanSettings& settings, const FileReader& files,
                    const std::function<void(const std::string& problem)>& tell = {});

/// Where ROS keeps packages on this machine: ROS_PACKAGE_PATH, then share/ of AMENT_PREFIX_PATH.
std::vector<std::string> ros_package_folders();

/// The reason why a path cannot be checked: "No such file or directory", "is not a regular file".
/// None if it can be read.
std::optional<std::string> why_unreadable(const std::string& path, const FileReader& files);

/// Equal for two spellings of one file; links are resolved. Remembers what it has looked up.
std::string identity(const std::string& path);
/// The same, but a denied path is identified by its name.
std::string identity(const std::string& path, const FileReader& files);

}  // namespace smurf
