// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/recent_map.hpp"
#include "smurf/file_reader.hpp"

namespace smurf {

class OpenFolder;

/// Resolves symbolic links in paths. What was looked up is remembered, so use it for one run only;
/// of many thousands of paths, only the last ones are. Several threads may use it.
class CanonicalPaths {
 public:
  /// Whether a link in `folder` may lead through a place. Both paths are canonical, but the last
  /// name of the place may be a link. If it may not, the link is followed only to this place.
  using MayPass = std::function<bool(const std::string& folder, const std::string& place)>;
  explicit CanonicalPaths(MayPass may_pass = {}) : may_pass_(std::move(may_pass)) {}

  /// The canonical path. Parts that do not exist keep their names, even after a link. None if it is
  /// unknown, as in a loop of links.
  std::optional<std::string> of(const std::string& path) const;
  /// Tells where an open file lies. If all names of the path are those of the place, nothing on the
  /// way was a link, and the path need not be looked up.
  void saw(const std::string& path, const std::string& place) const;

 private:
  std::optional<std::string> known(std::string_view path) const;
  void remember(const std::string& path, const std::string& canonical) const;
  std::optional<std::string> looked_at(const std::string& path) const;
  std::optional<std::string> walk(std::string at, OpenFolder& folder, std::string_view names,
                                  int& links, const std::string* link_in) const;

  MayPass may_pass_;
  mutable std::mutex mutex_;
  mutable RecentMap<std::string> known_;
};

/// The canonical path of an existing path, without remembered results. Where the system supports
/// it, this is one call instead of one per part. None if the path does not exist.
std::optional<std::string> canonical_now(const std::string& path);

/// Equal for two spellings of one file; links are resolved.
std::string identity(const std::string& path, const CanonicalPaths& paths);

/// The same, but a denied path is identified by its name, so its target is not
/// revealed.
std::string identity(const std::string& path, const CanonicalPaths& paths, const FileReader& files);

/// The path of `path` relative to `folder`, which is an identity; "" if it is elsewhere.
std::string path_inside(const std::string& path, std::string folder, const CanonicalPaths& paths);

}  // namespace smurf
