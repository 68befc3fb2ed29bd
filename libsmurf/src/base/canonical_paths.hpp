// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

namespace smurf {

/// Paths with their symbolic links followed, each looked at once and then remembered: for one run,
/// not for a program that outlives what happens to its files. May be used by several threads.
class CanonicalPaths {
 public:
  /// What does not exist keeps its name, also where a link leads to it; none when it cannot be
  /// told, as in a loop of links.
  std::optional<std::string> of(const std::string& path) const { return of(path, 0); }

 private:
  /// `links` are those that led here.
  std::optional<std::string> of(const std::string& path, int links) const;
  std::optional<std::string> looked_at(const std::string& path, int links) const;

  mutable std::mutex mutex_;
  mutable std::unordered_map<std::string, std::string> known_;
};

}  // namespace smurf
