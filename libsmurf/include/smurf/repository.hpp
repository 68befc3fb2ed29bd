// SPDX-License-Identifier: BSD-3-Clause
// Where files are in their repository.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "smurf/render.hpp"

namespace smurf {

/// Where a repository keeps its history, and with it tokens and the addresses of servers.
inline constexpr std::array<std::string_view, 3> kHistories = {".git", ".hg", ".svn"};

/// Paths from the top of the repository, sought from the current folder upward; from the current
/// folder when there is none. Links are resolved, as code hosts know no file by two names.
RepositoryPath in_repository();

/// Where a path leads.
struct FollowedPath {
  /// The first symbolic link on the way that lies in a repository and leads out of it, or to what
  /// git keeps of it: it may have come with a pull request. "" when there is none.
  std::string link_out;
  std::string place;  ///< without links; what does not exist is as it is written
};
/// Looks at each part of the path once, so that `place` is what was judged.
FollowedPath follow(const std::string& path);
/// FollowedPath::link_out.
std::string link_out_of_repository(const std::string& path);

}  // namespace smurf
