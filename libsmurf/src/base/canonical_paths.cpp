// SPDX-License-Identifier: BSD-3-Clause
#include "base/canonical_paths.hpp"

#include <sys/stat.h>

#include <filesystem>
#include <string_view>
#include <system_error>

#include "base/path.hpp"

namespace smurf {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> looked_up(const std::string& path) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error) return std::nullopt;
  return canonical.string();
}

/// Can the last part be told from what is above it? Not "..": that is seen from where a link leads.
bool has_name(const std::string& path) {
  const std::string_view name = path::file_name(path);
  return !name.empty() && name != "." && name != "..";
}

bool is_link(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode);
}

}  // namespace

std::optional<std::string> CanonicalPaths::of(const std::string& path) const {
  {
    const std::lock_guard lock(mutex_);
    const auto known = known_.find(path);
    if (known != known_.end()) return known->second;
  }
  auto canonical = looked_at(path);
  const std::lock_guard lock(mutex_);
  if (canonical) known_.emplace(path, *canonical);
  return canonical;
}

std::optional<std::string> CanonicalPaths::looked_at(const std::string& path) const {
  // The way up from a long name is not to use up the stack.
  if (path.size() > path::kLongest) return std::nullopt;
  if (!has_name(path)) return looked_up(path.empty() ? "." : path);
  const auto above = of(std::string(path::parent(path)));
  if (!above) return looked_up(path);
  std::string whole = path::join(*above, path::file_name(path));
  return is_link(whole) ? looked_up(path) : whole;
}

}  // namespace smurf
