// SPDX-License-Identifier: BSD-3-Clause
#include "base/canonical_paths.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
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

/// Where a link leads, as it is written; none when this is no link.
std::optional<std::string> target_of(const std::string& path) {
  std::array<char, path::kLongest> target;
  const ssize_t size = ::readlink(path.c_str(), target.data(), target.size());
  if (size < 0) return std::nullopt;
  return std::string(target.data(), static_cast<std::size_t>(size));
}

}  // namespace

std::optional<std::string> CanonicalPaths::of(const std::string& path, int links) const {
  {
    const std::lock_guard lock(mutex_);
    const auto known = known_.find(path);
    if (known != known_.end()) return known->second;
  }
  auto canonical = looked_at(path, links);
  const std::lock_guard lock(mutex_);
  if (canonical) known_.emplace(path, *canonical);
  return canonical;
}

std::optional<std::string> CanonicalPaths::looked_at(const std::string& path, int links) const {
  constexpr int kMostLinks = 40;  // as Linux follows
  // The way up from a long name is not to use up the stack.
  if (path.size() > path::kLongest || links > kMostLinks) return std::nullopt;
  if (!has_name(path)) return looked_up(path.empty() ? "." : path);
  const auto above = of(std::string(path::parent(path)), links);
  if (!above) return looked_up(path);
  std::string whole = path::join(*above, path::file_name(path));
  const auto target = target_of(whole);
  if (!target) return whole;
  return follow(*above, *target, links + 1);
}

/// Name by name: what ".." means is seen from where the links before it lead.
std::optional<std::string> CanonicalPaths::follow(const std::string& folder,
                                                  const std::string& target, int links) const {
  const auto may_pass = [&](const std::string& place) {
    return !may_pass_ || may_pass_(folder, place);
  };
  std::string at = target.starts_with('/') ? "/" : folder;
  for (std::string_view rest = target; !rest.empty();) {
    const std::size_t end = std::min(rest.find('/'), rest.size());
    const std::string_view name = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (name.empty() || name == ".") continue;
    const std::string next = path::join(at, name);
    if (!may_pass(next)) return next;
    auto place = name == ".." ? next : of(next, links);
    if (!place || !may_pass(*place)) return place;
    at = *std::move(place);
  }
  return at;
}

std::optional<std::string> canonical_now(const std::string& path) {
  std::error_code error;
#ifdef O_PATH
  const int opened = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (opened < 0) return std::nullopt;
  const fs::path place = fs::read_symlink("/proc/self/fd/" + std::to_string(opened), error);
  ::close(opened);
  if (!error && place.is_absolute()) return place.string();
#endif
  const fs::path canonical = fs::canonical(path, error);
  return error ? std::nullopt : std::optional(canonical.string());
}

std::string identity(const std::string& path, const CanonicalPaths& paths) {
  return paths.of(path).value_or(path::normalize(path));
}

std::string path_inside(const std::string& path, std::string folder, const CanonicalPaths& paths) {
  const std::string whole = identity(path, paths);
  if (!folder.ends_with('/')) folder += '/';
  return whole.starts_with(folder) ? whole.substr(folder.size()) : std::string();
}

}  // namespace smurf
