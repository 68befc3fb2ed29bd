// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/canonical_paths.hpp"

#include <algorithm>
#include <string_view>

#include "base/files/found_file.hpp"
#include "base/files/open_folder.hpp"
#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/files/system.hpp"

namespace smurf {
namespace {

/// A path without a drive is on the drive of the current folder.
std::string root_of(const std::string& path) {
  return sys::kIgnoresCase && sys::without_drive(path) == path ? places::absolute("/") : "/";
}

std::string inside(const std::string& folder, std::string_view name) {
  return (folder == "/" ? folder : folder + "/") + std::string(name);
}

std::optional<std::string> here() {
  auto place = canonical_now(".");
  return place ? place : places::whole(".");
}

}  // namespace

std::optional<std::string> CanonicalPaths::known(std::string_view path) const {
  const std::lock_guard lock(mutex_);
  const std::string* const found = known_.find(path);
  return found == nullptr ? std::nullopt : std::optional(*found);
}

void CanonicalPaths::remember(const std::string& path, const std::string& canonical) const {
  const std::lock_guard lock(mutex_);
  known_.add(path, canonical);
}

std::optional<std::string> CanonicalPaths::of(const std::string& path) const {
  if (auto found = known(path)) return found;
  auto canonical = looked_at(path);
  if (canonical) remember(path, *canonical);
  return canonical;
}

void CanonicalPaths::saw(const std::string& path, const std::string& place) const {
  const auto here = path::is_absolute(path) ? std::nullopt : of("");
  const bool is_same =
      path::is_absolute(path) ? path == place : here && place == inside(*here, path);
  if (is_same) remember(path, place);
}

/// Remembers parent folders only if their paths are short: the paths of thousands of nested folders
/// would need megabytes.
std::optional<std::string> CanonicalPaths::looked_at(const std::string& path) const {
  constexpr std::size_t kShort = 256;
  if (path.size() > path::kLongest) return std::nullopt;
  const std::string folder(path::parent(path));
  if (!folder.empty() && folder != path && folder != "/" && folder.size() <= kShort) of(folder);
  std::string_view start = path;
  std::optional<std::string> at;
  while (!at && !start.empty() && start != "/") {
    start = path::parent(start);
    at = known(start);
  }
  if (!at) at = start == "/" ? std::optional(root_of(path)) : here();
  if (!at) return std::nullopt;
  if (start.empty()) remember("", *at);
  int links = 0;
  const std::string_view names = std::string_view(path).substr(start.size());
  // The files of one folder come one after the other.
  const std::string_view way = names.substr(0, names.rfind('/') + 1);
  OpenFolder open(*at);
  at = walk(*std::move(at), open, way, links, nullptr);
  if (at && !folder.empty()) remember(folder, *at);
  if (at) at = walk(*std::move(at), open, names.substr(way.size()), links, nullptr);
  if (!at) return places::whole(path);
  // Names as the file system returns them, which may differ from the requested names.
  return sys::kIgnoresCase ? places::weakly_canonical(*at) : at;
}

/// Goes name by name from a canonical folder, which stays open, so that ".." is resolved after the
/// links before it. `link_in` is the folder of the link that is being followed.
std::optional<std::string> CanonicalPaths::walk(std::string at, OpenFolder& folder,
                                                std::string_view names, int& links,
                                                const std::string* link_in) const {
  constexpr int kMostLinks = 40;  // as Linux follows
  const auto may_pass = [&](const std::string& place) {
    return link_in == nullptr || !may_pass_ || may_pass_(*link_in, place);
  };
  while (!names.empty()) {
    const std::size_t end = std::min(names.find('/'), names.size());
    const std::string name(names.substr(0, end));
    names.remove_prefix(std::min(end + 1, names.size()));
    if (name.empty() || name == ".") continue;
    const std::string next = name == ".." ? std::string(path::parent(at)) : inside(at, name);
    if (!may_pass(next)) return next;
    const auto target = name == ".." ? std::nullopt : folder.target_of(name);
    if (target) {
      if (++links > kMostLinks) return std::nullopt;
      if (target->starts_with('/')) folder.open("/");
      auto place = walk(target->starts_with('/') ? "/" : at, folder, *target, links, &at);
      if (!place || !may_pass(*place)) return place;
      at = *std::move(place);
      folder.open(at);
      continue;
    }
    at = next;
    if (name == "..") {
      folder.enter_above(at);
    } else {
      folder.enter(name);
    }
  }
  return at;
}

std::optional<std::string> canonical_now(const std::string& path) {
#ifdef O_PATH
  if (path == ".") {
    if (std::string here = sys::working_folder(); !here.empty()) return here;
  }
  const FoundFile found(path);
  if (found.error() != 0) return std::nullopt;
  if (auto place = found.real_path()) return place;
#endif
  return places::canonical(path);
}

std::string identity(const std::string& path, const CanonicalPaths& paths) {
  return paths.of(path).value_or(path::normalize(path));
}

std::string identity(const std::string& path, const CanonicalPaths& paths,
                     const FileReader& files) {
  return files.is_denied(path) ? path::normalize(path) : identity(path, paths);
}

std::string path_inside(const std::string& path, std::string folder, const CanonicalPaths& paths) {
  const std::string whole = identity(path, paths);
  if (!folder.ends_with('/')) folder += '/';
  return whole.starts_with(folder) ? whole.substr(folder.size()) : std::string();
}

}  // namespace smurf
