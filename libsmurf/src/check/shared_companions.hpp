// SPDX-License-Identifier: BSD-3-Clause
// Findings in companions, which several robots may claim.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plan/ownership.hpp"
#include "smurf/config.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/load.hpp"

namespace smurf {

/// Loads a robot with its companions, or a companion with its robot. `xacro` are the robots of the
/// configuration.
Accompanied load_robot(const std::string& path, bool was_found, std::span<const ConfigXacro> xacro,
                       LoadContext& context);

/// Collects the findings in companions by robot, and gives back those of the robots that they
/// belong to.
class CompanionFindings {
 public:
  struct Found {
    std::size_t config = 0;
    Diagnostic diagnostic;
  };

  /// Takes the findings in these companions, by identity, out of those of one robot. `is_variant`:
  /// it is one of several that a configuration lists, which are all meant. `file_of` returns the
  /// identity of the file of a finding.
  template <class FileOf>
  void take(const std::map<std::string, Claim>& claims, const std::string& robot,
            std::size_t config, bool is_variant, const FileOf& file_of,
            std::vector<Diagnostic>& found) {
    std::map<std::string, std::size_t> by_file;
    for (const auto& [file, claim] : claims) {
      Entry& entry = files_[file];
      by_file.emplace(file, entry.claims.size());
      entry.claims.push_back(claim);
      entry.robots.push_back({robot, config, is_variant, {}});
    }
    std::vector<Diagnostic> others;
    for (Diagnostic& one : found) {
      const std::string file = claims.empty() ? std::string() : file_of(one);
      const auto of_file = by_file.find(file);
      if (of_file == by_file.end()) {
        others.push_back(std::move(one));
      } else {
        files_[file].robots[of_file->second].found.push_back(std::move(one));
      }
    }
    found = std::move(others);
  }

  /// A finding about a name counts where no robot of a file has the name; another one that only
  /// some of them have is an info, which names them.
  std::vector<Found> finish();

  /// After finish(): whether a companion, by identity, belongs to a robot, by path.
  bool belongs_to(const std::string& file, const std::string& robot) const {
    return owners_.contains({file, robot});
  }

 private:
  struct OfRobot {
    std::string robot;
    std::size_t config = 0;
    bool is_variant = false;
    std::vector<Diagnostic> found;
  };
  struct Entry {
    std::vector<Claim> claims;
    std::vector<OfRobot> robots;  ///< in the same order
  };
  std::map<std::string, Entry> files_;  ///< by identity
  std::set<std::pair<std::string, std::string>> owners_;
};

}  // namespace smurf
