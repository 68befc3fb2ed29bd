// SPDX-License-Identifier: BSD-3-Clause
// All tools as one program: the first argument selects the tool.
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdarg>
#include <cstddef>

#include "common/cli/tools_in_one.hpp"

// The facts about the C library on which host.mjs relies.
static_assert(offsetof(struct stat, st_dev) == 0 && offsetof(struct stat, st_mode) == 12 &&
              offsetof(struct stat, st_nlink) == 16 && offsetof(struct stat, st_uid) == 20 &&
              offsetof(struct stat, st_gid) == 24 && offsetof(struct stat, st_size) == 40 &&
              offsetof(struct stat, st_atim) == 56 && offsetof(struct stat, st_mtim) == 64 &&
              offsetof(struct stat, st_ctim) == 72 && offsetof(struct stat, st_ino) == 80);
static_assert(sizeof(dirent) == 280 && offsetof(dirent, d_off) == 8 &&
              offsetof(dirent, d_reclen) == 16 && offsetof(dirent, d_type) == 18 &&
              offsetof(dirent, d_name) == 19);
static_assert(AT_FDCWD == -100 && AT_REMOVEDIR == 0x200 && AT_SYMLINK_NOFOLLOW == 0x100);
static_assert(O_PATH == 010000000 && O_DIRECTORY == 0200000 && O_NOFOLLOW == 0400000);
static_assert(ENOENT == 44 && EXDEV == 75 && ENOTSUP == 138);

/// Called by open(). Replaces a function of Emscripten that treats only terminals as open.
extern "C" long __syscall_open(const char* path, long flags, ...) {
  va_list more;
  va_start(more, flags);
  const int mode = (flags & O_CREAT) != 0 ? va_arg(more, int) : 0;
  va_end(more);
  const int file = ::openat(AT_FDCWD, path, static_cast<int>(flags), mode);
  return file < 0 ? -errno : file;
}

/// The C library asks with it only whether a descriptor is open.
extern "C" int fcntl(int descriptor, int, ...) {
  struct stat status {};
  return ::fstat(descriptor, &status);
}

namespace {

/// Added to the exit code of a tool, to distinguish it from that of abort(), which is 1.
constexpr int kEnded = 64;

}  // namespace

int main(int argc, char** argv) {
  const auto tool = smurf::tools::find_tool(argc > 0 ? argv[0] : "");
  return tool == nullptr ? 2 : kEnded + tool(argc, argv);
}
