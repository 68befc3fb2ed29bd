// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "smurf/file_reader.hpp"

namespace smurf {

class OpenFolder;

/// Paths with their symbolic links followed, each looked at once and then remembered: for one run,
/// not for a program that outlives what happens to its files. May be used by several threads.
class CanonicalPaths {
 public:
  /// Whether a link that lies in `folder` may go through a place; both are canonical, but for the
  /// last name of the place, which may be a link. One that may not leads there and no further.
  using MayPass = std::function<bool(const std::string& folder, const std::string& place)>;
  explicit CanonicalPaths(MayPass may_pass = {}) : may_pass_(std::move(may_pass)) {}

  /// What does not exist keeps its name, also where a link leads to it; none when it cannot be
  /// told, as in a loop of links.
  std::optional<std::string> of(const std::string& path) const;

 private:
  std::optional<std::string> known(std::string_view path) const;
  void remember(const std::string& path, const std::string& canonical) const;
  std::optional<std::string> looked_at(const std::string& path) const;
  std::optional<std::string> walk(std::string at, OpenFolder& folder, std::string_view names,
                                  int& links, const std::string* link_in) const;

  MayPass may_pass_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::string, std::less<>> known_;
};

/// A path that exists, with its links followed, looked at anew: with one walk of the system, where
/// it can say so, and not one for each part. None when nothing is there.
std::optional<std::string> canonical_now(const std::string& path);

/// Equal for two spellings of one file; links are resolved.
std::string identity(const std::string& path, const CanonicalPaths& paths);

/// The same, but a denied path has the identity of its name, so that it does not show where it
/// leads.
std::string identity(const std::string& path, const CanonicalPaths& paths, const FileReader& files);

/// `path` as seen from `folder`, which is an identity; "" when it lies elsewhere.
std::string path_inside(const std::string& path, std::string folder, const CanonicalPaths& paths);

}  // namespace smurf
