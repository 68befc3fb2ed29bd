// SPDX-License-Identifier: BSD-3-Clause
#include "common/files/new_file.hpp"

#include <array>
#include <atomic>
#include <cerrno>

namespace smurf::tools {
namespace {

/// Uses a path below /proc, because only root may link a descriptor itself.
std::string way_to(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

/// Copies an open file to another; returns 0 or an errno.
int copy_all(int from, int to) {
  std::array<char, 65536> buffer;
  for (off_t at = 0;;) {
    const ssize_t count = sys::pread(from, buffer.data(), buffer.size(), at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0 ? 0 : errno;
    const int error = write_all(to, {buffer.data(), static_cast<std::size_t>(count)});
    if (error != 0) return error;
    at += count;
  }
}

}  // namespace

int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = sys::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) {  // someone made the shared terminal or pipe non-blocking
      sys::wait_until_writable(descriptor);
      continue;
    }
    if (count < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

std::string temporary_name(int process, std::string_view rest) {
  static const std::string space = sys::process_space();
  return ".smurf-" + std::to_string(process) + "-" + space + "-" + std::string(rest) + ".tmp";
}

int with_free_name(std::string& name, const std::function<int(const std::string& name)>& make) {
  int error = EEXIST;
  static std::atomic<unsigned> next = 0;  // thousands of files may be replaced in one folder
  for (int attempt = 0; attempt < 1000 && error == EEXIST; ++attempt) {
    name = temporary_name(sys::getpid(), std::to_string(next++));
    error = make(name);
  }
  return error;
}

int NewFile::write(std::string_view text, const std::optional<sys::Status>& replaced) {
  replaced_ = replaced;
  int error = open_nameless() == 0 ? 0 : open_named();
  if (error == 0 && replaced_) error = sys::adopt_owner(file_.number(), *replaced_);
  if (error == 0) error = write_all(file_.number(), text);
  return error != 0 ? error : flush();
}

int NewFile::take_place() {
  if (temporary_.empty()) {
    int error = replaced_ ? EEXIST : link_to(name_);
    if (error == 0 || (error == EEXIST && !replaced_)) return error;
    if (error == EEXIST) {
      error = with_free_name(temporary_, [&](const std::string& name) { return link_to(name); });
    }
    if (error != 0) {  // this file system cannot name a file that had no name
      temporary_.clear();
      const Descriptor nameless = std::move(file_);
      error = open_named();
      if (error == 0 && replaced_) error = sys::adopt_owner(file_.number(), *replaced_);
      if (error == 0) error = copy_all(nameless.number(), file_.number());
      if (error == 0) error = flush();
    }
    if (error != 0) return error;
  }
  if (!replaced_) {
    if (sys::linkat(folder_, temporary_.c_str(), folder_, name_.c_str(), 0) == 0) return 0;
    if (errno == EEXIST) return errno;
  }
  if (sys::renameat(folder_, temporary_.c_str(), folder_, name_.c_str()) != 0) return errno;
  temporary_.clear();
  return 0;
}

int NewFile::open_nameless() {
#ifdef O_TMPFILE
  file_.reset(sys::openat(folder_, ".", O_TMPFILE | O_RDWR | O_CLOEXEC, 0666));
  if (!file_.is_open()) return errno;
  if (sys::Status status; sys::stat(way_to(file_.number()).c_str(), &status) == 0) return 0;
  file_.reset();
#endif
  return ENOTSUP;
}

int NewFile::open_named() {
  return with_free_name(temporary_, [&](const std::string& name) {
    constexpr int kNew = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    file_.reset(sys::openat(folder_, name.c_str(), kNew, 0666));
    if (file_.is_open()) return 0;
    const int error = errno;
    temporary_.clear();
    return error;
  });
}

int NewFile::flush() const {
  return sys::fsync(file_.number()) == 0 || errno == EINVAL ? 0 : errno;
}

int NewFile::link_to(const std::string& name) const {
  const std::string file = way_to(file_.number());
  const int failed = sys::linkat(AT_FDCWD, file.c_str(), folder_, name.c_str(), AT_SYMLINK_FOLLOW);
  return failed == 0 ? 0 : errno;
}

void NewFile::drop() {
  file_.reset();
  if (!temporary_.empty()) sys::unlinkat(folder_, temporary_.c_str(), 0);
}

}  // namespace smurf::tools
