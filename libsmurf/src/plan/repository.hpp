// SPDX-License-Identifier: BSD-3-Clause
// Finds the paths of files in their repository.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "smurf/render.hpp"

namespace smurf {

/// Folders with the history of a repository, and with tokens and addresses of servers.
inline constexpr std::array<std::string_view, 3> kHistories = {".git", ".hg", ".svn"};

/// Makes paths relative to the top of the repository around the current folder; without one, to the
/// current folder. Resolves links, because code hosts know each file by one name.
RepositoryPath in_repository();

/// The target of a path.
struct FollowedPath {
  /// The first symbolic link in the path that lies in a repository and leads out of it, or into its
  /// git data: it may have come with a pull request. "" if there is none.
  std::string link_out;
  std::string place;  ///< without links; parts that do not exist are unchanged
};
/// Looks at each part of the path once, so `place` is the judged path.
FollowedPath follow(const std::string& path);
/// FollowedPath::link_out.
std::string link_out_of_repository(const std::string& path);

}  // namespace smurf
