// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "base/files/places.hpp"

namespace smurf::places {
namespace {

namespace fs = std::filesystem;

Entry kind_of(const fs::directory_entry& entry) {
  std::error_code vanished;
  if (entry.is_symlink(vanished)) return Entry::link;
  if (entry.is_directory(vanished)) return Entry::folder;
  return entry.is_regular_file(vanished) ? Entry::file : Entry::other;
}

std::optional<std::string> unless(const std::error_code& error, const fs::path& path) {
  return error ? std::nullopt : std::optional(path.string());
}

}  // namespace

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool is_plain_file(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(path, ignored));
}

bool is_link(const std::string& path) {
  std::error_code ignored;
  return fs::is_symlink(path, ignored);
}

bool has_entry(const std::string& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

bool is_same(const std::string& path, const std::string& other) {
  std::error_code ignored;
  return fs::equivalent(path, other, ignored);
}

std::optional<std::string> current_folder(std::error_code& error) {
  const fs::path found = fs::current_path(error);
  return unless(error, found);
}

std::string absolute(const std::string& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).string();
}

std::optional<std::string> canonical(const std::string& path) {
  std::error_code error;
  const fs::path found = fs::canonical(path, error);
  return unless(error, found);
}

std::optional<std::string> weakly_canonical(const std::string& path) {
  std::error_code error;
  const fs::path found = fs::weakly_canonical(path, error);
  return unless(error, found);
}

std::optional<std::string> whole(const std::string& path) {
  return weakly_canonical(absolute(path));
}

std::string relative(const std::string& path, const std::string& folder) {
  return fs::path(path).lexically_relative(folder).generic_string();
}

std::error_code for_each_entry(const std::string& folder,
                               const std::function<bool(std::string name, Entry kind)>& take) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    if (!take(entry->path().filename().string(), kind_of(*entry))) return {};
  }
  return error;
}

}  // namespace smurf::places
