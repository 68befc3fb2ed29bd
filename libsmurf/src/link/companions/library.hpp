// SPDX-License-Identifier: BSD-3-Clause
// What files of ROS contain, independent of a robot: read once for all robots of a run.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "link/companions/kinds.hpp"
#include "link/surroundings/launch_files.hpp"
#include "link/surroundings/stated_ties.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// A joint or link that a companion names.
struct CompanionName {
  NameKind kind{};
  std::string name;
};

/// A file that may be a companion.
struct SeenCompanion {
  Recognised what;
  bool is_readable = false;          ///< else it is absent, or too large
  std::string robot;                 ///< of an SRDF: the robot that it names, as written
  std::vector<CompanionName> names;  ///< each once; none of a xacro file
};

/// A companion that a user named, or that is in a folder which is searched: robots that are not
/// related to it by packages may have it, too.
struct NearCompanion {
  std::string path;
  bool is_named = false;
};

/// The names of files in a folder that may be companions or robots.
struct NamesInFolder {
  std::vector<std::string> companions, urdfs, xacros;  ///< an SRDF in xacro is in two of them
  std::string digest;                                  ///< of all names
};

/// What folders have, of which each robot in them asks for it. Several threads may use it.
class CompanionFolders {
 public:
  const NamesInFolder& names_in(const std::string& folder, const FileReader& files);

 private:
  std::mutex mutex_;
  std::map<std::string, NamesInFolder> folders_;  ///< by normal path
};

/// Several threads may use it.
class CompanionLibrary {
 public:
  explicit CompanionLibrary(std::shared_ptr<CompanionFolders> known)
      : folders(known ? std::move(known) : std::make_shared<CompanionFolders>()),
        stated(std::make_shared<StatedTies>()) {}

  const std::shared_ptr<CompanionFolders> folders;
  const std::shared_ptr<StatedTies> stated;
  LaunchLibrary launches;
  std::vector<NearCompanion> near;  ///< set before the first load
  std::set<std::string>
      named_robots;  ///< by identity: those that a user named, set in the same way
  const SeenCompanion& look_at(const std::string& path, const FileReader& files);

 private:
  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<SeenCompanion>> seen_;  ///< by normal path
};

/// Of a key that is written twice, programs of ROS use the last value. `joins`: two mappings are
/// joined, as rcl does with the parameters of a node (rcl_yaml_param_parser parse.c).
void keep_last_keys(yaml::Document& document, bool joins);

/// Replaces values in degrees, `!degrees 90`, by radians, as rosparam and xacro read them.
void convert_degrees(yaml::Document& document, std::string_view text);

/// How well a robot fits the names in a file.
struct NameScore {
  std::size_t known = 0, names = 0;
  std::set<std::string, std::less<>> near;  ///< probably misspelt
  std::string lost_prefix;                  ///< see Companion
};
NameScore score_of(const std::vector<CompanionName>& names, const LinkedModel& model);

/// Whether a robot has enough of the names: a misspelt one counts nearly as much as a known one.
bool is_enough(const NameScore& score);

}  // namespace smurf
