// SPDX-License-Identifier: BSD-3-Clause
#include "plan/paths.hpp"

#include <cstdlib>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/files/system.hpp"

namespace smurf {
namespace {

/// The entries of a list such as PATH, each followed by `suffix`.
void append_entries(const char* variable, std::string_view suffix, std::vector<std::string>& to) {
  const char* value = std::getenv(variable);
  std::string_view rest = value == nullptr ? "" : value;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(sys::kListSeparator), rest.size());
    if (end > 0) to.push_back(path::join(sys::from_user(rest.substr(0, end)), suffix));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

}  // namespace

std::vector<std::string> ros_package_folders() {
  std::vector<std::string> folders;
  append_entries("ROS_PACKAGE_PATH", ".", folders);
  append_entries("AMENT_PREFIX_PATH", "share", folders);
  return folders;
}

std::optional<std::string> why_unreadable(const std::string& path, const FileReader& files) {
  // Does not read the content. A file that is too large is a finding later, because other readers
  // may load it.
  const FileContent content = files.read(path, 0);
  if (content.status == ReadStatus::ok || content.status == ReadStatus::too_large) {
    return std::nullopt;
  }
  // The same for what is missing and for what lies outside, whose existence is nobody's concern.
  const bool is_hidden =
      content.status == ReadStatus::denied || content.status == ReadStatus::not_found;
  if (places::is_link(path) && is_hidden) {
    return "is a link to a file that is missing, or lies outside of the project";
  }
  return content.reason;
}

const CanonicalPaths& canonical_paths() {
  static const CanonicalPaths paths;
  return paths;
}

std::string identity(const std::string& path) { return smurf::identity(path, canonical_paths()); }

std::string identity(const std::string& path, const FileReader& files) {
  return smurf::identity(path, canonical_paths(), files);
}

}  // namespace smurf
