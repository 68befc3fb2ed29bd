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

}  // namespace

void OpenFolder::become(int number) const {
  if (number_ >= 0) sys::close(number_);
  number_ = number;
  entered_.clear();
}

void OpenFolder::open(const std::string& path) { become(sys::open(path.c_str(), kFolder)); }

void OpenFolder::enter(const std::string& name) {
  if (is_open()) entered_ = name;
}

bool OpenFolder::is_open() const {
  if (!entered_.empty()) become(sys::openat(number_, entered_.c_str(), kFolder | O_NOFOLLOW));
  return number_ >= 0;
}

void OpenFolder::enter_above(const std::string& above) {
  if (is_open()) {
    enter("..");
  } else {
    open(above);
  }
}

bool OpenFolder::has(std::string_view name) const {
  sys::Status status{};
  return is_open() &&
         sys::fstatat(number_, std::string(name).c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
}

bool OpenFolder::has_any(std::span<const std::string_view> names) const {
  return ranges::any_of(names, [&](std::string_view name) { return has(name); });
}

std::optional<std::string> OpenFolder::target_of(const std::string& name) const {
  std::array<char, path::kLongest> target;
  const ssize_t size =
      is_open() ? sys::readlinkat(number_, name.c_str(), target.data(), target.size()) : -1;
  if (size < 0) return std::nullopt;
  return std::string(target.data(), static_cast<std::size_t>(size));
}

}  // namespace smurf
