// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "base/files/windows_paths.hpp"

namespace smurf::places {
namespace {

Entry kind_of(const sys::Status& status) {
  if (S_ISLNK(status.st_mode)) return Entry::link;
  if (S_ISDIR(status.st_mode)) return Entry::folder;
  return S_ISREG(status.st_mode) ? Entry::file : Entry::other;
}

}  // namespace

bool is_folder(const std::string& path) {
  sys::Status status;
  return sys::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

bool exists(const std::string& path) {
  sys::Status status;
  return sys::stat(path.c_str(), &status) == 0;
}

bool is_plain_file(const std::string& path) {
  sys::Status status;
  return sys::lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

bool is_link(const std::string& path) {
  sys::Status status;
  return sys::lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode);
}

bool has_entry(const std::string& path) {
  sys::Status status;
  return sys::lstat(path.c_str(), &status) == 0;
}

bool is_same(const std::string& path, const std::string& other) {
  sys::Status status;
  sys::Status other_status;
  return sys::stat(path.c_str(), &status) == 0 && sys::stat(other.c_str(), &other_status) == 0 &&
         status.st_dev == other_status.st_dev && status.st_ino == other_status.st_ino;
}

std::optional<std::string> current_folder(std::error_code& error) {
  error.clear();
  return sys::with_drive(".");
}

std::string absolute(const std::string& path) { return sys::with_drive(path); }

std::optional<std::string> canonical(const std::string& path) { return sys::real_path(path); }

std::optional<std::string> weakly_canonical(const std::string& path) {
  const std::string place = sys::with_drive(path);
  std::string_view there = place;
  while (there.size() > 1) {
    if (auto real = sys::real_path(std::string(there))) {
      return path::normalize(*real + place.substr(there.size()));
    }
    there = path::parent(there);
  }
  return place;
}

std::optional<std::string> whole(const std::string& path) { return weakly_canonical(path); }

std::string relative(const std::string& path, const std::string& folder) {
  if (path::is_absolute(path) != path::is_absolute(folder)) return {};
  const auto to = path::names(path);
  const auto from = path::names(folder);
  const auto [first, other] = std::mismatch(to.begin(), to.end(), from.begin(), from.end());
  std::string way;
  for (auto name = other; name != from.end(); ++name) way += way.empty() ? ".." : "/..";
  for (auto name = first; name != to.end(); ++name) {
    way.append(way.empty() ? "" : "/").append(*name);
  }
  return way.empty() ? "." : way;
}

std::error_code for_each_entry(const std::string& folder,
                               const std::function<bool(std::string name, Entry kind)>& take) {
  const int opened = sys::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (opened < 0) return {errno, std::generic_category()};
  for (std::string& name : sys::names_in(opened)) {
    sys::Status status;
    if (sys::lstat(path::join(folder, name).c_str(), &status) != 0) status = {};
    if (!take(std::move(name), kind_of(status))) break;
  }
  return {};
}

}  // namespace smurf::places
