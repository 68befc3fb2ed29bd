// SPDX-License-Identifier: BSD-3-Clause
// The robots to which a companion may belong that a user named without them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "link/companions/library.hpp"
#include "link/package_search.hpp"
#include "plan/xacro_files.hpp"
#include "smurf/limits.hpp"
#include "smurf/load.hpp"

namespace smurf {

/// Looks into each project once.
class CompanionRobots {
 public:
  enum class Scope : std::uint8_t {
    project,
    packages,  ///< only the package of a file, and those related to it
  };
  CompanionRobots(const FileReader& files, const Limits& limits, Scope scope = Scope::project)
      : files_(files), limits_(limits), scope_(scope), packages_(files) {}

  /// The robots of the configuration; else, of the robots of the project, the likeliest first, at
  /// most six: those in the package of the file, in packages that it depends on or that depend on
  /// it, then others; of these, those that write most of its names.
  std::vector<std::string> of(const std::string& path, const SeenCompanion& seen,
                              std::span<const CompanionTie> ties);

  /// All robots around a file.
  const std::vector<std::string>& in_project(const std::string& path) {
    return project_of(path).robots;
  }

  /// The first robot in the package of a file, or in one that is related to it; "" if there is
  /// none.
  std::string near(const std::string& path);

  /// The text of a robot that of() found for this companion, with what it includes.
  const std::string& text_of(const std::string& companion, const std::string& robot);
  /// Whether the name occurs in the text of any robot in the project of the companion.
  bool is_written(const std::string& companion, std::string_view name);

 private:
  struct Project {
    std::vector<std::string> robots;
    std::optional<XacroFiles> xacro;
  };
  const Project& project_of(const std::string& path);
  /// Of the folders around a file, by identity: 0 in its package, 1 in related ones.
  std::map<std::string, std::size_t> ranks_around(const std::string& path);
  const std::string& text_of(const Project& project, const std::string& robot);
  std::size_t count_in(const Project& project, const std::string& robot, const SeenCompanion& seen);

  const FileReader& files_;
  const Limits& limits_;
  Scope scope_;
  PackageSearch packages_;
  std::map<std::string, Project> projects_;
  std::map<std::string, std::string> texts_;  ///< of robots, with what they include
};

}  // namespace smurf
