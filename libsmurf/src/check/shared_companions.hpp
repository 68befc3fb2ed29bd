// SPDX-License-Identifier: BSD-3-Clause
// Findings in files that belong to several robots, such as the variants of one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "smurf/companions.hpp"
#include "smurf/config.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/load.hpp"

namespace smurf {

/// How well a companion fits a robot: the number of its names that the robot has, doubled, and one
/// more for a robot with hardware of ros2_control.
struct CompanionFit {
  CompanionKind kind{};
  std::size_t rank = 0;
  bool is_whole = false;  ///< the robot has all of its names
};
CompanionFit fit_of(const Companion& companion, const LinkedModel& model);

/// Leaves only companions that are certainly of a robot that no user named: those of which it has
/// nearly all names, those that the configuration or a plugin of the robot names, and files of
/// MoveIt without joints beside an SRDF that is left.
void keep_certain(Companions& companions, const LoadContext& context);

/// Loads a robot with its companions, or a companion with its robot. `was_found`: a search found
/// the file, and no user named it. Such a xacro file may expand to other joints and links than its
/// companions are written for, so it keeps a companion only if it has nearly all names in it.
/// `xacro`: the xacro files and arguments that the configuration states.
Accompanied load_robot(const std::string& path, bool was_found, std::span<const ConfigXacro> xacro,
                       LoadContext& context);

/// Collects the findings in companions. A companion is judged with the robots that it fits best; a
/// finding that only some of them have is about a variant that the file is not for.
class SharedCompanions {
 public:
  /// Takes the findings in these companions, by identity, out of those of one robot.
  /// `file_of` returns the identity of the file of a finding.
  template <class FileOf>
  void take(const std::map<std::string, CompanionFit>& companions, std::size_t config,
            const FileOf& file_of, std::vector<Diagnostic>& found) {
    std::set<Key> seen;
    std::vector<Diagnostic> others;
    for (Diagnostic& one : found) {
      const std::string file = companions.empty() ? std::string() : file_of(one);
      const auto companion = companions.find(file);
      if (companion == companions.end()) {
        others.push_back(std::move(one));
      } else {
        const Key key{file, one.rule, one.span.begin, one.span.end};
        add(key, companion->second.rank, seen.insert(key).second, {config, std::move(one)});
      }
    }
    for (const auto& [file, fit] : companions) note(file, fit.rank);
    found = std::move(others);
  }

  struct Found {
    std::size_t config = 0;
    Diagnostic diagnostic;
  };
  /// The findings that all robots have which the file fits best, each once.
  std::vector<Found> finish();

 private:
  struct Key {
    std::string file;
    const Rule* rule = nullptr;
    std::uint32_t begin = 0, end = 0;
    bool operator<(const Key& other) const {  // texts have no <=> in libc++ 14
      return std::tie(file, rule, begin, end) <
             std::tie(other.file, other.rule, other.begin, other.end);
    }
  };
  struct Entry {
    std::size_t rank = 0, robots = 0;
    std::vector<Found> found;  ///< of the first robot of this rank
  };
  struct Best {
    std::size_t rank = 0, robots = 0;
  };

  void add(const Key& key, std::size_t rank, bool is_first, Found found);
  void note(const std::string& file, std::size_t rank);

  std::map<Key, Entry> entries_;
  std::map<std::string, Best> best_;  ///< by file
};

}  // namespace smurf
