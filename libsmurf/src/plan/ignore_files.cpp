// SPDX-License-Identifier: BSD-3-Clause
#include "plan/ignore_files.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "base/files/places.hpp"

namespace smurf {
namespace {

constexpr std::uint64_t kMostBytes = 1U << 20U;

/// The path relative to a folder that contains it. "" is the folder where relative paths start.
std::string_view below(std::string_view path, std::string_view folder) {
  if (folder.empty()) return path;
  return path.substr(folder == "/" ? 1 : folder.size() + 1);
}

}  // namespace

const IgnoreFiles::Level& IgnoreFiles::level_of(const std::string& folder) {
  const auto [place, is_new] = levels_.try_emplace(folder);
  Level& level = place->second;
  if (!is_new) return level;
  level.folder = folder;
  const std::string above(path::parent(folder));
  if (above != folder) level.above = &level_of(above);
  level.is_repository = places::has_entry(path::join(folder, ".git"));
  level.is_in_repository =
      level.is_repository || (level.above != nullptr && level.above->is_in_repository);
  const auto read = [&](std::string_view name) {
    const std::string path = path::join(folder, name);
    return files_.is_file(path) ? files_.read(path, kMostBytes).text : std::string();
  };
  if (level.is_repository) level.of_git.add_lines(read(".git/info/exclude"));
  if (level.is_in_repository) level.of_git.add_lines(read(".gitignore"));
  level.of_lint.add_lines(read(".smurf-lintignore"));
  return level;
}

const IgnoreFiles::Level& IgnoreFiles::level_around(const std::string& path) {
  constexpr std::size_t kMostLevels = 4'096;  // a data set has a folder for each robot
  if (levels_.size() > kMostLevels) levels_.clear();
  return level_of(std::string(path::parent(path)));
}

bool IgnoreFiles::may_check(std::size_t patterns) {
  is_exhausted_ = is_exhausted_ || patterns > checks_left_;
  if (!is_exhausted_) checks_left_ -= patterns;
  return !is_exhausted_;
}

PathVerdict IgnoreFiles::judge(const PathPatterns& patterns, std::string_view path,
                               bool is_folder) {
  std::uint64_t steps = 0;
  const PathVerdict verdict = patterns.judge(path, is_folder, &steps);
  count(steps);
  return verdict;
}

bool IgnoreFiles::excludes(const PathPatterns& patterns, std::string_view file) {
  std::uint64_t steps = 0;
  const bool is_excluded = patterns.excludes(file, &steps);
  count(steps);
  return is_excluded;
}

void IgnoreFiles::count(std::uint64_t steps) {
  checks_left_ -= std::min(checks_left_, steps / PathPatterns::kStepsOfCheck);
}

PathVerdict IgnoreFiles::lint_verdict(const std::string& path, bool is_folder) {
  for (const Level* level = &level_around(path); level != nullptr; level = level->above) {
    if (!may_check(level->of_lint.size())) return PathVerdict::excluded;
    const PathVerdict verdict = judge(level->of_lint, below(path, level->folder), is_folder);
    if (verdict != PathVerdict::unmentioned) return verdict;
  }
  return PathVerdict::unmentioned;
}

bool IgnoreFiles::leaves_out(const std::string& path, bool is_folder) {
  const PathVerdict of_lint = lint_verdict(path, is_folder);
  if (of_lint != PathVerdict::unmentioned) return of_lint == PathVerdict::excluded;
  for (const Level* level = &level_around(path); level != nullptr; level = level->above) {
    if (!may_check(level->of_git.size())) return true;
    const PathVerdict verdict = judge(level->of_git, below(path, level->folder), is_folder);
    if (verdict != PathVerdict::unmentioned) return verdict == PathVerdict::excluded;
    if (level->is_repository) break;
  }
  return false;
}

bool IgnoreFiles::leaves_out_with_folders(const std::string& path) {
  // As in git, what is ignored outside of the innermost repository does not reach into it.
  std::size_t repository = 0;
  for (const Level* level = &level_around(path); level != nullptr; level = level->above) {
    if (level->is_repository) {
      repository = level->folder.size();
      break;
    }
  }
  for (std::size_t slash = path.find('/', 1); slash != std::string::npos;
       slash = path.find('/', slash + 1)) {
    const std::string folder = path.substr(0, slash);
    if (slash > repository ? leaves_out(folder, true)
                           : lint_verdict(folder, true) == PathVerdict::excluded)
      return true;
  }
  return leaves_out(path, false);
}

}  // namespace smurf
