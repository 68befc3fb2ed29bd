// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/open_folder.hpp"

#include <array>

#include "base/files/path.hpp"
#include "base/files/system.hpp"
#include "base/ranges.hpp"

namespace smurf {
namespace {

#ifdef O_PATH
constexpr int kFolder = O_PATH | O_DIRECTORY | O_CLOEXEC;
#else
constexpr int kFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
#endif

constexpr std::size_t kShort = 256;  // of a path, in bytes

}  // namespace

void OpenFolder::close() {
  if (number_ >= 0) sys::close(number_);
  number_ = AT_FDCWD;
}

void OpenFolder::open(const std::string& path) {
  close();
  rest_ = path;
  is_missing_ = path.empty();
  if (path.size() > kShort) settle();
}

void OpenFolder::settle() {
  if (is_missing_ || rest_.empty()) return;
  const int opened = sys::openat(number_, rest_.c_str(), kFolder);
  is_missing_ = opened < 0;
  close();
  if (!is_missing_) number_ = opened;
  rest_.clear();
}

std::string OpenFolder::path_of(std::string_view name) const {
  std::string path;
  path.reserve(rest_.size() + 1 + name.size());
  path = rest_;
  if (!path.empty() && !path.ends_with('/')) path += '/';
  path += name;
  return path;
}

void OpenFolder::enter(const std::string& name) {
  rest_ = path_of(name);
  if (rest_.size() > kShort) settle();
}

void OpenFolder::enter_above(const std::string& above) {
  if (above.size() > kShort) settle();
  if (above.size() > kShort && !is_missing_) {
    enter("..");
  } else {
    open(above);
  }
}

bool OpenFolder::has(std::string_view name) const {
  sys::Status status{};
  return !is_missing_ &&
         sys::fstatat(number_, path_of(name).c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
}

bool OpenFolder::has_any(std::span<const std::string_view> names) const {
  return ranges::any_of(names, [&](std::string_view name) { return has(name); });
}

std::optional<std::string> OpenFolder::target_of(const std::string& name) const {
  if (is_missing_) return std::nullopt;
  std::array<char, path::kLongest> target;
  const ssize_t size =
      sys::readlinkat(number_, path_of(name).c_str(), target.data(), target.size());
  if (size < 0) return std::nullopt;
  return std::string(target.data(), static_cast<std::size_t>(size));
}

}  // namespace smurf
