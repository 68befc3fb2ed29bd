// SPDX-License-Identifier: BSD-3-Clause
// Linux keeps a place without opening it (O_PATH) and tells in /proc where the place is. Elsewhere,
// or where /proc is absent, the path is looked up, and what was opened must be what was found.
#include "base/found_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <memory>
#include <string_view>

namespace smurf {
namespace {

std::string in_proc(int number) { return "/proc/self/fd/" + std::to_string(number); }

#ifdef O_PATH
constexpr bool kHasPlaces = true;
int place_of(const std::string& path) { return ::open(path.c_str(), O_PATH | O_CLOEXEC); }
#else
constexpr bool kHasPlaces = false;
int place_of(const std::string&) { return -1; }
#endif

std::optional<std::string> looked_up(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr),
                                                         &std::free);
  if (!real) return std::nullopt;
  return std::string(real.get());
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

FoundFile::FoundFile(const std::string& path) : path_(path), place_(place_of(path)) {
  if (kHasPlaces && place_.number() < 0) {
    error_ = errno;
    return;
  }
  const int result =
      kHasPlaces ? ::fstat(place_.number(), &status_) : ::stat(path.c_str(), &status_);
  if (result != 0) error_ = errno;
}

std::optional<std::string> FoundFile::real_path() const {
  std::array<char, PATH_MAX> target;
  ssize_t size = -1;
  if (kHasPlaces) {
    size = ::readlink(in_proc(place_.number()).c_str(), target.data(), target.size());
  }
  if (size < 0) {
    if (!looked_up_) looked_up_ = looked_up(path_);
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
    const int opened = ::open(in_proc(place_.number()).c_str(), kRead);
    if (opened >= 0 || errno != ENOENT) return opened;
  }
  // The judged path is opened, and must be the file that was found.
  const auto real = looked_up_ ? looked_up_ : looked_up(path_);
  const int opened = real ? ::open(real->c_str(), kRead | O_NOFOLLOW) : -1;
  struct stat status {};
  if (opened < 0 || (::fstat(opened, &status) == 0 && status.st_dev == status_.st_dev &&
                     status.st_ino == status_.st_ino)) {
    return opened;
  }
  ::close(opened);
  errno = ESTALE;
  return -1;
}

}  // namespace smurf
