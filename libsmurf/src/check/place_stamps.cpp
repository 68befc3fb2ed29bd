// SPDX-License-Identifier: BSD-3-Clause
#include "check/place_stamps.hpp"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <string_view>

#include "base/files/path.hpp"
#include "base/files/system.hpp"
#include "base/numbers/digest.hpp"

namespace smurf {
namespace {

std::string missing(int error) { return "missing " + std::to_string(error); }

std::string text_of(const sys::Status& status) {
  // A file that was just written may change again within the resolution of its time stamps.
  constexpr std::time_t kResolution = 2;  // s
  const std::time_t last = std::max(status.st_mtim.tv_sec, status.st_ctim.tv_sec);
  if (std::time(nullptr) - last < kResolution) return {};
  const auto number = [](auto value) { return static_cast<std::int64_t>(value); };
  const std::int64_t numbers[] = {number(status.st_dev),         number(status.st_ino),
                                  number(status.st_mode),        number(status.st_size),
                                  number(status.st_mtim.tv_sec), number(status.st_mtim.tv_nsec),
                                  number(status.st_ctim.tv_sec), number(status.st_ctim.tv_nsec)};
  constexpr std::size_t kEnough = 8;  // bytes: nobody chooses all of these numbers
  return hex_of(digest_of({reinterpret_cast<const char*>(numbers), sizeof numbers}), kEnough);
}

}  // namespace

PlaceStamp PlaceStamps::of(const std::string& path) {
  const std::string name(path::file_name(path));
  const bool has_zero = path.find('\0') != std::string::npos;
  const bool is_in_folder = !name.empty() && name != "." && name != ".." && !has_zero;
  if (!is_in_folder) return linked(path);
  const std::string_view folder = path::parent(path);
  enter(folder.empty() ? "." : std::string(folder));
  if (way_ == Way::missing) return {"-", "missing"};
  if (way_ == Way::linked) return linked(path);
  sys::Status status{};
  if (sys::fstatat(opened_->number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
    return {"-", missing(errno)};
  }
  return S_ISLNK(status.st_mode) ? linked(path) : PlaceStamp{"-", text_of(status)};
}

void PlaceStamps::enter(const std::string& folder) {
  if (opened_ && folder == folder_) return;
  folder_ = folder;
  opened_.emplace(sys::open_unlinked(folder));
  way_ = opened_->number() >= 0 ? Way::unlinked : errno == ENOENT ? Way::missing : Way::linked;
}

/// A path on which there is a link, or on which it is unknown whether there is one.
PlaceStamp PlaceStamps::linked(const std::string& path) const {
  sys::Status status{};
  const bool has_zero = path.find('\0') != std::string::npos;
  const std::string at = path.empty() ? "." : path;
  const std::string text = has_zero                              ? "missing"
                           : sys::stat(at.c_str(), &status) == 0 ? text_of(status)
                                                                 : missing(errno);
  // Where the links on the way may lead is known to the reader.
  const std::string place = canonical_.of(path).value_or("");
  return {short_digest(place + (files_.is_denied(path) ? "\ndenied" : "\n")), text};
}

}  // namespace smurf
