// SPDX-License-Identifier: BSD-3-Clause
// Linux can hold a file without opening it (O_PATH); /proc contains its current path. Elsewhere, or
// without /proc, the path is looked up again, and the opened file must be the file that was found.
#include "base/files/found_file.hpp"

#include <array>
#include <cerrno>
#include <string_view>

#include "base/files/path.hpp"

namespace smurf {
namespace {

std::string in_proc(int number) { return "/proc/self/fd/" + std::to_string(number); }

#ifdef O_PATH
constexpr bool kHasPlaces = true;
int place_of(const std::string& path) { return sys::open(path.c_str(), O_PATH | O_CLOEXEC); }
#else
constexpr bool kHasPlaces = false;
int place_of(const std::string&) { return -1; }
#endif

/// The real path if no name in a path is a link.
std::optional<std::string> place_by_name(const std::string& path) {
  if (path.empty() || path.size() > path::kLongest / 2) return std::nullopt;
  if (path::is_absolute(path)) return path::normalize(path);
  const std::string here = sys::working_folder();
  return here.empty() ? std::nullopt : std::optional(path::join(here, path));
}

}  // namespace

FoundFile::Opened FoundFile::open_place(const std::string& path) {
  const int opened = sys::open_unlinked(path);
  if (opened >= 0 || errno != ELOOP) return {opened, true};
  return {place_of(path), false};
}

FoundFile::FoundFile(const std::string& path) : FoundFile(path, open_place(path)) {}

FoundFile::FoundFile(const std::string& path, Opened opened)
    : path_(path), is_unlinked_(opened.is_unlinked), place_(opened.number) {
  if (kHasPlaces && place_.number() < 0) {
    error_ = errno;
    return;
  }
  const int result =
      kHasPlaces ? sys::fstat(place_.number(), &status_) : sys::stat(path.c_str(), &status_);
  if (result != 0) error_ = errno;
  if (result == 0 && !sys::is_named_so(path)) error_ = ENOENT;
}

std::optional<std::string> FoundFile::real_path() const {
  if (is_unlinked_) {
    if (auto place = place_by_name(path_)) return place;
  }
  if (error_ != 0) return std::nullopt;
  std::array<char, path::kLongest> target;
  ssize_t size = -1;
  if (kHasPlaces) {
    size =
        sys::readlinkat(AT_FDCWD, in_proc(place_.number()).c_str(), target.data(), target.size());
  }
  if (size < 0) {
    if (!looked_up_) looked_up_ = sys::real_path(path_);
    return looked_up_;
  }
  std::string_view real(target.data(), static_cast<std::size_t>(size));
  if (!real.starts_with('/')) return std::nullopt;  // "pipe:[4711]"
  constexpr std::string_view kGone = " (deleted)";
  if (status_.st_nlink == 0 && real.ends_with(kGone)) real.remove_suffix(kGone.size());
  return std::string(real);
}

int FoundFile::open() const {
  constexpr int kRead = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
  if (kHasPlaces && !looked_up_) {
    const int opened = sys::open(in_proc(place_.number()).c_str(), kRead);
    if (opened >= 0 || errno != ENOENT) return opened;
  }
  // The judged path is opened, and must be the file that was found.
  const auto real = looked_up_ ? looked_up_ : sys::real_path(path_);
  const int opened = real ? sys::open(real->c_str(), kRead | O_NOFOLLOW) : -1;
  sys::Status status{};
  if (opened < 0 || (sys::fstat(opened, &status) == 0 && status.st_dev == status_.st_dev &&
                     status.st_ino == status_.st_ino)) {
    return opened;
  }
  sys::close(opened);
  errno = ESTALE;
  return -1;
}

}  // namespace smurf
